"""A camera that stands on a terrain and looks over its trees."""

import math

import bpy
import numpy as np
from mathutils import Vector

from ..mesh import attributes
from . import viewpoint
from .things import ensure

LENS = 28.0  # mm
SKYLINE = math.radians(10.0)  # of the highest ground over the middle of the picture
STEEPEST = math.radians(12.0)  # that the camera looks down or up at most
NEAREST, FARTHEST = 0.5, 500e3  # m: what it sees


def find(terrain, eye_height):
    """Where to stand (m, from the terrain's origin) and which way to look: see `viewpoint.find`."""
    mesh = terrain.data
    nx, ny = mesh["orogen_grid"]
    elevation = attributes.read(mesh, "elevation", (ny, nx))
    water = np.zeros_like(elevation)
    if "water_depth" in mesh.attributes:
        water = attributes.read(mesh, "water_depth", (ny, nx))
    eye, ahead = viewpoint.find(elevation, water, mesh["orogen_cell_size"], eye_height)
    return eye + (*mesh["orogen_offset"], 0.0), ahead


def place(scene, terrain, eye, ahead):
    """Our camera, made if there is none, becomes the scene's."""
    camera = ensure(scene, terrain, "camera", bpy.data.cameras.new)
    across, up = terrain.orogen.local_scale()
    local = Vector((eye[0] * across, eye[1] * across, eye[2] * up))
    pitch = math.atan(ahead[2] * up / across) - SKYLINE
    towards = Vector((*ahead[:2], math.tan(max(-STEEPEST, min(pitch, STEEPEST)))))
    towards.rotate(terrain.matrix_world.to_quaternion())
    unit = across * terrain.matrix_world.median_scale
    camera.data.lens = LENS
    camera.data.clip_start, camera.data.clip_end = NEAREST * unit, FARTHEST * unit
    camera.location = terrain.matrix_world @ local
    camera.rotation_mode = "XYZ"
    camera.rotation_euler = towards.to_track_quat("-Z", "Y").to_euler()
    scene.camera = camera
    return camera


def of_scene(scene, terrain):
    """Eye and direction of the scene's camera, as `find` gives them."""
    view = terrain.matrix_world.inverted() @ scene.camera.matrix_world
    across, up = terrain.orogen.local_scale()
    eye = np.array(view.translation) / (across, across, up)
    ahead = np.array(view.to_3x3() @ Vector((0.0, 0.0, -1.0)))
    return eye, ahead / max(np.hypot(*ahead[:2]), 1e-9)
