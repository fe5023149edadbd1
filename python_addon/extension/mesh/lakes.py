"""The surfaces of a terrain's lakes: a child whose faces lie where water stands on the ground, at
the water's height, and reach below the shore so that the ground cuts them off."""

import bpy
import numpy as np

from ..material import sea_material
from . import attributes, children
from .roles import with_role

ROLE = "lakes"


def of(terrain):
    return with_role(terrain, ROLE)


def update(terrain):
    """Makes or rewrites the lakes of a terrain from its mesh; without water there are none."""
    mesh = terrain.data
    water = None
    if "water_depth" in mesh.attributes:
        nx, ny = mesh["orogen_grid"]
        fields = (attributes.read(mesh, name, (ny, nx)) for name in ("elevation", "water_depth"))
        water = surface(*fields, mesh["orogen_cell_size"])
    put(terrain, water, mesh["orogen_offset"])


def put(terrain, surface, offset):
    """`surface`: as the function of that name gives it; `offset`: of the grid's corner (m)."""
    parts = [ROLE] if surface else []
    for ob in children.renew(terrain, ROLE, parts, _new_mesh).values():
        vertices, faces = surface
        ob.data.clear_geometry()
        ob.data.from_pydata(vertices.tolist(), [], faces.tolist())
        ob.data.update()
        children.place(ob, terrain, offset)


def surface(elevation, depth, cell):
    """Vertices (n, 3) in metres from the grid's corner and faces (m, 4); None without water."""
    ny, nx = depth.shape
    level = levels(elevation + depth, depth > 0.0)
    wet = np.isfinite(level)
    corners = np.arange(nx * ny).reshape(ny, nx)
    faces = np.stack(
        [corners[:-1, :-1], corners[:-1, 1:], corners[1:, 1:], corners[1:, :-1]], axis=-1
    ).reshape(-1, 4)
    faces = faces[wet.ravel()[faces].all(axis=1) & (depth > 0.0).ravel()[faces].any(axis=1)]
    if not len(faces):
        return None
    used, faces = np.unique(faces, return_inverse=True)
    row, column = np.divmod(used, nx)
    places = ((column + 0.5) * cell, (row + 0.5) * cell, level.ravel()[used])
    return np.stack(places, axis=-1), faces.reshape(-1, 4)


def levels(surface, wet):
    """Heights of water where it is and one cell farther, else NaN; there the highest beside it."""
    level = np.where(wet, surface, -np.inf)
    padded = np.pad(level, 1, constant_values=-np.inf)
    rows, columns = level.shape
    around = [padded[r : r + rows, c : c + columns] for r in range(3) for c in range(3)]
    level = np.where(wet, surface, np.maximum.reduce(around))
    return np.where(np.isfinite(level), level, np.nan)


def _new_mesh(name):
    mesh = bpy.data.meshes.new(name)
    mesh.materials.append(sea_material.ensure())
    return mesh
