"""A regular grid as a mesh: one vertex a cell, at the cell's centre, one quad between four."""

import bpy
import numpy as np


def positions(grid, offset, elevation, scale):
    """Vertex positions (ny * nx, 3), float32, in local units.

    `offset` is the grid's lower-left corner in metres, `scale` local units a metre (across, up).
    """
    ny, nx = elevation.shape
    cell = grid["cell_size"]
    result = np.empty((ny, nx, 3), np.float32)
    result[..., 0] = (offset[0] + (np.arange(nx) + 0.5) * cell) * scale[0]
    result[..., 1] = ((offset[1] + (np.arange(ny) + 0.5) * cell) * scale[0])[:, None]
    np.multiply(elevation, scale[1], out=result[..., 2], casting="same_kind")
    return result


def has_topology(mesh, nx, ny):
    return (
        list(mesh.get("orogen_grid", ())) == [nx, ny]
        and len(mesh.vertices) == nx * ny
        and len(mesh.polygons) == (nx - 1) * (ny - 1)
    )


def build_topology(mesh: bpy.types.Mesh, nx, ny):
    """Replaces the mesh's geometry by the grid's; positions are to be set afterwards."""
    corners = np.arange(nx * ny, dtype=np.int32).reshape(ny, nx)
    quads = np.stack(
        [corners[:-1, :-1], corners[:-1, 1:], corners[1:, 1:], corners[1:, :-1]], axis=-1
    )
    count = (nx - 1) * (ny - 1)
    mesh.clear_geometry()
    mesh.vertices.add(nx * ny)
    mesh.loops.add(4 * count)
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", np.arange(0, 4 * count, 4, dtype=np.int32))
    mesh.attributes[".corner_vert"].data.foreach_set("value", quads.ravel())
    mesh.update(calc_edges=True)
    mesh["orogen_grid"] = [nx, ny]


def set_positions(mesh, values):
    mesh.attributes["position"].data.foreach_set("vector", values.ravel())
    mesh.update()
