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
        points = moved(sampled(spline)[0], ob.matrix_world)
        strokes.append(Stroke(layer, points, spline.use_cyclic_u))
    return strokes


def controls(spline):
    return spline.bezier_points if spline.type == "BEZIER" else spline.points


def sampled(spline):
    """Places along a spline, (n, 3), and how much of each control point's numbers each of them has,
    (n, control points)."""
    if spline.type == "BEZIER":
        return _bezier(spline)
    control = np.array([tuple(point.co) for point in spline.points])
    if spline.type == "NURBS" and spline.order_u <= len(control):
        shares = _nurbs(spline, control[:, 3])
        return shares @ control[:, :3], shares
    return control[:, :3], np.eye(len(control))


def between(count, steps, cyclic):
    """Shares of `count` points in places between them, `steps` to a piece."""
    pieces = count if cyclic else count - 1
    at = np.arange(pieces * steps + (not cyclic)) / steps
    first = np.minimum(at.astype(int), count - 1)
    shares = np.zeros((len(at), count))
    rows = np.arange(len(at))
    np.add.at(shares, (rows, first), 1.0 - (at - first))
    np.add.at(shares, (rows, (first + 1) % count), at - first)
    return shares


def _bezier(spline):
    knots, cyclic = list(spline.bezier_points), spline.use_cyclic_u
    points = [tuple(knots[0].co)]
    for a, b in zip(knots, knots[1:] + knots[:1] * cyclic, strict=False):
        piece = interpolate_bezier(a.co, a.handle_right, b.handle_left, b.co, STEPS + 1)
        points += [tuple(point) for point in piece[1:]]
    points = np.array(points[:-1] if cyclic else points)
    return points, between(len(knots), STEPS, cyclic)


def _nurbs(spline, weights):
    """Shares of the control points in places of De Boor's curve."""
    order, cyclic, points = spline.order_u, spline.use_cyclic_u, len(weights)
    count = points + (order - 1 if cyclic else 0)
    knots = np.arange(count + order, dtype=float)
    if spline.use_endpoint_u and not cyclic:
        knots = np.clip(knots, order - 1, count)
    at = np.linspace(order - 1, count, (count - order + 1) * STEPS + 1)
    basis = _basis(at, knots, order, count)
    basis[:, : count - points] += basis[:, points:]  # the first points again, in a ring
    shares = basis[:, :points] * weights
    shares /= shares.sum(axis=1, keepdims=True)
    return shares[:-1] if cyclic else shares


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
