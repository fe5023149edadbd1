"""The frame of a terrain that is drawn: the rectangle that will grow."""

import bpy

from ..scene.plane import Plane
from . import lines

COLOR, ACTIVE = (0.55, 0.62, 0.70, 0.8), (1.0, 0.66, 0.25, 0.9)
WIDTH = 1.5


def corners(terrain):
    """In the world, counterclockwise from the south-west; None where there is no frame."""
    settings = terrain.orogen
    size = settings.input.frame_size() if settings.is_drawn() else None
    if size is None:
        return None
    x, y = 0.5 * size[0], 0.5 * size[1]
    return Plane(terrain).world([(-x, -y), (x, -y), (x, y), (-x, y)])


def draw():
    context = bpy.context
    for terrain in lines.shown_terrains(context):
        rectangle = corners(terrain)
        if rectangle is not None:
            sides = [rectangle[k % 4] for i in range(4) for k in (i, i + 1)]
            lines.draw(sides, ACTIVE if terrain == context.object else COLOR, WIDTH)
