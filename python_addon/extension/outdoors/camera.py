"""A camera that looks at a terrain from the air, over its foreland."""

import math

import bpy
import numpy as np
from mathutils import Vector

from .things import ensure

LENS = 40.0  # mm
FLATTEST, STEEPEST = 15.0, 6.0  # width of what is looked at over its relief: at most, at least
DISTANCE, HEIGHT = 0.85, 0.135  # of the eye, from the middle and over the base; widths
PITCH = math.radians(-7.5)  # with it the skyline is near the upper edge


def place(scene, terrain, lie, turn):
    """Our camera, made if there is none, becomes the scene's. `turn`: radians around the range."""
    camera = ensure(scene, terrain, "camera", bpy.data.cameras.new)
    eye, target = (terrain.matrix_world @ Vector(place) for place in of(lie, turn))
    size = (eye - target).length
    camera.data.lens = LENS
    camera.data.clip_start, camera.data.clip_end = 1e-2 * size, 2e3 * size
    camera.location = eye
    camera.rotation_mode = "XYZ"
    camera.rotation_euler = (target - eye).to_track_quat("-Z", "Y").to_euler()
    scene.camera = camera
    return camera


def of(lie, turn):
    """Where the eye is and where it looks, in local units."""
    towards = direction(lie, turn)
    relief = max(lie.top - lie.base, 1e-3 * lie.length)
    width = min(max(lie.width, STEEPEST * relief), FLATTEST * relief)
    eye = np.array([*(lie.middle + DISTANCE * width * towards), lie.base + HEIGHT * width])
    ahead = np.array([*(-math.cos(PITCH) * towards), math.sin(PITCH)])
    return eye, eye + DISTANCE * width * ahead


def direction(lie, turn):
    """From the middle of the range towards the eye."""
    return np.cos(turn) * lie.front + np.sin(turn) * lie.axis
