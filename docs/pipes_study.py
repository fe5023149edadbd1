"""The study of hydraulic erosion's parameters: ./dev run python docs/pipes_study.py

One parameter of paper B's setting at a time, on an island, into
docs/theory/pipes_study_table.md and docs/images/pipes_study_*.jpg.
"""

import numpy as np
import orogen
from orogen.pictures import hillshade
from pictures import IMAGES, signed
from PIL import Image, ImageDraw

TABLE = IMAGES.parent / "theory" / "pipes_study_table.md"
CELLS, SIZE, HEIGHT, UNITS = 320, 40e3, 2000.0, 3.0
CHANGE = 0.05  # of HEIGHT, at which a picture's colours are full
FACTORS = {  # of paper B's setting, by what they scale; the middle one is 1
    "time_step": (0.25, 0.5, 1.0, 4.0, 12.0),
    "duration": (0.1, 0.3, 1.0, 3.0, 10.0),
    "rain_rate_mm_per_h": (0.1, 0.3, 1.0, 3.0, 10.0),
    "drop_probability": (0.001, 0.01, 1.0),
    "evaporation_rate": (0.0, 0.1, 1.0, 10.0, 100.0),
    "sediment_capacity": (0.1, 0.3, 1.0, 3.0, 10.0),
    "rates": (0.1, 0.3, 1.0, 3.0, 10.0),
    "min_slope": (0.0, 1.0, 5.0, 20.0),
    "max_slope": (0.05, 0.2, 1.0, 5.0),
    "halving_depth": (0.1, 0.3, 1.0, 10.0, 0.0),
    "max_change": (0.1, 0.3, 1.0, 10.0),
    "drag_coefficient": (0.0, 0.001, 0.01, 0.1, 1.0),  # itself: the paper has none
}
HEAD = (
    "| parameter | factor | steps | mean wear, % | deepest, % | highest fill, % | roughness "
    "| land grown, cells |\n|---|---|---|---|---|---|---|---|"
)
TOGETHER = {
    "rates": ("sediment_dissolution_rate", "rock_dissolution_rate", "deposition_rate"),
    "halving_depth": ("erosion_halving_depth", "deposition_halving_depth"),
}


def island():
    recipe = {
        "orogen": 1,
        "seed": 3,
        "resolution": CELLS,
        "extent": {"origin": [0, 0], "size": [SIZE, SIZE]},
        "stages": [{"stage": "island"}],
    }
    return orogen.generate(orogen.Recipe.from_dict(recipe))


def eroded(terrain, name, factor):
    cell = terrain.grid.cell_size
    setting = orogen.erosion.paper_b_setting(cell, HEIGHT, UNITS)
    for parameter in TOGETHER.get(name, (name,)):
        setting[parameter] = factor if name == "drag_coefficient" else setting[parameter] * factor
    return orogen.erosion.erode_virtual_pipes(
        terrain["elevation"],
        cell,
        land=terrain["land"],
        moisture=terrain["moisture"],
        temperature=terrain["temperature"],
        **setting,
    )


def roughness(heights, land):
    """Root mean square of a cell's height above the mean of its four neighbours, in metres."""
    z = np.asarray(heights, float)
    around = (z[:-2, 1:-1] + z[2:, 1:-1] + z[1:-1, :-2] + z[1:-1, 2:]) / 4
    return float(np.sqrt(np.mean((z[1:-1, 1:-1] - around)[land[1:-1, 1:-1]] ** 2)))


def row(terrain, name, factor, run):
    land = np.asarray(terrain["land"]) > 0
    before = roughness(terrain["elevation"], land)
    grown = np.count_nonzero((np.asarray(run.elevation) > 0) & ~land)
    return (
        f"| `{name}` | {factor:g} | {run.steps} | {100 * run.wear[land].mean() / HEIGHT:.2f} "
        f"| {100 * run.wear.max() / HEIGHT:.1f} | {100 * run.deposition.max() / HEIGHT:.1f} "
        f"| {roughness(run.elevation, land) / before:.2f} | {grown} |"
    )


def picture(terrain, run, said):
    """The part in the middle: shaded ground, blue where it was worn, red where laid down."""
    part = (slice(CELLS // 4, 3 * CELLS // 4),) * 2
    heights = np.asarray(run.elevation)
    change = (np.asarray(run.deposition) - np.asarray(run.wear)) / HEIGHT
    shade = hillshade(heights, terrain.grid.cell_size)[..., None]
    colours = np.where((heights <= 0)[..., None], (150, 182, 196), signed(change, CHANGE) * shade)
    image = Image.fromarray(colours[part][::-1].clip(0, 255).astype(np.uint8)).resize((240, 240))
    ImageDraw.Draw(image).text((6, 4), said, fill=(20, 20, 20))
    return image


def main():
    terrain, rows = island(), []
    for name, factors in FACTORS.items():
        strip = Image.new("RGB", (244 * len(factors) - 4, 240), "white")
        for i, factor in enumerate(factors):
            run = eroded(terrain, name, factor)
            rows.append(row(terrain, name, factor, run))
            print(rows[-1], flush=True)
            strip.paste(picture(terrain, run, f"{name} x {factor:g}"), (244 * i, 0))
        strip.save(IMAGES / f"pipes_study_{name}.jpg", quality=88)
    TABLE.write_text("\n".join([HEAD, *rows]) + "\n")


if __name__ == "__main__":
    main()
