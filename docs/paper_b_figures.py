"""Paper B's figures, from its island: ./dev run python docs/paper_b_figures.py

Each into docs/images/paper_b_*.jpg, under the number of the paper's own figure.
"""

import numpy as np
import orogen
from orogen.pictures import hillshade
from pictures import IMAGES
from PIL import Image, ImageDraw

SIZE, CELLS, SIDE, SEED = 40e3, 384, 380, 3
SEA, LAKE, LAND = (96, 132, 168), (120, 172, 208), (214, 202, 168)
EXTENT = {"origin": [0, 0], "size": [SIZE, SIZE]}
BIOMES = orogen.island.biomes()
BIOME_COLOURS = np.array([[b["color"] >> s & 255 for s in (16, 8, 0)] for b in BIOMES])


def grown(stages, **more):
    document = {"orogen": 1, "seed": SEED, "resolution": CELLS, "extent": EXTENT, **more}
    return orogen.generate(orogen.Recipe.from_dict({**document, "stages": stages}))


# --- the polygon map -----------------------------------------------------------------------------


def pixel(points):
    places = np.asarray(points) / SIZE * SIDE
    return [(float(x), float(SIDE - y)) for x, y in places]


def polygons(island, colours):
    """The map's cells in a colour each."""
    image = Image.new("RGB", (SIDE, SIDE), "white")
    draw, (first, corners) = ImageDraw.Draw(image), island.map.center_corners
    for k, colour in enumerate(colours):
        outline = pixel(island.map.corners[corners[first[k] : first[k + 1]]])
        draw.polygon(outline, fill=tuple(int(v) for v in colour), outline=(90, 90, 90))
    return image


def ramp(values, low, high):
    t = np.clip(values, 0.0, 1.0)[:, None]
    return (1 - t) * np.array(low) + t * np.array(high)


def on_land(island, colours):
    sea = np.asarray(island.center_ocean)[:, None] > 0
    lake = (np.asarray(island.center_water)[:, None] > 0) & ~sea
    return np.where(sea, SEA, np.where(lake, LAKE, colours))


def graph(island):
    """Figure 1: centers red, their joins grey; corners blue, sides of cells black."""
    image = Image.new("RGB", (SIDE, SIDE), "white")
    draw, map_ = ImageDraw.Draw(image), island.map
    for a, b in map_.edge_centers:
        if min(a, b) >= 0:
            draw.line(pixel(map_.centers[[a, b]]), fill=(200, 200, 200))
    for ends in map_.edge_corners:
        draw.line(pixel(map_.corners[ends]), fill=(60, 60, 60))
    for points, colour in ((map_.centers, (200, 40, 40)), (map_.corners, (40, 80, 200))):
        for x, y in pixel(points):
            draw.ellipse((x - 1.5, y - 1.5, x + 1.5, y + 1.5), fill=colour)
    return image


