"""Where a terrain's own coordinates lie on its plane.

What is drawn lies where it was drawn. A map from a file is centred on the object, and its middle is
known once it has grown. It is kept until another one lies more than a cell away: the middle of a
coarser grid is a little elsewhere, and what is drawn on the ground must not move for that.
"""

import math

from .roles import own_mesh

KEY = "orogen_middle"  # m, of the grid in its own coordinates; a property of the mesh


def keep(mesh, grid):
    cell = grid["cell_size"]
    now = [grid["origin"][k] + 0.5 * grid[n] * cell for k, n in enumerate(("nx", "ny"))]
    if KEY not in mesh or math.dist(mesh[KEY], now) > cell:
        mesh[KEY] = now


def shift(terrain):
    """From the plane to the terrain's coordinates (m); None where that is not known yet."""
    if terrain.orogen.is_drawn():
        return 0.0, 0.0
    mesh = own_mesh(terrain)
    return tuple(mesh[KEY]) if KEY in mesh else None
