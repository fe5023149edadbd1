"""Feature curves of the terrains in view, as paper B's Figs 3 to 5 show them: the curve, its
plateau, the slopes' normals with their lengths and angles, and the border of the envelope, which
lies on the ground. Made anew when something in the scene has changed."""

import bpy
import numpy as np

from ..feature_shape import shape
from ..live import loop
from ..mesh.relief import Relief
from ..scene import feature_curves
from ..scene.plane import Plane
from . import lines

CURVE, PLATEAU, RIM = (0.16, 0.46, 1.0, 1.0), (0.16, 0.46, 1.0, 0.28), (0.16, 0.46, 1.0, 0.9)
NORMAL, FOOT, BORDER = (0.92, 0.92, 0.92, 0.6), (0.92, 0.92, 0.92, 0.85), (0.05, 0.05, 0.05, 0.85)
THICK, THIN = 3.0, 1.5
_shown = {}  # by terrain: after which edit it was made, and what draws it


def draw():
    for terrain in lines.shown_terrains(bpy.context):
        if terrain.orogen.input.show_features:
            for part in parts_of(terrain, bpy.context.scene):
                part()


def parts_of(terrain, scene):
    """What draws the terrain's curves, in order."""
    for uid in [uid for uid, (made, _) in _shown.items() if made != loop.edits]:
        del _shown[uid]
    if terrain.session_uid not in _shown:
        _shown[terrain.session_uid] = loop.edits, list(make(terrain, scene))
    return _shown[terrain.session_uid][1]


def make(terrain, scene):
    curves = feature_curves.read(terrain, scene)
    if not curves:
        return
    plane, relief = Plane(terrain), Relief(terrain)
    for found in map(shape, curves):
        border = np.column_stack([found.border, relief.at(found.border)])
        yield lines.Triangles(plane.places(found.plateau), PLATEAU)
        yield lines.Lines(plane.places(border), BORDER, THIN)
        yield lines.Lines(plane.places(found.normals), NORMAL, THIN)
        yield lines.Lines(plane.places(found.feet), FOOT, THIN)
        yield lines.Lines(plane.places(found.rims), RIM, THIN)
        along = np.repeat(found.curve, 2, axis=0)[1:-1]
        yield lines.Lines(plane.places(along), CURVE, THICK)


def forget():
    _shown.clear()