def rivers(island, image):
    draw = ImageDraw.Draw(image)
    for ends, volume in zip(island.map.edge_corners, island.edge_river, strict=True):
        if volume > 0:
            line = pixel(island.map.corners[ends])
            draw.line(line, fill=(30, 80, 190), width=1 + int(np.sqrt(volume)) // 2)
    return image


def polygon_map():
    grid = orogen.Grid(CELLS, CELLS, SIZE / CELLS, (0.0, 0.0))
    few = orogen.island.make_island(grid, seed=SEED, cells=120)
    many = orogen.island.make_island(grid, seed=SEED, cells=1500)
    height = np.asarray(many.center_elevation)
    yield "1_map", [graph(few)]
    ground = np.where(
        height[:, None] < 0,
        ramp(-height, SEA, (30, 50, 90)),
        on_land(many, ramp(height, (84, 120, 70), (245, 240, 235))),
    )
    warmth = on_land(many, ramp(many.center_temperature, (70, 90, 190), (230, 90, 50)))
    moist = on_land(many, ramp(many.center_moisture, (226, 206, 150), (40, 110, 70)))
    yield (
        "2_island",
        [
            polygons(many, on_land(many, np.full((len(height), 3), LAND))),
            polygons(many, ground),
            polygons(many, warmth),
            rivers(many, polygons(many, moist)),
            polygons(many, BIOME_COLOURS[many.biomes]),
        ],
    )


# --- curves, water, biomes -----------------------------------------------------------------------


def seen(terrain, heights=None, colours=(228, 220, 200), water=None, part=np.s_[:, :]):
    """From above, lit from the north-west; water in metres over it."""
    heights = np.asarray(terrain["elevation"] if heights is None else heights)
    image = hillshade(heights, terrain.grid.cell_size)[..., None] * np.asarray(colours)
    image = np.where((heights <= 0)[..., None], SEA, image)
    if water is not None:
        share = np.clip(water / 8.0, 0.0, 1.0)[..., None] * (heights > 0)[..., None]
        image = (1 - share) * image + share * np.array([40, 90, 200])
    return square(image[part])


def square(image):
    pixels = np.asarray(image)[::-1].clip(0, 255).astype(np.uint8)
    return Image.fromarray(pixels).resize((SIDE, SIDE), Image.Resampling.LANCZOS)


def curve(points, plateau, slope, angle, envelope):
    side = {"slope_size": slope, "slope_angle_deg": angle, "envelope": envelope}
    return {"points": [{"position": p, "plateau": plateau, "sides": side} for p in points]}


def given(heights, *stages, **more):
    stages = [{"stage": name} for name in ("given_elevation", *stages)]
    return grown(stages, rasters={"elevation": heights}, **more)


def plane(features):
    return given([[400.0]], "feature_curves", features=features)


def cone():
    """A hill in the sea, with humps."""
    x, y = np.meshgrid(*[np.linspace(-1, 1, CELLS)] * 2)
    humps = sum(np.cos(k * (x * np.cos(k) + y * np.sin(k)) + k) / k for k in range(5, 22, 2))
    return orogen.pack_raster(1500 - 1900 * np.hypot(x, y) + 500 * humps)


HILLS = [[8e3, 12e3, 1300], [20e3, 24e3, 2000], [33e3, 20e3, 1200]]


def curves():
    yield (
        "3_curves",
        [
            seen(plane([curve(HILLS, 300, *side)]))
            for side in ((0, 0, 6e3), (2500, 20, 4e3), (500, 55, 1500))
        ],
    )
    mountain = curve([[12e3, 20e3, 1900], [13e3, 21e3, 1900]], 200, 3e3, 22, 2e3)
    line = [[21e3, 6e3, 1200], [21e3, 34e3, 1200]]
    wide, narrow = (curve(line, 300, 800, 30, envelope) for envelope in (9e3, 1500))
    yield "5_envelope", [seen(plane(f)) for f in ([mountain], [mountain, wide], [mountain, narrow])]


def storm(terrain, units, **more):
    cell = terrain.grid.cell_size
    setting = orogen.erosion.paper_b_setting(cell, 2000.0, units)
    fields = {name: terrain[name] for name in ("moisture", "temperature") if name in terrain}
    return orogen.erosion.erode_virtual_pipes(
        terrain["elevation"], cell, land=terrain["land"], **{**fields, **setting, **more}
    )


def erosion():
    hill = given(cone())
    bed = orogen.erosion.erode_virtual_pipes(
        hill["elevation"],
        hill.grid.cell_size,
        land=hill["land"],
        sources=[(0.56 * SIZE, 0.54 * SIZE, 2000.0)],
        rain_rate_mm_per_h=0.0,
        evaporation_rate=0.0,
        duration=20 * 3600.0,
    )
    part = np.s_[CELLS // 3 : 5 * CELLS // 6, CELLS // 2 :]
    yield (
        "6_river",
        [
            seen(hill, part=part),
            seen(hill, bed.elevation, water=4 * bed.water_depth, part=part),
            seen(hill, bed.elevation, part=part),
        ],
    )
    island = grown([{"stage": "island"}])
    running, done = storm(island, 1.0), storm(island, 2.0)
    change = (np.asarray(done.deposition) - np.asarray(done.wear)) / 200.0
    grey = 128 + 127 * np.clip(change, -1, 1)[..., None] * np.ones(3)
    yield (
        "7_mountains",
        [
            seen(island),
            seen(island, running.elevation, water=running.water_depth),
            square(grey),
            seen(island, done.elevation),
        ],
    )
    yield "9_biomes", [seen(island, colours=BIOME_COLOURS[island["biome"]])]


def main():
    for name, images in [*polygon_map(), *curves(), *erosion()]:
        strip = Image.new("RGB", ((SIDE + 8) * len(images) - 8, SIDE), "white")
        for i, image in enumerate(images):
            strip.paste(image, ((SIDE + 8) * i, 0))
        strip.save(IMAGES / f"paper_b_{name}.jpg", quality=88)
        print(name, flush=True)


if __name__ == "__main__":
    main()
