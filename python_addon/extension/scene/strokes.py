"""Grease-pencil strokes in world coordinates, for every generation of grease pencil.

Blender 4.2: objects of type GPENCIL, points in strokes. From 4.3: type GREASEPENCIL, points as
attributes of a drawing.
"""

from dataclasses import dataclass, field

import numpy as np

from ..feature_curves import NUMBERS

OF_POINTS = (*NUMBERS, "elevation")  # attributes that are read with the points
NUMERIC = {"FLOAT": np.float32, "INT": np.int32, "BOOLEAN": bool}


@dataclass
class Stroke:
    layer: str
    points: np.ndarray  # (n, 3), world
    cyclic: bool
    numbers: dict = field(default_factory=dict)  # of OF_POINTS, those that there are: (n,)


def read_strokes(ob, frame):
    """The visible strokes of a grease-pencil object at a frame."""
    if ob.type == "GPENCIL":
        return list(_strokes_before_4_3(ob, frame))
    if ob.type == "GREASEPENCIL":
        return list(_strokes(ob, frame))
    return []


def _strokes(ob, frame):
    for layer in ob.data.layers:
        shown = None if layer.hide else _frame_at(layer.frames, frame)
        if shown is None:
            continue
        matrix = _layer_matrix(ob, layer)
        drawing = shown.drawing
        positions = drawing.attributes.get("position")
        if positions is None or not len(positions.data):
            continue
        offsets = np.empty(len(drawing.curve_offsets), np.int32)
        drawing.curve_offsets.foreach_get("value", offsets)
        points = np.empty(len(positions.data) * 3, np.float32)
        positions.data.foreach_get("vector", points)
        points = moved(points, matrix)
        cyclic = np.zeros(len(offsets) - 1, bool)
        if attribute := drawing.attributes.get("cyclic"):
            attribute.data.foreach_get("value", cyclic)
        numbers = _numbers(drawing, len(points))
        for start, end, closed in zip(offsets[:-1], offsets[1:], cyclic, strict=True):
            own = {name: values[start:end] for name, values in numbers.items()}
            yield Stroke(layer.name, points[start:end], bool(closed), own)


def _numbers(drawing, count):
    found = {}
    for name in OF_POINTS:
        attribute = drawing.attributes.get(name)
        if attribute and attribute.domain == "POINT" and attribute.data_type in NUMERIC:
            values = np.empty(count, NUMERIC[attribute.data_type])
            attribute.data.foreach_get("value", values)
            found[name] = values.astype(float)
    return found


def _layer_matrix(ob, layer):
    if not layer.parent:
        return ob.matrix_world @ layer.matrix_local
    return _parent_matrix(layer) @ layer.matrix_parent_inverse @ layer.matrix_local


def _strokes_before_4_3(ob, frame):
    for layer in ob.data.layers:
        shown = None if layer.hide else _frame_at(layer.frames, frame)
        if shown is None:
            continue
        matrix = _layer_matrix_before_4_3(ob, layer)
        for stroke in shown.strokes:
            points = np.empty(len(stroke.points) * 3, np.float32)
            stroke.points.foreach_get("co", points)
            yield Stroke(layer.info, moved(points, matrix), stroke.use_cyclic)


def _layer_matrix_before_4_3(ob, layer):
    own = ob.matrix_world @ layer.matrix_layer
    if not layer.parent:
        return own
    return own @ ob.matrix_world.inverted() @ _parent_matrix(layer) @ layer.matrix_inverse


def _parent_matrix(layer):
    parent, bone = layer.parent, layer.parent_bone
    if parent.type == "ARMATURE" and bone in parent.pose.bones:
        return parent.matrix_world @ parent.pose.bones[bone].matrix
    return parent.matrix_world


def _frame_at(frames, number):
    earlier = [frame for frame in frames if frame.frame_number <= number]
    return max(earlier, key=lambda frame: frame.frame_number, default=None)


def moved(points, matrix):
    points = points.reshape(-1, 3).astype(float)
    matrix = np.array(matrix)
    return points @ matrix[:3, :3].T + matrix[:3, 3]
