"""The fields of a terrain as named attributes of its vertices."""

import numpy as np

from ..material import biome_colors
from . import colors

STRATA_COLOR = "strata_color"  # comes as 0xRRGGBB (sRGB), becomes a linear colour
BIOME = "biome"
ROCKS = "orogen_rocks"  # JSON of what the layers are called; a property of the mesh
KINDS = {"f": ("FLOAT", np.float32), "i": ("INT", np.int32), "u": ("INT", np.int32)}


def write(mesh, fields):
    """Sets one attribute a field, and removes those of fields that are no more."""
    for name in set(mesh.get("orogen_fields", ())) - set(fields):
        for of_field in (name, biome_colors.ATTRIBUTE) if name == BIOME else (name,):
            if stale := mesh.attributes.get(of_field):
                mesh.attributes.remove(stale)
    for name, values in fields.items():
        _write_field(mesh, name, values)
    mesh["orogen_fields"] = list(fields)


def add(mesh, fields):
    """Sets the attributes of fields beside those that are there."""
    for name, values in fields.items():
        _write_field(mesh, name, values)
    mesh["orogen_fields"] = list(dict.fromkeys([*mesh.get("orogen_fields", ()), *fields]))


def _write_field(mesh, name, values):
    if name == STRATA_COLOR:
        write_colors(mesh, name, colors.unpack(values), "POINT")
        return
    write_values(mesh, name, values, "POINT")
    if name == BIOME:  # colours blend from vertex to vertex, numbers of biomes do not
        write_linear(mesh, biome_colors.ATTRIBUTE, biome_colors.of(values), "POINT")


def write_values(mesh, name, values, domain):
    kind, dtype = KINDS[values.dtype.kind]
    _ensure(mesh, name, kind, domain)
    data = np.ascontiguousarray(values, dtype).ravel()
    mesh.attributes[name].data.foreach_set("value", data)


def write_colors(mesh, name, rgb, domain):
    """Sets a colour attribute from sRGB bytes (n, 3)."""
    write_linear(mesh, name, colors.to_linear(rgb), domain)


def write_linear(mesh, name, rgba, domain):
    """Sets a colour attribute from linear colours (n, 4)."""
    _ensure(mesh, name, "FLOAT_COLOR", domain)
    mesh.attributes[name].data.foreach_set("color", rgba.ravel())


def read(mesh, name, shape):
    values = np.empty(shape, np.float32)
    mesh.attributes[name].data.foreach_get("value", values.ravel())
    return values


def _ensure(mesh, name, kind, domain):
    attribute = mesh.attributes.get(name)
    if attribute and (attribute.data_type, attribute.domain) != (kind, domain):
        mesh.attributes.remove(attribute)
        attribute = None
    if not attribute:
        mesh.attributes.new(name, kind, domain)
