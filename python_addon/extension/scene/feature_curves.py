"""Feature curves of the scene, in metres on the terrain's plane.

They are curve objects that are marked as such (`orogen_feature`), and strokes on grease-pencil
layers called Ridges, Valleys, Cliffs, River Beds or Feature Curves. A curve object has its numbers
as settings; a custom property of the object with a number's name, a list with one for each control
point, goes before (NaN: as the curve). Of strokes, attributes of the points do.

A stroke that lies on the plane asks for no height: its slopes hang on the ground around it, and the
envelope carries them on. So strokes have half the usual sizes of their kind.
"""

import math

import numpy as np

from ..feature_curves import FLAT, KINDS, NUMBERS, FeatureCurve, kind_of_layer, shaped
from ..mesh.roles import own_mesh
from ..problems import Problem
from .curves import between, controls, sampled
from .plane import Planes
from .plates import root_of
from .strokes import moved, read_strokes

HEIGHT = "elevation"  # whether a point's height is asked for: a list too, 1 or 0
THINNED = 0.001  # of the terrain's longer side: nearer points of a stroke are one
PIECES = 8  # of a straight piece, so that it stays straight


def sides(terrain):
    """Width and height in metres: of the ground, or of the frame where there is none yet."""
    mesh = own_mesh(terrain)
    if terrain.orogen.is_drawn() or "orogen_grid" not in mesh:
        return terrain.orogen.input.frame_metres()
    return [cells * mesh["orogen_cell_size"] for cells in mesh["orogen_grid"]]


def longer_side(terrain):
    return max(sides(terrain))


def inputs_of(terrain, scene):
    """What may hold curves of the terrain: its children and its collection of inputs; where it has
    none the scene, without other terrains' children."""
    if terrain.orogen.drawing is None:
        found = [ob for ob in scene.objects if terrain_above(ob) in (None, terrain)]
    else:
        found = dict.fromkeys((*root_of(terrain, scene).all_objects, *terrain.children_recursive))
    return [ob for ob in found if not ob.hide_viewport]


def objects(terrain, scene):
    """The curve objects that the terrain's ground is bent to."""
    return [ob for ob in inputs_of(terrain, scene) if is_feature(ob) and ob.data.splines]


def is_feature(ob):
    return ob.type == "CURVE" and ob.orogen_feature.is_feature


def terrain_above(ob):
    while ob is not None and not ob.orogen.is_terrain:
        ob = ob.parent
    return ob


def read(terrain, scene):
    """The terrain's FeatureCurves, those of one point left out."""
    planes = Planes(terrain)
    curves = [c for ob in objects(terrain, scene) for c in _of_object(ob, planes.of(ob))]
    for ob in inputs_of(terrain, scene):
        curves += _of_strokes(ob, planes, scene.frame_current, longer_side(terrain))
    return [curve for curve in curves if len(curve.points) > 1]


def control_numbers(ob):
    """Of all control points of a curve object: {name: (n,)}, with "elevation", before radius and
    tilt."""
    settings = ob.orogen_feature
    count = sum(len(controls(spline)) for spline in ob.data.splines)
    numbers = {}
    for name in (*NUMBERS, HEIGHT):
        common = float(settings.number(name))
        own = np.array(own_numbers(ob, name, count) or [math.nan] * count, float)
        numbers[name] = np.where(np.isnan(own), common, own)
    return numbers


def own_numbers(ob, name, count):
    """What a custom property says of each control point; None if it does not fit."""
    own = ob.get(name)
    return list(own) if hasattr(own, "__len__") and len(own) == count else None


def problems(terrain, scene):
    """Numbers for points that do not fit the points."""
    found = []
    for ob in objects(terrain, scene):
        count = sum(len(controls(spline)) for spline in ob.data.splines)
        place = Planes(terrain).of(ob).metres(ob.matrix_world.translation)[0, :2]
        for name in (*NUMBERS, HEIGHT):
            if name in ob and own_numbers(ob, name, count) is None:
                text = f"{ob.name}: '{name}' is no list of {count} numbers, one for each point"
                found.append(Problem(text, tuple(place.tolist())))
    return found


def _of_object(ob, plane):
    numbers, first = control_numbers(ob), 0
    for spline in ob.data.splines:
        points, shares = sampled(spline)
        if spline.type == "POLY":
            shares = between(len(points), PIECES, spline.use_cyclic_u)
            points = shares @ points
        own = controls(spline)
        part = {name: values[first : first + len(own)] for name, values in numbers.items()}
        first += len(own)
        asked = shares @ part.pop(HEIGHT) >= 0.5
        radius, tilt = (np.array([getattr(p, n) for p in own]) for n in ("radius", "tilt"))
        blended = {name: shares @ values for name, values in shaped(part, radius, tilt).items()}
        places = plane.metres(moved(points, ob.matrix_world))
        yield _ring(FeatureCurve(ob.name, places, blended, asked), spline.use_cyclic_u)


def _of_strokes(ob, planes, frame, side):
    for stroke in read_strokes(ob, frame):
        if kind := kind_of_layer(stroke.layer):
            places = planes.of(ob).metres(stroke.points)
            numbers = {
                name: stroke.numbers.get(name, np.full(len(places), value))
                for name, value in KINDS[kind].numbers(0.5 * side).items()
            }
            flat = (abs(places[:, 2]) < FLAT).all()
            asked = stroke.numbers.get(HEIGHT, np.full(len(places), not flat)) >= 0.5
            curve = FeatureCurve(f"{ob.name} {stroke.layer}", places, numbers, asked)
            yield _ring(_thin(curve, THINNED * side), stroke.cyclic)


def _thin(curve, step):
    kept = [0]
    for i in range(1, len(curve.points)):
        if np.hypot(*(curve.points[i, :2] - curve.points[kept[-1], :2])) > step:
            kept.append(i)
    return _taken(curve, kept)


def _ring(curve, cyclic):
    """A ring ends where it began."""
    return _taken(curve, [*range(len(curve.points)), 0]) if cyclic else curve


def _taken(curve, rows):
    numbers = {name: values[rows] for name, values in curve.numbers.items()}
    return FeatureCurve(curve.name, curve.points[rows], numbers, curve.elevation[rows])
