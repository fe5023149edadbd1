"""Changes of single polygons of an island as a raster. No bpy here.

An edit is a ring of corners (m, anticlockwise) and what is added inside. The core looks rasters up
at the corners, so that a little beyond the ring belongs to it.
"""

import numpy as np

LONGER_SIDE = 1024  # cells of a raster, if there is no paint that has some
BEYOND = 1.5  # cells


def shape_of(size):
    """Rows and columns of a raster over a rectangle (m)."""
    columns, rows = (max(1, round(LONGER_SIDE * side / max(size))) for side in size)
    return rows, columns


def add(values, edits, lower, size):
    """Adds edits (ring, change) to a raster over a rectangle (m), from the south-west."""
    rows, columns = values.shape
    cell = np.array([size[0] / columns, size[1] / rows])
    for ring, change in edits:
        ring = (np.asarray(ring, float) - lower) / cell
        first = np.maximum(np.floor(ring.min(axis=0) - BEYOND), 0).astype(int)
        last = np.minimum(np.ceil(ring.max(axis=0) + BEYOND), (columns, rows)).astype(int)
        if (last > first).all():
            x, y = np.meshgrid(*(np.arange(a, b) + 0.5 for a, b in zip(first, last, strict=True)))
            part = values[first[1] : last[1], first[0] : last[0]]
            part[inside(ring, x, y, BEYOND)] += np.float32(change)


def inside(ring, x, y, beyond=0.0):
    """Whether places lie inside a convex ring whose sides are moved outwards by `beyond`."""
    found = np.ones(np.shape(x), bool)
    for (ax, ay), (bx, by) in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        length = np.hypot(bx - ax, by - ay)
        found &= (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= -beyond * length
    return found
