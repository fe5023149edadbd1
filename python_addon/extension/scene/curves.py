"""Curve objects as lines in world coordinates, whatever bevel or modifiers they carry."""

import numpy as np
from mathutils.geometry import interpolate_bezier

from .strokes import Stroke, moved

STEPS = 16  # pieces between two points of a curve
KIND = "orogen_kind"  # custom property of a curve object: what it is, where its name does not say


def read_curves(ob):
    """The splines of a curve object as strokes, on a layer of the object's kind or name."""
    layer = str(ob.get(KIND, ob.name))
    strokes = []
    for spline in ob.data.splines:
        points = moved(_points(spline), ob.matrix_world)
        strokes.append(Stroke(layer, points, spline.use_cyclic_u))
    return strokes


def _points(spline):
    if spline.type == "BEZIER":
        return _bezier(spline)
    points = np.array([tuple(point.co) for point in spline.points])
    if spline.type == "NURBS" and spline.order_u <= len(points):
        return _nurbs(spline, points)
    return points[:, :3]


def _bezier(spline):
    knots = list(spline.bezier_points)
    points = [tuple(knots[0].co)]
    for a, b in zip(knots, knots[1:] + knots[:1] * spline.use_cyclic_u, strict=False):
        piece = interpolate_bezier(a.co, a.handle_right, b.handle_left, b.co, STEPS + 1)
        points += [tuple(point) for point in piece[1:]]
    return np.array(points[:-1] if spline.use_cyclic_u else points)


def _nurbs(spline, control):
    """De Boor's curve; `control` (n, 4) holds the weights."""
    order, cyclic = spline.order_u, spline.use_cyclic_u
    weighted = np.hstack([control[:, :3] * control[:, 3:], control[:, 3:]])
    if cyclic:
        weighted = np.vstack([weighted, weighted[: order - 1]])
    count = len(weighted)
    knots = np.arange(count + order, dtype=float)
    if spline.use_endpoint_u and not cyclic:
        knots = np.clip(knots, order - 1, count)
    at = np.linspace(order - 1, count, (count - order + 1) * STEPS + 1)
    curve = _basis(at, knots, order, count) @ weighted
    curve = curve[:, :3] / curve[:, 3:]
    return curve[:-1] if cyclic else curve


def _basis(at, knots, order, count):
    """The B-splines of an order at the places `at`, (places, count), by Cox and de Boor."""
    last = np.searchsorted(knots, at[-1]) - 1  # the end belongs to the last piece that is not empty
    piece = np.minimum(np.searchsorted(knots, at, side="right") - 1, last)
    basis = (piece[:, None] == np.arange(len(knots) - 1)).astype(float)
    for k in range(1, order):
        wide = np.where(knots[k:] > knots[:-k], knots[k:] - knots[:-k], np.inf)
        rising = (at[:, None] - knots[:-k]) / wide
        basis = rising[:, :-1] * basis[:, :-1] + (1.0 - rising[:, 1:]) * basis[:, 1:]
    return basis[:, :count]
