"""The pictures of the gallery: ./dev run python docs/gallery.py [NAME...]

One of each recipe that ships, into docs/images/: maps from above, colliding plates as blocks that
are cut open across the range.
"""

import sys

import numpy as np
import orogen
from orogen.pictures import draw, draw_strata, hillshade
from pictures import IMAGES
from PIL import Image

RESOLUTION = 900
QUALITY = 82
LARGEST = 250_000  # bytes
VIEW_DEG = 38.0  # how steeply the eye looks down
SKY = np.array([246.0, 246.0, 244.0])
SOUTH = ("andes", "cirque")  # seen from the south; the others from the west
LEFT_OUT = {"cirque": 0.45}  # in front of the section, over the depth of the land


def seen_from_west(array):
    """A field as it lies before someone in the west: row 0 nearest, column 0 in the north."""
    return np.swapaxes(array, 0, 1)[:, ::-1]


def outcrop(terrain, first):
    """Heights and shaded colours of the rocks at the surface, from the section on."""
    turn = np.asarray if terrain.name in SOUTH else seen_from_west
    z = turn(terrain["elevation"]).astype(np.float64)
    seen = slice(first, first + z.shape[1])  # no deeper than wide
    z, color = z[seen], turn(terrain["strata_color"])[seen]
    light = 0.35 + 0.85 * hillshade(z, terrain.grid.cell_size)
    rgb = (color[..., None] >> np.array([16, 8, 0])) & 255
    return z, np.clip(rgb * light[..., None], 0, 255)


def section(terrain, first, base):
    """The rocks along the nearest row, from left to right."""
    grid = terrain.grid
    west, south = grid.origin
    east, north = west + grid.nx * grid.cell_size, south + grid.ny * grid.cell_size
    away = first * grid.cell_size
    if terrain.name in SOUTH:
        line = [(west, south + away), (east, south + away)]
    else:
        line = [(west + away, north), (west + away, south)]
    return terrain.rocks.section(line, base=base)


def block(terrain):
    """The land from above and before, over the section along its nearest row."""
    first = int(LEFT_OUT.get(terrain.name, 0.0) * min(terrain.grid.shape))
    z, colours = outcrop(terrain, first)
    cell, (depth, width) = terrain.grid.cell_size, z.shape
    relief = float(z.max() - z.min())
    stretch = np.clip(0.1 * width * cell / relief, 1.0, 3.0)
    down, up = np.sin(np.radians(VIEW_DEG)), stretch * np.cos(np.radians(VIEW_DEG)) / cell
    lowest = float(z[0].min())
    wall = 1.2 * relief  # m of rock that the section shows
    height_at = np.arange(depth)[:, None] * down + (z - lowest + wall) * up  # pixels
    horizon = np.maximum.accumulate(height_at, axis=0)
    rows = int(horizon.max()) + 12
    picture = np.empty((rows, width, 3))
    picture[:] = SKY
    at = np.arange(rows) + 0.5
    for column in range(width):
        place = np.searchsorted(horizon[:, column], at)
        seen = place < depth
        picture[seen, column] = colours[place[seen], column]
    top = float(z[0].max()) + 1.0
    rock = section(terrain, first, lowest - wall)
    cut = rock.picture(width, max(int(round((top - lowest + wall) * up)), 1), top)[::-1]
    cut = cut[:rows]
    inside = (cut[..., 3] > 0) & (at[: len(cut), None] < horizon[0])
    picture[: len(cut)][inside] = cut[inside, :3] * 0.93
    return picture


def living(terrain, shade, colours):
    """Land in the colours of its biomes, darker under trees."""
    table = np.array([b["color"] for b in orogen.island.biomes()])[terrain["biome"]]
    rgb = ((table[..., None] >> np.array([16, 8, 0])) & 255) * (0.4 + 0.85 * shade)[..., None]
    rgb = rgb * (1.0 - 0.25 * np.clip(terrain["tree_density"] / 600.0, 0.0, 1.0)[..., None])
    sea = terrain["biome"] == [b["name"] for b in orogen.island.biomes()].index("ocean")
    return np.where(sea[..., None], colours, rgb)


def from_above(terrain):
    """A map's land and sea; in the colours of its biomes or rocks, where it has some."""
    shade, colours = draw(terrain)
    if "biome" in terrain:
        return living(terrain, shade, colours)
    if "strata_color" not in terrain:
        return colours
    land = (terrain["land"] == 1)[..., None]
    return np.where(land, draw_strata(terrain, shade), colours).astype(np.float64)


def picture_of(name):
    terrain = orogen.generate(name, resolution=RESOLUTION, cache=None)
    is_map = "land" in terrain or "biome" in terrain
    colours = from_above(terrain) if is_map else block(terrain)
    return Image.fromarray(np.clip(colours + 0.5, 0, 255).astype(np.uint8)[::-1])


def save(image, file):
    """As a JPEG of the best quality within the allowed size."""
    for quality in range(QUALITY, 20, -6):
        image.save(file, quality=quality, optimize=True, progressive=True)
        if file.stat().st_size <= LARGEST:
            return
    raise RuntimeError(f"{file}: more than {LARGEST} bytes")


def main(names):
    IMAGES.mkdir(exist_ok=True)
    for name in names or orogen.shipped():
        save(picture_of(name), IMAGES / f"gallery_{name}.jpg")


if __name__ == "__main__":
    main(sys.argv[1:])
