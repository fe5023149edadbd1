"""Previews: the same recipe, made so coarse that it follows a hand that draws or moves something.

What makes a preview is declared here and nowhere else. Seed, inputs and stages stay, but for those
OMITTED; the grid has RESOLUTION cells along the longer side, rasters are averaged to as many, and
no parameter of AT_MOST is greater than it says. Where ranges, coasts, folds and plains lie is that
of the terrain. Its valleys, and a tenth or two of the height of mountains between plates, are not:
fewer rivers cut them.
"""

import base64
import dataclasses
import functools
import os

from . import _core, elevation_files
from .pipeline import generate, pack_raster

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
    document = elevation_files.with_files_read(document, "", _averaged_file)
    preview = {**document, "resolution": RESOLUTION, "stages": lightened}
    if isinstance(rasters := document.get("rasters"), dict):
        preview["rasters"] = {name: _averaged(raster) for name, raster in rasters.items()}
    return preview


def _averaged_file(file):
    try:
        state = os.stat(file)
    except OSError:
        return elevation_files.read_elevation(file)  # which says what is wrong
    return _read_averaged(file, state.st_mtime_ns, state.st_size)


@functools.lru_cache(maxsize=16)
def _read_averaged(file, _written, _bytes):
    found = elevation_files.read_elevation(file)
    return dataclasses.replace(found, values=averaged(found.values))


def _averaged(raster):
    """A packed raster with no more values than a preview has cells; another one as it is."""
    import numpy

    try:
        shape = raster["rows"], raster["columns"]
        if max(shape) <= RESOLUTION:
            return raster
        values = numpy.frombuffer(base64.b64decode(raster["float32"]), "<f4").reshape(shape)
    except (TypeError, KeyError, ValueError):  # rows of numbers; or unfit, as the core says
        return raster
    return pack_raster(averaged(values))


def averaged(values):
    """Means of values (rows, columns) over RESOLUTION cells along the longer side; the values
    themselves if there are no more of them."""
    most = max(values.shape)
    if most <= RESOLUTION:
        return values
    for axis, side in enumerate(values.shape):
        values = _means(values, max(1, round(side * RESOLUTION / most)), axis)
    return values.astype("f4")


def _means(values, count, axis):
    """Means over `count` equal pieces of an axis, parts of values included."""
    import numpy

    values = numpy.moveaxis(values, axis, 0)
    n = len(values)
    sums = numpy.zeros((n + 1, *values.shape[1:]))
    numpy.cumsum(values, axis=0, dtype=float, out=sums[1:])
    ends = numpy.linspace(0.0, n, count + 1)
    whole = numpy.minimum(ends.astype(int), n - 1)
    part = (ends - whole)[:, None]
    upto = sums[whole] + part * (sums[whole + 1] - sums[whole])
    return numpy.moveaxis(numpy.diff(upto, axis=0) * (count / n), 0, axis)


@functools.cache
def _schema():
    return _core.schema()


def _lightened(item):
    given = item.get("parameters", {})
    limits = AT_MOST.get(item.get("stage"), {})
    limited = {name: min(given.get(name, limit), limit) for name, limit in limits.items()}
    return {**item, "parameters": {**given, **limited}}


def _default_stages(document):
    """As the core chooses them."""
    if "map" in document:
        kind = "default"
    elif document.get("phases"):
        kind = "collision"
    else:
        rasters = document.get("rasters")
        given = isinstance(rasters, dict) and "elevation" in rasters
        kind = "height" if given else "island"
    return _schema()[f"{kind}_stages"]
