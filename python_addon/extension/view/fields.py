"""The fields that a terrain's mesh holds, as numbers to be shown."""

import json
import re

import numpy as np

from ..declarations import BIOMES, FIELDS, Field
from ..mesh import attributes, colors
from ..titles import title
from . import scales

SLOPE = Field("slope", "float32", "°", "Steepness of the ground")
STRATA = attributes.STRATA_COLOR
LOGARITHMIC = ("drainage_area", "erodibility")
_SHOWN = {"m2": ("km²", 1e-6), "m/yr": ("mm/yr", 1e3), "yr": ("Myr", 1e-6), "1": ("", 1.0)}
_SAMPLES = 100_000  # from which the range is found


def known():
    """All fields that can be shown, by name; the slope in degrees."""
    fields = {field.name: field for field in FIELDS}
    return {**fields, "slope": SLOPE}


def names(mesh):
    """Those that a mesh holds, in the order of the core's declarations."""
    held = set(mesh.get("orogen_fields", ()))
    if "elevation" in held:
        held.add("slope")
    return [name for name in known() if name in held and name in {*mesh.attributes.keys(), "slope"}]


def shown_unit(field):
    return _SHOWN.get(field.unit, (field.unit, 1.0))[0]


def values(mesh, field):
    """A number for each vertex, in the unit that is shown."""
    nx, ny = mesh["orogen_grid"]
    if field.name == "slope":
        elevation = attributes.read(mesh, "elevation", (ny, nx))
        return slope(elevation, mesh["orogen_cell_size"]).ravel()
    if field.type == "int32":
        result = np.empty(nx * ny, np.int32)
        mesh.attributes[field.name].data.foreach_get("value", result)
        return result
    factor = np.float32(_SHOWN.get(field.unit, ("", 1.0))[1])
    return attributes.read(mesh, field.name, (ny, nx)).ravel() * factor


def slope(elevation, cell):
    """In degrees. A terrain of one row has none across it."""
    steps = [
        np.gradient(elevation, cell, axis=axis) if elevation.shape[axis] > 1 else 0.0
        for axis in (0, 1)
    ]
    return np.degrees(np.arctan(np.hypot(*steps))).astype(np.float32)


def usual_range(numbers, logarithmic):
    """The 2nd and the 98th percentile."""
    sample = numbers[:: max(1, len(numbers) // _SAMPLES)]
    if logarithmic:
        sample = sample[sample > 0]
    low, high = np.percentile(sample, (2, 98)) if len(sample) else (0.0, 1.0)
    if not high > low:
        low, high = low - 0.01 * abs(low), low + 0.01 * abs(low) or 1.0
    return float(low), float(high)


def two_sided(low, high):
    """Whether numbers on both sides of 0 matter."""
    return low < 0 < high and min(-low, high) > 0.1 * max(-low, high)


def class_colours(field, numbers):
    """Colours (n, 3), sRGB bytes, for numbers of a field of classes. Biomes have their own."""
    if field.name == "biome":
        return colors.unpack(np.array([biome.color for biome in BIOMES])[numbers])
    return scales.class_colours(numbers)


def class_names(mesh, field):
    """What the numbers of a field of classes mean, as far as it is known."""
    if field.name == "biome":
        return dict(enumerate(title(biome.name) for biome in BIOMES))
    if field.name == "rock_layer":
        return {item["layer"]: item["name"] for item in rocks(mesh)}
    # "... nearby: 0 none, 1 convergent": so the core's sentences say it.
    return {int(k): name for k, name in re.findall(r"(\d+) ([a-z][^,.;:]*)", field.description)}


def rocks(mesh):
    return json.loads(mesh.get(attributes.ROCKS, "[]"))
