"""Making what a terrain is read from: its collection, its map to draw on, its plates, its curves,
its springs.

All of it is the terrain's child, so that it moves along.
"""

import math

import bpy
import numpy as np
from mathutils import Vector

from ..mesh.relief import Relief
from . import pencil
from .feature_curves import longer_side
from .plates import ARROW

MAP_LAYERS = ("Coast", "Rivers", "Lakes", "Peaks")
COLORS = ((0.90, 0.35, 0.10), (0.10, 0.45, 0.85), (0.35, 0.65, 0.15), (0.75, 0.20, 0.55))  # linear
TAGS = ("COLOR_02", "COLOR_05", "COLOR_04", "COLOR_07")  # of Blender, near to those


def collection_of(terrain):
    """The terrain's own collection of inputs, made if it has none."""
    if terrain.orogen.drawing is None:
        inputs = bpy.data.collections.new(f"{terrain.name} Inputs")
        terrain.users_collection[0].children.link(inputs)
        terrain.orogen.drawing = inputs
    return terrain.orogen.drawing


def map_of(terrain):
    """The object that the terrain's map is drawn on, made if it has none."""
    inputs = collection_of(terrain)
    kinds = ("GREASEPENCIL", "GPENCIL")
    found = next((ob for ob in inputs.all_objects if ob.type in kinds), None)
    if found is None:
        settings = terrain.orogen
        found = pencil.new(
            f"{terrain.name} Map", settings.units_per_km * max(settings.input.frame_km)
        )
        found.parent = terrain
        inputs.objects.link(found)
    return found


def add_map(terrain, frame):
    ob = map_of(terrain)
    for layer in reversed(MAP_LAYERS):  # so that the coast stays active
        pencil.ensure_layer(ob, layer, frame)
    return ob


def add_plate(terrain, name, stable=False, crust="continental"):
    inputs = collection_of(terrain)
    count = sum(child.orogen_plate.is_plate for child in inputs.children)
    plate = bpy.data.collections.new(name)
    plate.color_tag = TAGS[count % len(TAGS)]
    settings = plate.orogen_plate
    settings.is_plate, settings.stable, settings.crust = True, stable, crust
    settings.color = COLORS[count % len(COLORS)]
    inputs.children.link(plate)
    terrain.orogen.input.active_plate = len(inputs.children) - 1
    return plate


def add_arrow(terrain, plate, point, vector):
    """An empty from `point` along `vector` (m on the terrain's plane). One that does not move
    stands upright, a hundredth of the frame high."""
    across = terrain.orogen.local_scale()[0]
    length = math.hypot(*vector)
    ob = bpy.data.objects.new(f"{plate.name} Arrow", None)
    ob.empty_display_type = ARROW
    ob.empty_display_size = across * (length or 30.0 * max(terrain.orogen.input.frame_km))
    ob.location = (point[0] * across, point[1] * across, 0.0)
    if length:
        ob.rotation_euler = Vector((*vector, 0.0)).to_track_quat("Z", "Y").to_euler()
    ob.color = (*plate.orogen_plate.color, 1.0)
    ob.parent = terrain
    plate.objects.link(ob)
    return ob


def add_peak(terrain, name, point, height):
    """An empty at `point` and `height` (m)."""
    return _add_empty(terrain, collection_of(terrain), name or "Peak", "CONE", (*point, height))


def add_spring(terrain, name, point):
    """An empty at `point` (m), on the ground, that is marked as a spring."""
    place = (*point, Relief(terrain).at(point)[0])
    ob = _add_empty(terrain, _shared_collection(terrain), name, "SPHERE", place)
    ob.show_in_front = True  # ground that grows does not hide it
    ob.orogen_spring.is_spring = True
    return ob


def _add_empty(terrain, collection, name, display, place):
    """An empty at a place (m)."""
    across, up = terrain.orogen.local_scale()
    ob = bpy.data.objects.new(name, None)
    ob.empty_display_type = display
    ob.empty_display_size = 0.01 * across * longer_side(terrain)
    ob.location = (place[0] * across, place[1] * across, place[2] * up)
    ob.parent = terrain
    collection.objects.link(ob)
    return ob


def add_curve(terrain, name, places):
    """A smooth curve object through places (n, 3) in metres, with its origin amid them."""
    scale = np.array([*terrain.orogen.local_scale()])[[0, 0, 1]]
    middle = (*np.mean(places, axis=0)[:2], 0.0)
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new("BEZIER")
    spline.bezier_points.add(len(places) - 1)
    for point, place in zip(spline.bezier_points, (places - middle) * scale, strict=True):
        point.co = place
        point.handle_left_type = point.handle_right_type = "AUTO"
    ob = bpy.data.objects.new(name, data)
    ob.show_in_front = True  # ground that grows does not hide it
    ob.location = middle * scale
    ob.parent = terrain
    _shared_collection(terrain).objects.link(ob)
    return ob


def _shared_collection(terrain):
    """Where what any terrain may have is put: its collection of inputs, or beside it."""
    return terrain.orogen.drawing or terrain.users_collection[0]
