"""Heights of a terrain's ground at places on its plane."""

import numpy as np

from . import attributes
from .roles import own_mesh


class Relief:
    """The ground as it is now. Without one, all heights are 0."""

    def __init__(self, terrain):
        mesh = own_mesh(terrain)
        self._heights = None
        if "orogen_grid" in mesh and "elevation" in mesh.attributes:
            nx, ny = mesh["orogen_grid"]
            if len(mesh.attributes["elevation"].data) == nx * ny:
                self._heights = attributes.read(mesh, "elevation", (ny, nx))
                self._cell, self._offset = mesh["orogen_cell_size"], np.array(mesh["orogen_offset"])

    def at(self, places):
        """Metres at places (n, 2) on the plane (m), bilinear; beyond the ground as at its side."""
        places = np.asarray(places, float).reshape(-1, 2)
        if self._heights is None:
            return np.zeros(len(places))
        ny, nx = self._heights.shape
        cells = (places - self._offset) / self._cell - 0.5
        column, row = np.clip(cells, 0.0, (nx - 1.0, ny - 1.0)).T
        c, r = (np.minimum(at.astype(int), n - 2).clip(0) for at, n in ((column, nx), (row, ny)))
        u, v = column - c, row - r
        right, up = min(1, nx - 1), min(1, ny - 1)
        z = self._heights
        low = (1 - u) * z[r, c] + u * z[r, c + right]
        high = (1 - u) * z[r + up, c] + u * z[r + up, c + right]
        return (1 - v) * low + v * high
