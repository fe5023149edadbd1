"""The pictures of the pages on collisions: ./dev run python docs/collision_pictures.py

One range between two plates, and the gestures of a small one, into docs/images/.
"""

import copy

import numpy as np
import orogen
from orogen.pictures import hillshade
from pictures import IMAGES, shaded
from PIL import Image, ImageDraw

RESOLUTION = 720
RECIPE = {
    "orogen": 1,
    "name": "two plates",
    "extent": {"origin": [0, 0], "size": [90e3, 60e3]},
    "resolution": RESOLUTION,
    "phases": [
        {
            "years": 5e6,
            "plates": [
                {
                    "name": "south",
                    "points": [[-40e3, -40e3], [130e3, -40e3], [130e3, -2e3], [-40e3, -2e3]],
                    "arrows": [[0, 9e3]] * 4,
                },
                {
                    "name": "north",
                    "points": [[-40e3, 56e3], [130e3, 56e3], [130e3, 90e3], [-40e3, 90e3]],
                    "arrows": [[0, 0]] * 4,
                },
            ],
        }
    ],
    "column": {"preset": "alps"},
    "stages": [
        {"stage": "collision"},
        {"stage": "fold_layers"},
        {
            "stage": "mountain_growth",
            "parameters": {"west_side": "closed", "east_side": "closed"},
        },
        {"stage": "rock_detail"},
        {"stage": "outcrop"},
    ],
}
FORELAND = copy.deepcopy(RECIPE)
FORELAND["extent"]["size"] = [90e3, 90e3]
FORELAND["resolution"] = 480
for _plate, _edges in zip(
    FORELAND["phases"][0]["plates"], ((-40e3, 24e3), (66e3, 130e3)), strict=True
):
    _plate["points"] = [[x, y] for y in _edges for x in (-40e3, 130e3)]
FORELAND["stages"][2]["parameters"] = {
    "east_side": "closed",
    "south_side": "closed",
    "north_side": "closed",
    "initial_relief": 5.0,
    "soft_erodibility": 8e-6,
    "hard_erodibility": 2.4e-6,
    "deposition_coefficient": 1.0,
    "sediment_erodibility_factor": 0.5,
}
GESTURES = {
    "orogen": 1,
    "extent": {"origin": [0, 0], "size": [100e3, 100e3]},
    "resolution": 360,
    "phases": [
        {
            "plates": [
                {
                    "points": [[12e3, 10e3], [80e3, 8e3], [88e3, 24e3], [45e3, 32e3], [15e3, 26e3]],
                    "arrows": [[0, 9e3], [0, 9e3], [-1e3, 9e3], [-1e3, 9e3], [0, 9e3]],
                },
                {
                    "points": [[10e3, 76e3], [50e3, 70e3], [90e3, 78e3], [88e3, 92e3], [9e3, 92e3]],
                    "arrows": [[0, 0]] * 5,
                },
            ],
        }
    ],
    "stages": [{"stage": "collision"}],
}
SECTION = {"line": [(45e3, 1e3), (45e3, 59e3)], "base": -3000.0}


def scaled(values, colour):
    """White at 0, `colour` at the greatest."""
    t = np.clip(values / max(float(values.max()), 1e-12), 0.0, 1.0)[..., None]
    return 245.0 + t * (np.asarray(colour, np.float32) - 245.0)


def strata(terrain):
    rgb = terrain["strata_color"][..., None] >> np.array([16, 8, 0]) & 255
    light = 0.35 + 0.85 * hillshade(terrain["elevation"], terrain.grid.cell_size)
    return rgb * light[..., None]


def section(terrain):
    """The section, four times as tall as it is long, under a white sky."""
    cut = terrain.rocks.section(**SECTION)
    top = float(cut.surface.max()) + 200.0
    width = 1160
    height = int(4 * width * (top - cut.base) / cut.distance[-1])
    rgba = cut.picture(width, height, top)
    alpha = rgba[..., 3:] / 255.0
    return (rgba[..., :3] * alpha + 255.0 * (1.0 - alpha))[::-1]


def gestures(terrain):
    """Compression beside uplift, with the hulls of the gestures and their arrows."""
    halves = []
    for name in ("compression", "crust_uplift_rate"):
        colours = scaled(terrain[name], (150, 60, 40))[::-1]
        image = Image.fromarray(np.clip(colours + 0.5, 0, 255).astype(np.uint8))
        draw = ImageDraw.Draw(image)
        for plate in GESTURES["phases"][0]["plates"]:
            hull = [pixel(terrain, p) for p in plate["points"]]
            draw.line([*hull, hull[0]], fill=(40, 60, 110), width=2)
            for (x, y), (dx, dy) in zip(plate["points"], plate["arrows"], strict=True):
                draw.line([pixel(terrain, (x, y)), pixel(terrain, (x + dx, y + dy))], "black", 2)
        halves += [np.asarray(image), np.full((image.height, 12, 3), 255)]
    return np.concatenate(halves[:-1], 1)[::-1]


def pixel(terrain, place):
    cell = terrain.grid.cell_size
    return place[0] / cell, terrain.grid.shape[0] - place[1] / cell


def foreland(terrain):
    relief = shaded(terrain["elevation"], terrain.grid.cell_size)
    return np.concatenate([relief, np.full((len(relief), 12, 3), 255), strata(terrain)], 1)


def pictures(terrain):
    yield "gestures", gestures(orogen.generate(GESTURES))
    yield "fold_layers", scaled(terrain["fold_uplift_rate"], (90, 60, 30))
    yield "mountain_growth", shaded(terrain["elevation"], terrain.grid.cell_size)
    yield "outcrop", strata(terrain)
    yield "section", section(terrain)
    yield "foreland", foreland(orogen.generate(FORELAND))


def main():
    IMAGES.mkdir(exist_ok=True)
    for name, colours in pictures(orogen.generate(RECIPE)):
        image = Image.fromarray(np.clip(colours + 0.5, 0, 255).astype(np.uint8)[::-1])
        image.quantize(96).save(IMAGES / f"collision_{name}.png", optimize=True)


if __name__ == "__main__":
    main()
