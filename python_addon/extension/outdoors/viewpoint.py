"""A place on a terrain from which there is something to see: far ground, high ground, water."""

import numpy as np

PLACES, DIRECTIONS, STEPS = 600, 24, 48
NEAREST, FARTHEST = 30.0, 6000.0  # m, of what is looked at
TALLEST = 0.18  # rise over run: higher ground ahead counts no more
HALF_ANGLE = 0.3  # rad, of the view: what lies to either side counts too
HIGHEST_NEAR = -0.02  # rise over run that ground close by may reach


def find(elevation, water, cell_size, eye_height):
    """Where to stand and which way to look.

    `elevation`: (ny, nx), m; `water`: the same, m above the ground; `eye_height`: m over the
    ground. Returns the eye (x, y, z), m from the lower-left corner, and the direction (x, y) with
    the rise over run of the skyline there.
    """
    surface = np.maximum(elevation + water, 0.0)
    wet = (water > 0.0) | (elevation < 0.0)
    rng = np.random.default_rng(0)
    land = np.flatnonzero(~wet.ravel())
    if not len(land):
        land = np.arange(wet.size)
    rows, columns = np.divmod(rng.choice(land, PLACES), elevation.shape[1])
    eyes = surface[rows, columns] + eye_height
    reach = min(FARTHEST, 0.7 * cell_size * min(elevation.shape))
    distance = np.geomspace(min(NEAREST, 0.1 * reach), reach, STEPS)
    ways = [
        _score(surface, wet, cell_size, (rows, columns, eyes), at, distance)
        for at in np.arange(DIRECTIONS) * (2.0 * np.pi / DIRECTIONS)
    ]
    scores, skylines = (np.stack(part) for part in zip(*ways, strict=True))
    side = max(1, round(HALF_ANGLE * DIRECTIONS / (2.0 * np.pi)))
    scores = scores + 0.5 * (np.roll(scores, side, 0) + np.roll(scores, -side, 0))
    way, place = np.unravel_index(scores.argmax(), scores.shape)
    at = way * (2.0 * np.pi / DIRECTIONS)
    eye = ((columns[place] + 0.5) * cell_size, (rows[place] + 0.5) * cell_size, eyes[place])
    return np.array(eye), np.array([np.cos(at), np.sin(at), skylines[way, place]])


def _score(surface, wet, cell_size, places, at, distance):
    """Of all places: how high ground rises ahead, how much water and land is in sight."""
    rows, columns, eyes = places
    r = rows[:, None] + np.sin(at) * distance / cell_size
    c = columns[:, None] + np.cos(at) * distance / cell_size
    inside = (r >= 0) & (r < surface.shape[0]) & (c >= 0) & (c < surface.shape[1])
    cell = np.where(inside, r, 0).astype(int), np.where(inside, c, 0).astype(int)
    slope = np.where(inside, (surface[cell] - eyes[:, None]) / distance, -1.0)
    before = np.maximum.accumulate(slope, axis=1)
    seen = inside & (slope >= before)
    close = before[:, len(distance) // 2]
    water, land = (seen & wet[cell]).mean(axis=1), (seen & ~wet[cell]).mean(axis=1)
    skyline = before[:, -1]
    score = (
        4.0 * np.minimum(skyline, TALLEST) + 2.5 * np.minimum(water, 0.3) + np.minimum(land, 0.6)
    )
    return score - 8.0 * np.maximum(close - HIGHEST_NEAR, 0.0), skyline
