"""What pieces of a terrain's ground are made of: its vertices, and all that they carry."""

from dataclasses import dataclass

import numpy as np

from . import attributes, uv

LOOK = (  # custom properties by which the terrain's material knows it
    "orogen_vertical_exaggeration",
    "orogen_metres_per_unit",
    "orogen_strata",
    "orogen_sea",
    "orogen_biomes",
    "orogen_bare_rock",
)


@dataclass
class Ground:
    shape: tuple[int, int]  # rows, columns
    positions: np.ndarray  # (n, 3), local
    normals: np.ndarray  # (n, 3)
    uv: np.ndarray  # (n, 2)
    values: dict  # of numbers by attribute
    colors: dict  # linear (n, 4) by attribute


def read(terrain):
    mesh = terrain.data
    nx, ny = mesh["orogen_grid"]
    values, colors = {}, {}
    for attribute in mesh.attributes:
        if attribute.domain == "POINT" and not attribute.name.startswith("."):
            if attribute.data_type == "FLOAT_COLOR":
                colors[attribute.name] = _get(attribute, "color", 4, np.float32)
            elif attribute.data_type in ("FLOAT", "INT"):
                dtype = np.float32 if attribute.data_type == "FLOAT" else np.int32
                values[attribute.name] = _get(attribute, "value", 1, dtype)[:, 0]
    normals = np.empty((len(mesh.vertices), 3), np.float32)
    mesh.vertex_normals.foreach_get("vector", normals.ravel())
    positions = _get(mesh.attributes["position"], "vector", 3, np.float32)
    return Ground((ny, nx), positions, normals, uv.of_grid(nx, ny), values, colors)


def write_carried(mesh, ground, source):
    """Writes what the vertices carry; `source` names for each a vertex of the ground."""
    for name, values in ground.values.items():
        attributes.write_values(mesh, name, values[source], "POINT")
    for name, rgba in ground.colors.items():
        attributes.write_linear(mesh, name, rgba[source], "POINT")


def dress(ob, terrain):
    """The terrain's material on a piece, and what tells the material how to look."""
    if not ob.data.materials:
        for material in terrain.data.materials:
            ob.data.materials.append(material)
    for name in LOOK:
        if name in terrain:
            ob[name] = terrain[name]
    active = terrain.data.color_attributes.active_color_name
    if active in ob.data.color_attributes:
        ob.data.color_attributes.active_color_name = active
        ob.data.color_attributes.render_color_index = ob.data.color_attributes.active_color_index
    ob.update_tag()


def _get(attribute, what, width, dtype):
    values = np.empty((len(attribute.data), width), dtype)
    attribute.data.foreach_get(what, values.ravel())
    return values
