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


def place(scene, terrain, lie, turn, farther):
    """Our camera, made if there is none, becomes the scene's. `turn`: radians around the range;
    `farther`: how many times as far off as it would be."""
    camera = ensure(scene, terrain, "camera", bpy.data.cameras.new)
    eye, target = (terrain.matrix_world @ Vector(place) for place in of(lie, turn, farther))
    size = (eye - target).length
    camera.data.lens = LENS
    camera.data.clip_start, camera.data.clip_end = 1e-2 * size, 2e3 * size
    camera.location = eye
    camera.rotation_mode = "XYZ"
    camera.rotation_euler = (target - eye).to_track_quat("-Z", "Y").to_euler()
    scene.camera = camera
    return camera


def of(lie, turn, farther=1.0):
    """Where the eye is and where it looks, in local units."""
    towards = direction(lie, turn)
    relief = max(lie.top - lie.base, 1e-3 * lie.length)
    width = farther * min(max(lie.width, STEEPEST * relief), FLATTEST * relief)
    height = max(lie.base + HEIGHT * width, lie.top + 0.1 * relief)
    eye = np.array([*(lie.middle + DISTANCE * width * towards), height])
    ahead = np.array([*(-math.cos(PITCH) * towards), math.sin(PITCH)])
    return eye, eye + DISTANCE * width * ahead


def direction(lie, turn):
    """From the middle of the range towards the eye."""
    return np.cos(turn) * lie.front + np.sin(turn) * lie.axis
