"""Heights that a mesh or an image of the scene gives, as rows from the south in metres."""

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

FINEST = 256  # cells along the longer side: each is a ray
MOST_CASTS = 4
_casts = {}  # what was found last, by object and all else that counts


def of_mesh(ob, plane, lower, size, depsgraph):
    """The highest ground of an object in each cell of a rectangle (m); where there is none, its
    lowest. None if no cell has any."""
    heights = _cast(ob, plane, lower, size, depsgraph)
    found = ~np.isnan(heights)
    return np.where(found, heights, heights[found].min()) if found.any() else None


def covered(ob, plane, lower, size, depsgraph):
    """1 in the cells of a rectangle (m) that an object covers, seen from above, else 0."""
    return (~np.isnan(_cast(ob, plane, lower, size, depsgraph))).astype(np.float32)


def _cast(ob, plane, lower, size, depsgraph):
    """The height of an object in each cell, by a ray from above; NaN where there is none."""
    key = (ob.session_uid, np.array(ob.matrix_world).tobytes(), plane.key, *lower, *size)
    if key not in _casts:
        while len(_casts) >= MOST_CASTS:
            del _casts[next(iter(_casts))]
        _casts[key] = _cast_rays(ob, plane, lower, size, depsgraph)
    return _casts[key]


def forget():
    _casts.clear()


def notice_change(depsgraph):
    """What was found is found anew where the object has changed."""
    for update in depsgraph.updates:
        if update.is_updated_geometry and isinstance(update.id, bpy.types.Object):
            changed = update.id.original.session_uid
            for key in [key for key in _casts if key[0] == changed]:
                del _casts[key]


def _cast_rays(ob, plane, lower, size, depsgraph):
    tree = BVHTree.FromObject(ob, depsgraph)
    cell = max(size) / FINEST
    columns, rows = (max(1, round(side / cell)) for side in size)
    x = lower[0] + (np.arange(columns) + 0.5) * (size[0] / columns)
    y = lower[1] + (np.arange(rows) + 0.5) * (size[1] / rows)
    places = np.stack([*np.meshgrid(x, y)], axis=-1).reshape(-1, 2)
    to_object = np.array(ob.matrix_world.inverted_safe())
    down = Vector(to_object[:3, :3] @ -plane.up)
    above = _top(ob, plane) + 1.0
    starts = plane.world(places, above) @ to_object[:3, :3].T + to_object[:3, 3]
    hits = [tree.ray_cast(Vector(start), down)[0] for start in starts]
    nothing = (np.nan,) * 3
    points = np.array([nothing if hit is None else hit for hit in hits])
    matrix = np.array(ob.matrix_world)
    points = points @ matrix[:3, :3].T + matrix[:3, 3]
    return plane.metres(points)[:, 2].reshape(rows, columns).astype(np.float32)


def footprint(ob, plane):
    """Lower-left corner and size (m) of an object's bounds on the plane."""
    corners = _corners(ob, plane)[:, :2]
    lower, upper = corners.min(axis=0), corners.max(axis=0)
    return lower.tolist(), (upper - lower).tolist()


def of_image(image, black, white):
    """The heights of an image's first channel; None if it has no pixels."""
    width, height = image.size
    if not width * height:
        return None
    pixels = np.empty(width * height * image.channels, np.float32)
    image.pixels.foreach_get(pixels)
    grey = pixels.reshape(height, width, image.channels)[..., 0]
    return black + grey * np.float32(white - black)


def _top(ob, plane):
    return _corners(ob, plane)[:, 2].max()


def _corners(ob, plane):
    matrix = np.array(ob.matrix_world)
    return plane.metres(np.array(ob.bound_box) @ matrix[:3, :3].T + matrix[:3, 3])
