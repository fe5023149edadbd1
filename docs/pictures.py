"""The pictures of the theory pages: ./dev run python docs/pictures.py

One a stage, of Corsica, into docs/images/.
"""

from pathlib import Path

import numpy as np
import orogen
from orogen.pictures import hillshade
from PIL import Image

IMAGES = Path(__file__).resolve().parent / "images"
RESOLUTION = 640
SEA = np.array([150, 182, 196], np.float32)
PLATES = np.array(
    [[222, 184, 135], [143, 188, 143], [176, 196, 222], [221, 160, 160], [240, 230, 140],
     [188, 170, 210], [152, 203, 200], [230, 190, 160]],
    np.float32,
)  # fmt: skip


def shaded(heights, cell, colour=(238, 230, 214)):
    return hillshade(heights, cell)[..., None] * np.asarray(colour, np.float32)


def plates(terrain):
    colours = PLATES[terrain["plate"] % len(PLATES)]
    return np.where(terrain["boundary_distance"][..., None] < 600.0, 60.0, colours)


def signed(values, limit):
    """Red above 0, blue below, white at 0."""
    t = np.clip(values / limit, -1.0, 1.0)[..., None]
    red, blue = np.array([190, 60, 40]), np.array([50, 90, 170])
    return 245 + np.maximum(t, 0) * (red - 245) + np.maximum(-t, 0) * (blue - 245)


def erosion(terrain):
    return signed(terrain["deposition"] - terrain["wear"], 10.0)


def pictures(terrain):
    cell = terrain.grid.cell_size
    yield "plates", plates(terrain)
    yield "boundaries", signed(terrain["convergence"], 1.0)
    for name, field in (
        ("folds", "fold_relief"),
        ("watershed", "watershed_elevation"),
        ("combination", "combined_relief"),
        ("law", "elevation"),
    ):
        yield name, shaded(terrain[field], cell)
    wet = np.clip((np.log10(np.maximum(terrain["drainage_area"], 1.0)) - 4.5) / 4.5, 0.0, 1.0)
    yield "growth", 235.0 - wet[..., None] * (235.0 - np.array([20, 70, 130]))
    yield "pipes", erosion(terrain)


CLIMATE = (
    {"stage": "lakes"},
    {"stage": "climate", "parameters": {"sea_level_temperature": 16}},
    {"stage": "biomes", "parameters": {"classification": "whittaker"}},
    {"stage": "vegetation"},
)


def ramp(values, low, high):
    t = np.clip(values, 0.0, 1.0)[..., None]
    return (1.0 - t) * np.array(low) + t * np.array(high)


def climate(terrain):
    """Rain, biomes and trees, side by side."""
    cell, colors = terrain.grid.cell_size, [b["color"] for b in orogen.island.biomes()]
    biome = np.array(colors)[terrain["biome"]][..., None] >> np.array([16, 8, 0]) & 255
    rain = ramp(terrain["rainfall"] / 3.0, (250, 245, 220), (30, 70, 150))
    trees = ramp(terrain["tree_density"] / 500.0, (214, 204, 160), (38, 84, 40))
    light = 0.4 + 0.8 * hillshade(terrain["elevation"], cell)[..., None]
    land = (terrain["land"] == 1)[..., None]
    return np.hstack([np.where(land, light * part, SEA) for part in (rain, biome, trees)])


def main():
    IMAGES.mkdir(exist_ok=True)
    document = orogen.Recipe.load("corsica").to_dict()
    living = orogen.generate({**document, "stages": [*document["stages"], *CLIMATE]}, RESOLUTION)
    image = Image.fromarray(np.clip(climate(living) + 0.5, 0, 255).astype(np.uint8)[::-1])
    image.quantize(128).save(IMAGES / "stage_climate.png", optimize=True)
    terrain = orogen.generate("corsica", resolution=RESOLUTION)
    sea = terrain["land"] == 0
    for name, colours in pictures(terrain):
        colours = np.array(np.broadcast_to(colours, (*sea.shape, 3)), np.float32)
        colours[sea] = SEA
        image = Image.fromarray(np.clip(colours + 0.5, 0, 255).astype(np.uint8)[::-1])
        image.quantize(128).save(IMAGES / f"stage_{name}.png", optimize=True)


if __name__ == "__main__":
    main()
