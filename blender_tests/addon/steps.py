"""Steps that several tests take. Imported in the process with bpy."""

import importlib
import json

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


COLLISION_ORIGIN = (650_000.0, 5_180_000.0)  # m: as in a national grid


def collision_recipe(**more):
    """Two plates that collide: a recipe without a map."""
    x, y = COLLISION_ORIGIN

    def plate(name, south, north, speed):
        points = [
            (x + e, y + n) for e, n in ((4e3, south), (36e3, south), (36e3, north), (4e3, north))
        ]
        arrows = [(0.0, speed)] * 4
        return {"name": name, "points": points, "arrows": arrows}

    plates = [plate("south", 3e3, 11e3, 3600.0), plate("north", 29e3, 35e3, 0.0)]
    return {
        "orogen": 1,
        "name": "two plates",
        "seed": 3,
        "resolution": 96,
        "extent": {"origin": [x, y], "size": [40e3, 36e3]},
        "phases": [{"years": 5e6, "plates": plates}],
        "column": {"preset": "alps"},
        **more,
    }


def collision(folder, **more):
    """A terrain whose recipe is a file of colliding plates."""
    file = folder / "plates.orogen.json"
    file.write_text(json.dumps(collision_recipe(**more)))
    assert bpy.ops.orogen.load_map(filepath=str(file)) == {"FINISHED"}
    return bpy.context.object


def colors(mesh, name):
    """A colour attribute, linear (n, 4)."""
    data = mesh.attributes[name].data
    values = np.empty(len(data) * 4, np.float32)
    data.foreach_get("color", values)
    return values.reshape(-1, 4)
