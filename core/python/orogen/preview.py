"""Previews: the same recipe, made so coarse that it follows a hand that draws or moves something.

What makes a preview is declared here and nowhere else. Seed, inputs and stages stay, but for those
OMITTED; the grid has RESOLUTION cells along the longer side, and no parameter of AT_MOST is greater
than it says. Where ranges, coasts, folds and plains lie is that of the terrain. Its valleys, and a
tenth or two of the height of mountains between plates, are not: fewer rivers cut them.
"""

import functools

from . import _core
from .pipeline import generate

cache = _core.Cache(96 << 20)
"""Results of stages, apart from those of terrains: each step of a drag leaves some that nobody asks
for again."""

RESOLUTION = 256  # cells along the longer side

OMITTED = ("rock_detail",)

AT_MOST = {
    "relief_growth": {
        "coarsest_cells": 64,
        "coarse_steps": 10,
        "middle_steps": 4,
        "finest_steps": 3,
    },
    "hydraulic_erosion": {"duration": 200.0},
    "mountain_growth": {"vertices_per_cell": 0.1, "steps": 10, "coarse_levels": 2, "frames": 0},
}


def generate_preview(document, seed=None, progress=None):
    """The terrain of a preview; see `preview_recipe` and `orogen.generate`."""
    return generate(preview_recipe(document), seed=seed, progress=progress, cache=cache)


def preview_recipe(document):
    """The recipe of a preview.

    Parameters
    ----------
    document : dict
        A recipe, or a bare GeoJSON map.

    Returns
    -------
    dict
    """
    if "orogen" not in document:
        document = {"orogen": _schema()["orogen"], "map": document}
    stages = document.get("stages") or [{"stage": name} for name in _default_stages(document)]
    lightened = [_lightened(item) for item in stages if item.get("stage") not in OMITTED]
    return {**document, "resolution": RESOLUTION, "stages": lightened}


@functools.cache
def _schema():
    return _core.schema()


def _lightened(item):
    given = item.get("parameters", {})
    limits = AT_MOST.get(item.get("stage"), {})
    limited = {name: min(given.get(name, limit), limit) for name, limit in limits.items()}
    return {**item, "parameters": {**given, **limited}}


def _default_stages(document):
    is_collision = document.get("phases") and "map" not in document
    return _schema()["collision_stages" if is_collision else "default_stages"]
