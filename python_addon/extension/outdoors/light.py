"""The sun, and the world's sky that goes with it."""

import math

import bpy
from mathutils import Vector

from ..material import sky
from .things import ensure

SIDE = math.radians(75.0)  # of the sun, to the left of whoever looks
ENERGY, COLOUR, ANGLE = 9.0, (1.0, 0.86, 0.68), math.radians(0.55)


def place(scene, terrain, towards, elevation):
    """`towards`: from the range to the eye; `elevation`: the sun's, in radians."""
    aside = Vector((*towards, 0.0))
    aside.rotate(terrain.matrix_world.to_quaternion())
    azimuth = math.atan2(aside.x, aside.y) + SIDE  # clockwise from north
    sun = ensure(scene, terrain, "sun", lambda name: bpy.data.lights.new(name, "SUN"))
    sun.data.energy, sun.data.color, sun.data.angle = ENERGY, COLOUR, ANGLE
    sun.rotation_mode = "XYZ"
    sun.rotation_euler = (math.pi / 2 - elevation, 0.0, math.pi - azimuth)
    sun.location = terrain.matrix_world.translation
    sky.point(elevation, azimuth)


def show_sky(scene):
    """Our world becomes the scene's; one that was there stays in the file."""
    ours = sky.world()
    if scene.world not in (None, ours):
        scene.world.use_fake_user = True
    scene.world = ours


def set_colours(scene):
    """A look with contrast, unless the user has chosen one."""
    view = scene.view_settings
    if view.view_transform == "AgX" and view.look == "None":
        view.look = "AgX - High Contrast"
