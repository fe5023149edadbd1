"""The active terrain's plates: hulls, arrows that lie flat on its plane, borders of influence."""

import bpy
import numpy as np

from .. import terrains
from ..live import loop
from ..scene.new_inputs import COLORS
from ..scene.plane import Plane
from ..scene.plates import active_plate, plate_collections
from . import lines

SHAFT, HEAD = 0.004, 0.022  # half a width and a length, of the longer side of what is seen
FILL, OUTLINE, ARROW = 0.16, 0.9, 0.95  # opacities
BORDER = (0.95, 0.95, 0.95, 0.55)
WIDTH, ACTIVE_WIDTH = 1.5, 3.0
drawn_now = None  # world places from and to which the user draws an arrow


def draw():
    context = bpy.context
    terrain = terrains.active(context)
    if terrain not in lines.shown_terrains(context):
        return
    plane, shown = Plane(terrain), loop.plates_shown()
    if drawn_now:
        start, end = plane.metres(drawn_now)[:, :2]
        draw_triangles(plane, arrow(start, end - start, _extent(terrain, shown)), (1, 1, 1, ARROW))
    if shown and terrain.orogen.input.show_hulls and shown[0]["terrain"] == terrain.session_uid:
        draw_plates(context, terrain, plane, *shown)


def draw_plates(context, terrain, plane, asked, answer):
    extent = _extent(terrain, (asked, answer))
    plates = plate_collections(terrain, context.scene)
    colors = {plate.name: plate.orogen_plate.color for plate in plates}
    active = active_plate(context, terrain)
    for number, (plate, found) in enumerate(zip(asked["plates"], answer["plates"], strict=True)):
        linear = colors.get(plate["name"], COLORS[number % len(COLORS)])
        color = tuple(part ** (1.0 / 2.2) for part in linear)  # as the panel shows it
        hull = np.array(found["hull"])
        fan = [corner for k in range(1, len(hull) - 1) for corner in (0, k, k + 1)]
        draw_triangles(plane, hull[fan], (*color, FILL))
        is_active = active is not None and active.name == plate["name"]
        outline = hull[[k % len(hull) for i in range(len(hull)) for k in (i, i + 1)]]
        lines.draw(plane.world(outline), (*color, OUTLINE), ACTIVE_WIDTH if is_active else WIDTH)
        for point, vector in zip(plate["points"], plate["arrows"], strict=True):
            draw_triangles(plane, arrow(point, vector, extent), (*color, ARROW))
    borders = np.reshape(answer["borders"], (-1, 2))
    lines.draw(plane.world(borders), BORDER, WIDTH)


def arrow(point, vector, extent):
    """Corners (n, 2) of the triangles of an arrow; a diamond where the ground stays."""
    point, vector = np.asarray(point, float), np.asarray(vector, float)
    length, half = np.hypot(*vector), SHAFT * extent
    if length < 1.0:
        east, north = (2.0 * half, 0.0), (0.0, 2.0 * half)
        middle = [point + east, point - east]
        return [*middle, point + north, *middle, point - north]
    head = min(HEAD * extent, 0.5 * length)
    along = vector / length
    across = half * np.array([-along[1], along[0]])
    tip = point + vector
    neck = tip - head * along
    barb = 0.45 * head / half * across
    shaft = [point - across, point + across, neck + across]
    return [*shaft, neck + across, neck - across, point - across, neck + barb, neck - barb, tip]


def draw_triangles(plane, corners, color):
    lines.Triangles(plane.world(corners), color)()


def _extent(terrain, shown):
    """The longer side in metres of what arrows are drawn on."""
    size = shown[0].get("size") if shown else None
    return max(size or [1e3 * side for side in terrain.orogen.input.frame_km])
