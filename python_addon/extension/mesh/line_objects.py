"""Lines on the ground as curve objects: children of the terrain, in metres."""

import bpy
import numpy as np

from ..material import plain_material
from . import children

THICKNESS = 0.15  # cells, of the tube around a line
COLOURS = {  # of what a part's name begins with
    "trace": (0.02, 0.02, 0.02),
    "crests": (0.70, 0.10, 0.02),
    "troughs": (0.02, 0.15, 0.55),
    "rivers": (0.02, 0.18, 0.45),
}


def write(terrain, kind, lines):
    """One set of a kind a terrain. `lines`: {PART: {points, starts, closed}}."""
    for part, ob in children.renew(terrain, kind, lines, _new_curve).items():
        _write_curve(ob.data, **lines[part])
        ob.data.bevel_depth = THICKNESS * terrain.data["orogen_cell_size"]
        if not ob.data.materials:
            word = part.split()[0]
            ob.data.materials.append(plain_material.ensure(word, COLOURS[word]))
            ob.color = (*COLOURS[word], 1.0)  # in solid viewports that show attributes
        children.place(ob, terrain, terrain.data["orogen_offset"])


def _new_curve(name):
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    curve.bevel_resolution = 1
    return curve


def _write_curve(curve, points, starts, closed):
    curve.splines.clear()
    ends = [*starts[1:], len(points)]
    with_weights = np.ones((len(points), 4), np.float32)
    with_weights[:, :3] = points
    for start, end, ring in zip(starts, ends, closed, strict=True):
        spline = curve.splines.new("POLY")
        spline.points.add(int(end - start) - 1)
        spline.points.foreach_set("co", with_weights[start:end].ravel())
        spline.use_cyclic_u = bool(ring)
