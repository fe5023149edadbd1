"""Marks where a drawing is wrong: a ring, and the number that the panel's list gives it."""

import math

import blf
import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d

from ..scene.plane import Plane
from . import lines

ERROR, WARNING = (1.0, 0.25, 0.2, 1.0), (1.0, 0.75, 0.1, 1.0)
RADIUS, WIDTH, SIDES, TEXT = 9.0, 2.0, 16, 13.0  # pixels at a scale of 1


def draw():
    context = bpy.context
    scale = context.preferences.system.ui_scale
    for terrain in lines.shown_terrains(context):
        plane = Plane(terrain)
        for number, problem in enumerate(terrain.orogen.problems, 1):
            if problem.has_place:
                place = plane.world(problem.place)[0]
                at = location_3d_to_region_2d(context.region, context.region_data, place)
                if at is not None:
                    draw_mark(at, str(number), ERROR if problem.is_error else WARNING, scale)


def draw_mark(at, text, color, scale):
    radius = RADIUS * scale
    turns = [2.0 * math.pi * k / SIDES for k in range(SIDES + 1)]
    ring = [(at.x + radius * math.cos(t), at.y + radius * math.sin(t)) for t in turns]
    lines.draw([ring[i + k] for i in range(SIDES) for k in (0, 1)], color, WIDTH * scale)
    blf.size(0, TEXT * scale)
    blf.color(0, *color)
    blf.position(0, at.x + 1.4 * radius, at.y - 0.4 * radius, 0.0)
    blf.draw(0, text)
