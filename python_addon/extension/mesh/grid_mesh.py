"""A regular grid as a mesh: one vertex a cell, at the cell's centre, one quad between four."""

import bpy
import numpy as np


def positions(grid, offset, elevation, scale, first=(0, 0)):
    """Vertex positions (ny * nx, 3), float32, in local units.

    `offset` is the grid's lower-left corner in metres, `scale` local units a metre (across, up).
    `first`: the row and column of the grid that the heights begin with.
    """
    ny, nx = elevation.shape
    cell = grid["cell_size"]
    result = np.empty((ny, nx, 3), np.float32)
    result[..., 0] = (offset[0] + (first[1] + np.arange(nx) + 0.5) * cell) * scale[0]
    result[..., 1] = ((offset[1] + (first[0] + np.arange(ny) + 0.5) * cell) * scale[0])[:, None]
    np.multiply(elevation, scale[1], out=result[..., 2], casting="same_kind")
    return result


def has_topology(mesh, nx, ny):
    return (
        list(mesh.get("orogen_grid", ())) == [nx, ny]
        and len(mesh.vertices) == nx * ny
        and len(mesh.polygons) == (nx - 1) * (ny - 1)
    )


def build_topology(mesh: bpy.types.Mesh, nx, ny):
    """Replaces the mesh's geometry by the grid's; positions are to be set afterwards.

    Edges are written too: Blender would take most of the time to find them.
    """
    vertices = np.arange(nx * ny, dtype=np.int32).reshape(ny, nx)
    along = np.arange((nx - 1) * ny, dtype=np.int32).reshape(ny, nx - 1)  # edges west to east
    across = np.arange(nx * (ny - 1), dtype=np.int32).reshape(ny - 1, nx) + along.size
    edges = _interleaved(vertices[:, :-1], vertices[:, 1:])
    edges = np.concatenate([edges, _interleaved(vertices[:-1], vertices[1:])])
    count = (nx - 1) * (ny - 1)
    mesh.clear_geometry()
    mesh.vertices.add(nx * ny)
    mesh.edges.add(len(edges) // 2)
    mesh.loops.add(4 * count)
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", np.arange(0, 4 * count, 4, dtype=np.int32))
    _set(mesh, ".edge_verts", edges)
    sides = [vertices[:-1, :-1], vertices[:-1, 1:], vertices[1:, 1:], vertices[1:, :-1]]
    _set(mesh, ".corner_vert", _interleaved(*sides))
    sides = [along[:-1], across[:, 1:], along[1:], across[:, :-1]]  # each after its corner
    _set(mesh, ".corner_edge", _interleaved(*sides))
    mesh.update()
    mesh["orogen_grid"] = [nx, ny]


def _interleaved(*arrays):
    return np.stack(arrays, axis=-1).ravel()


def _set(mesh, name, values):
    mesh.attributes[name].data.foreach_set("value", values)


def set_positions(mesh, values):
    mesh.attributes["position"].data.foreach_set("vector", values.ravel())
    mesh.update()
