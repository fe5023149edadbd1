"""The drawing of a terrain: lines and empties of the scene, in metres on the terrain's plane."""

import numpy as np

from ..feature_curves import kind_of_layer
from ..map_features import Drawing, Peak, close_coasts
from .feature_curves import is_feature
from .lines import read_lines
from .plane import Planes
from .plates import arrow_objects, root_of

KINDS = ("coast", "river", "lake", "peak", "volcano")  # by how a layer's or a curve's name begins
LOWEST_PEAK = 1.0  # m: what lies on the plane says nothing of its height


def read_drawing(terrain, scene):
    planes = Planes(terrain)
    lines = {kind: [] for kind in KINDS}
    drawing = Drawing()
    arrows = arrow_objects(terrain, scene)
    for ob in root_of(terrain, scene).all_objects:
        for stroke in () if is_feature(ob) else read_lines(ob, scene.frame_current):
            if kind := _kind_of(stroke.layer):
                points = planes.of(ob).metres(stroke.points)
                lines[kind].append((points, stroke.cyclic or _returns(points)))
        if _is_peak(ob) and ob.name not in arrows:
            place = planes.of(ob).metres(ob.matrix_world.translation)[0]
            drawing.peaks.append(_peak(place, ob.name, _kind_of(ob.name) == "volcano"))
    for kind in ("peak", "volcano"):
        for points, _ in lines[kind]:
            drawing.peaks.append(_peak(points.mean(axis=0), "", kind == "volcano"))
    drawing.rivers = [points[:, :2] for points, _ in lines["river"] if len(points) > 1]
    drawing.lakes = [points[:, :2] for points, _ in lines["lake"] if len(points) > 2]
    coasts = [(points[:, :2], closed) for points, closed in lines["coast"] if len(points) > 1]
    drawing.coasts = [points for points, closed in coasts if closed]
    opened = [points for points, closed in coasts if not closed]
    close_coasts(drawing, opened, terrain.orogen.input.join_tolerance)
    return drawing


def _is_peak(ob):
    """A visible empty, unless it is a spring, or shows an image to trace, or instances of a
    collection."""
    if ob.type != "EMPTY" or ob.hide_viewport or ob.orogen_spring.is_spring:
        return False
    return ob.empty_display_type != "IMAGE" and ob.instance_type == "NONE"


def _peak(place, name, volcano):
    x, y, height = place
    return Peak((x, y), height if height >= LOWEST_PEAK else None, name, volcano)


def _returns(points):
    return len(points) > 3 and np.array_equal(points[0], points[-1])


def _kind_of(name):
    if kind_of_layer(name):  # "River Beds" are no rivers
        return None
    name = name.lower()
    return next((kind for kind in KINDS if name.startswith(kind)), None)
