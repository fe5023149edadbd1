"""The drawing of a terrain: strokes and empties of the scene, in metres on the terrain's plane.

The plane is the terrain object's own x and y: move, turn or scale the terrain and the drawing is
read where it lies on it. Heights are its z, without the vertical exaggeration.
"""

import numpy as np

from ..map_features import Drawing, Peak
from .strokes import read_strokes

LAYERS = {"coast": "coasts", "river": "rivers", "lake": "lakes"}  # by how a layer's name begins


def read_drawing(terrain, scene):
    settings = terrain.orogen
    objects = (settings.drawing or scene.collection).all_objects
    to_local = np.array(terrain.matrix_world.inverted_safe())
    across, up = settings.local_scale()
    scale = np.array([across, across, up])

    def in_metres(points):
        points = np.asarray(points, float).reshape(-1, 3)
        return (points @ to_local[:3, :3].T + to_local[:3, 3]) / scale

    drawing = Drawing()
    for ob in objects:
        for stroke in read_strokes(ob, scene.frame_current):
            if (kind := _kind_of(stroke.layer)) and len(stroke.points) > 1:
                getattr(drawing, kind).append(in_metres(stroke.points)[:, :2])
        if ob.type == "EMPTY" and not ob.hide_viewport:
            x, y, height = in_metres(ob.matrix_world.translation)[0]
            drawing.peaks.append(Peak((x, y), height if height > 0 else None, ob.name))
    return drawing


def _kind_of(layer):
    name = layer.lower()
    return next((kind for start, kind in LAYERS.items() if name.startswith(start)), None)
