"""Springs of the scene: empties that are marked as such (`orogen_spring`). Their heights say
nothing: water comes out of the ground."""

import numpy as np

from .feature_curves import inputs_of
from .plane import Planes


def objects(terrain, scene):
    return [ob for ob in inputs_of(terrain, scene) if ob.orogen_spring.is_spring]


def read(terrain, scene, shift):
    """The terrain's springs as a recipe's `river_sources`; `shift` (m) is added to their places."""
    planes = Planes(terrain)
    return [
        {
            "name": ob.name,
            "position": np.round(_place(ob, planes) + shift, 2).tolist(),
            **ob.orogen_spring.numbers(),
        }
        for ob in objects(terrain, scene)
    ]


def _place(ob, planes):
    return planes.of(ob).metres(ob.matrix_world.translation)[0, :2]
