"""The colours of ground that running water wears, as it is watched: how deep the water is, or what
was worn off and laid down."""

import json

import numpy as np

from ..mesh import attributes
from . import show

WATER, CHANGE = "WATER", "CHANGE"
SHOWN = {  # field of a frame, label, scale
    WATER: ("water_depth", "Water Depth", "WATER"),
    CHANGE: ("change", "Worn Off and Laid Down", "VIK"),
}
USUAL = 99.0  # percentile of what is not 0, to which colours reach
LEAST = 0.01  # m


def has_colours(fields):
    return "change" in fields


def colour(mesh, fields, what):
    """Colours the mesh of a frame. The legend's range grows with what is seen."""
    name, label, scale = SHOWN[what]
    values = fields[name].ravel()
    moved = np.abs(values[values != 0.0])
    high = float(np.percentile(moved, USUAL)) if len(moved) else LEAST
    before = json.loads(mesh.get(show.LEGEND, "{}"))
    if before.get("label") == label:
        high = max(high, before["high"])
    high = max(high, LEAST)
    legend = {"label": label, "unit": "m", "scale": scale, "logarithmic": False}
    legend |= {"low": 0.0 if what == WATER else -high, "high": high}
    mesh[show.LEGEND] = json.dumps(legend)
    attributes.write_linear(mesh, show.ATTRIBUTE, show.of_numbers(values, legend), "POINT")
    mesh.color_attributes.active_color = mesh.attributes[show.ATTRIBUTE]
