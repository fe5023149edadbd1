"""The fields of a terrain as named attributes of its vertices."""

import numpy as np

KINDS = {"f": ("FLOAT", np.float32), "i": ("INT", np.int32), "u": ("INT", np.int32)}


def write(mesh, fields):
    """Sets one attribute a field, and removes those of fields that are no more."""
    for name in set(mesh.get("orogen_fields", ())) - set(fields):
        if stale := mesh.attributes.get(name):
            mesh.attributes.remove(stale)
    for name, values in fields.items():
        kind, dtype = KINDS[values.dtype.kind]
        _ensure(mesh, name, kind)
        data = np.ascontiguousarray(values, dtype).ravel()
        mesh.attributes[name].data.foreach_set("value", data)
    mesh["orogen_fields"] = list(fields)


def read(mesh, name, shape):
    values = np.empty(shape, np.float32)
    mesh.attributes[name].data.foreach_get("value", values.ravel())
    return values


def _ensure(mesh, name, kind):
    attribute = mesh.attributes.get(name)
    if attribute and (attribute.data_type, attribute.domain) != (kind, "POINT"):
        mesh.attributes.remove(attribute)
        attribute = None
    if not attribute:
        mesh.attributes.new(name, kind, "POINT")
