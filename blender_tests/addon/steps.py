"""Steps that several tests take. Imported in the process with bpy."""

import importlib

import bpy
import numpy as np

ADDON = "bl_ext.user_default.orogen"
CORSICA = "corsica"


def addon(name=""):
    """A module of the installed extension."""
    return importlib.import_module(f"{ADDON}.{name}" if name else ADDON)


def new_terrain(**settings):
    bpy.ops.orogen.add_terrain()
    terrain = bpy.context.object
    for name, value in settings.items():
        setattr(terrain.orogen, name, value)
    return terrain


def corsica(resolution=128, **settings):
    return new_terrain(source="EXAMPLE", example=CORSICA, resolution=resolution, **settings)


def grow():
    assert bpy.ops.orogen.grow() == {"FINISHED"}


def positions(terrain):
    values = np.empty(len(terrain.data.vertices) * 3, np.float32)
    terrain.data.attributes["position"].data.foreach_get("vector", values)
    return values.reshape(-1, 3)


def attribute(terrain, name):
    attribute = terrain.data.attributes[name]
    kind = {"FLOAT": np.float32, "INT": np.int32}[attribute.data_type]
    values = np.empty(len(terrain.data.vertices), kind)
    attribute.data.foreach_get("value", values)
    return values


def refused(operator, **arguments):
    """The message with which an operator refuses."""
    try:
        operator(**arguments)
    except RuntimeError as error:
        return str(error)
    raise AssertionError("the operator did not refuse")
