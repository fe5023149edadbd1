"""Pictures of a terrain: shaded relief, and relief in colours with water."""

import os

import numpy as np

LARGEST = 2048  # pixels along the longer side

# Height over the highest point: colour (sRGB).
_LAND = (
    (0.00, (104, 138, 92)),
    (0.06, (126, 152, 98)),
    (0.18, (166, 172, 116)),
    (0.35, (190, 174, 126)),
    (0.55, (164, 134, 104)),
    (0.75, (138, 116, 104)),
    (0.90, (190, 184, 182)),
    (1.00, (244, 244, 246)),
)
# Depth in metres: colour.
_SEA = (
    (0.0, (158, 198, 206)),
    (30.0, (128, 178, 196)),
    (130.0, (92, 146, 176)),
    (600.0, (56, 104, 148)),
    (2500.0, (30, 64, 110)),
)
_RIVER = (52, 104, 150)
_RIVER_AREA_KM2 = 25.0  # drainage area from which a channel is drawn


def save_pictures(terrain, folder):
    """Writes hillshade.png, preview.png and, where rocks crop out, strata.png."""
    from PIL import Image

    shade, colours = draw(terrain)
    Image.fromarray((shade * 255.0 + 0.5).astype(np.uint8)[::-1]).save(
        os.path.join(folder, "hillshade.png")
    )
    Image.fromarray(colours[::-1]).save(os.path.join(folder, "preview.png"))
    if "strata_color" in terrain:
        strata = draw_strata(terrain, shade)
        Image.fromarray(strata[::-1]).save(os.path.join(folder, "strata.png"))


def draw(terrain):
    """Shaded relief in [0, 1], and coloured relief as (ny, nx, 3) bytes; row 0 in the south."""
    factor = _shrinking(terrain)
    cell = terrain.grid.cell_size * factor
    z = _block_means(terrain["elevation"], factor)
    shade = hillshade(z, cell)
    return shade, _colour(terrain, z, shade, cell, factor)


def draw_strata(terrain, shade):
    """The colours of the rocks at the surface, shaded, as (ny, nx, 3) bytes."""
    factor, color = _shrinking(terrain), terrain["strata_color"]
    rgb = [_block_means(color >> shift & 255, factor) for shift in (16, 8, 0)]
    lit = np.stack(rgb, -1) * (0.35 + 0.85 * shade)[..., None]
    return np.clip(lit + 0.5, 0.0, 255.0).astype(np.uint8)


def _shrinking(terrain):
    """Cells along a pixel's side."""
    return -(-max(terrain.grid.shape) // LARGEST)


def hillshade(z, cell, exaggeration=None):
    """Light from the north-west on diffuse ground, with fill light from either side.

    Each light counts most where the ground faces across it (R. Mark 1992, multi-directional,
    oblique-weighted shading), so that no direction of ridges goes unseen.
    """
    z = np.asarray(z, np.float32)
    if min(z.shape) < 2:
        return np.full(z.shape, 0.7, np.float32)
    if exaggeration is None:
        exaggeration = float(np.clip((cell / 60.0) ** 0.4, 1.0, 3.0))
    dy, dx = np.gradient(z, cell / exaggeration)
    slope = np.arctan(np.hypot(dx, dy))
    aspect = np.arctan2(-dy, -dx)  # the way the ground faces, from east, anticlockwise
    altitude = np.radians(40.0)
    light = np.zeros_like(z)
    weights = np.zeros_like(z)
    for azimuth, share in ((225.0, 0.4), (270.0, 0.8), (315.0, 2.0), (360.0, 0.8)):
        towards = np.radians(90.0 - azimuth)
        lit = np.sin(altitude) * np.cos(slope)
        lit = lit + np.cos(altitude) * np.sin(slope) * np.cos(aspect - towards)
        weight = share * (0.35 + np.sin(aspect - towards) ** 2)
        light += weight * np.maximum(lit, 0.0)
        weights += weight
    return np.clip(light / weights * 1.12, 0.0, 1.0).astype(np.float32)


def _colour(terrain, z, shade, cell, factor):
    sea = z <= 0.0
    if "land" in terrain:
        sea = _block_means(terrain["land"], factor) < 0.5
    top = max(float(z.max(initial=0.0)), 1.0)
    ground = _ramp(np.maximum(z, 0.0) / top, _LAND)
    floor = _ramp(np.maximum(-z, 0.0), _SEA)
    # Hollows are darker than crests, as under an open sky.
    sky = np.clip((z - _blurred(z, max(1, int(round(1500.0 / cell))))) / (0.16 * top), -1.0, 1.0)
    lit = (0.28 + 0.92 * shade) * (1.0 + 0.16 * sky)
    land = ground * lit[..., None]
    water = floor * (0.86 + 0.2 * shade)[..., None]
    picture = np.where(sea[..., None], water, land)
    picture = _draw_rivers(terrain, picture, sea, cell, factor)
    return np.clip(picture + 0.5, 0.0, 255.0).astype(np.uint8)


def _draw_rivers(terrain, picture, sea, cell, factor):
    strength = np.zeros(sea.shape, np.float32)
    if "drainage_area" in terrain:
        area = _block_max(terrain["drainage_area"], factor) * 1e-6
        strength = np.clip(np.log10(np.maximum(area, 1e-9) / _RIVER_AREA_KM2) + 0.35, 0.0, 1.0)
    if "river" in terrain:
        strength = np.maximum(strength, 0.75 * (_block_max(terrain["river"], factor) > 0))
    strength = np.where(sea, 0.0, strength)[..., None] * min(1.0, (cell / 60.0))
    return picture * (1.0 - 0.8 * strength) + np.array(_RIVER) * (0.8 * strength)


def _ramp(values, table):
    at = [row[0] for row in table]
    return np.stack([np.interp(values, at, [row[1][c] for row in table]) for c in range(3)], -1)


def _blocks(array, factor):
    ny, nx = (-(-n // factor) * factor for n in array.shape)
    padded = np.pad(array, ((0, ny - array.shape[0]), (0, nx - array.shape[1])), mode="edge")
    return padded.reshape(ny // factor, factor, nx // factor, factor)


def _block_means(array, factor):
    return np.asarray(array, np.float32) if factor == 1 else _blocks(array, factor).mean((1, 3))


def _block_max(array, factor):
    return array if factor == 1 else _blocks(array, factor).max((1, 3))


def _blurred(z, radius):
    """Mean over a square, twice."""
    for _ in range(2):
        for axis in (0, 1):
            pad = [(0, 0), (0, 0)]
            pad[axis] = (radius + 1, radius)
            sums = np.cumsum(np.pad(z, pad, mode="edge"), axis, dtype=np.float64)
            upper = np.take(sums, range(2 * radius + 1, sums.shape[axis]), axis)
            lower = np.take(sums, range(0, sums.shape[axis] - 2 * radius - 1), axis)
            z = ((upper - lower) / (2 * radius + 1)).astype(np.float32)
    return z
