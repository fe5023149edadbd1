"""The triangles that mountains grew on, as a mesh in the terrain's own units."""

import numpy as np

from . import pieces, uv


def write(mesh, terrain, ground, vertices, triangles):
    """`vertices` (n, 3) in metres, counted from the grid's lower-left corner."""
    (nx, ny), cell = terrain.data["orogen_grid"], terrain.data["orogen_cell_size"]
    across, up = terrain.orogen.local_scale()
    positions = (vertices + [*terrain.data["orogen_offset"], 0.0]) * [across, across, up]
    cells = np.clip(vertices[:, :2] // cell, 0, [nx - 1, ny - 1]).astype(int)
    source = cells[:, 1] * nx + cells[:, 0]
    pieces.write_triangles(mesh, positions, triangles, ground, source)
    uv.write(mesh, (vertices[:, :2] / [nx * cell, ny * cell]).astype(np.float32))
