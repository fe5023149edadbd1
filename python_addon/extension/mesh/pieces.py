"""Pieces of a terrain's ground as meshes: parts of its grid, with walls or without.

Vertices are the terrain's own to the bit, so pieces that share a border share its vertices' places
and normals.
"""

import numpy as np

from . import ground as grounds
from . import skirt, uv


def indices(rows, columns, width):
    """Vertices (rows, columns) of a grid that is `width` wide."""
    return np.asarray(rows)[:, None] * width + np.asarray(columns)


def write(mesh, ground, source, base=None, closed=False):
    """`source`: vertices of the ground in rows and columns. `base`: height at which walls end, in
    local units; `closed`: with a floor there, as a body."""
    ny, nx = source.shape
    chosen = source.ravel()
    positions, faces = ground.positions[chosen], [skirt.quads(nx, ny)]
    if base is not None:
        rim = skirt.rim(nx, ny)
        feet = positions[rim]
        feet[:, 2] = base
        first_foot = len(positions)
        positions = np.concatenate([positions, feet])
        chosen = np.concatenate([chosen, chosen[rim]])
        faces.append(skirt.walls(rim, first_foot))
        if closed:
            faces.append(skirt.floor(len(rim), first_foot))
    _write_faces(mesh, positions, faces)
    grounds.write_carried(mesh, ground, chosen)
    uv.write(mesh, ground.uv[chosen])
    if closed:
        flat = np.arange(len(mesh.polygons)) >= len(faces[0])
        mesh.polygons.foreach_set("use_smooth", ~flat)
    else:  # walls are shaded as the ground above them, so that they hide a crack and are not seen
        mesh.normals_split_custom_set_from_vertices(ground.normals[chosen])


def write_triangles(mesh, positions, triangles, ground, source):
    """Triangles between places of their own, which carry what vertices of the ground do."""
    _write_faces(mesh, positions, [triangles])
    grounds.write_carried(mesh, ground, source)


def _write_faces(mesh, positions, faces):
    """`faces`: arrays (m, k) of vertices."""
    sizes = np.concatenate([np.full(len(part), part.shape[1]) for part in faces])
    corners = np.concatenate([part.ravel() for part in faces]).astype(np.int32)
    mesh.clear_geometry()
    mesh.vertices.add(len(positions))
    mesh.loops.add(len(corners))
    mesh.polygons.add(len(sizes))
    starts = np.concatenate([[0], np.cumsum(sizes)[:-1]]).astype(np.int32)
    mesh.polygons.foreach_set("loop_start", starts)
    mesh.attributes[".corner_vert"].data.foreach_set("value", corners)
    values = np.ascontiguousarray(positions, np.float32)
    mesh.attributes["position"].data.foreach_set("vector", values.ravel())
    mesh.update(calc_edges=True)
