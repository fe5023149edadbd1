"""Where a section is cut: along what is selected, or straight across the terrain."""

import math

import numpy as np

from ..mesh.terrain_mesh import NotNow
from .lines import read_lines
from .plane import Plane


def find(context, terrain, bearing):
    """Places [(x, y), ...] in metres on the terrain's map. NotNow if none lies on it."""
    mesh, plane = terrain.data, Plane(terrain)
    nx, ny = mesh["orogen_grid"]
    cell, offset = mesh["orogen_cell_size"], np.array(mesh["orogen_offset"])
    size = np.array([nx - 1.0, ny - 1.0]) * cell  # from the first cells' centres to the last ones'

    def from_first_cell(world):
        return plane.metres(world)[:, :2] - offset - 0.5 * cell

    drawn = _drawn(context, terrain)
    if drawn is not None:
        line = inside(from_first_cell(drawn), size, cell)
        if len(line) < 2:
            raise NotNow("The line of the section lies beside the terrain")
    else:
        middle = from_first_cell(context.scene.cursor.location)[0]
        if not ((middle > 0) & (middle < size)).all():
            middle = 0.5 * size
        line = straight(middle, bearing, size)
    return (line + np.array(mesh["orogen_origin"]) + 0.5 * cell).tolist()


def straight(middle, bearing, size):
    """The two ends of a line through `middle` on the rectangle from 0 to `size`."""
    direction = np.array([math.sin(bearing), math.cos(bearing)])
    with np.errstate(divide="ignore", invalid="ignore"):
        reach = np.array([-middle, size - middle]) / direction
    reach = np.where(np.abs(direction) < 1e-9, [[-np.inf], [np.inf]], np.sort(reach, axis=0))
    line = middle + np.outer([reach[0].max(), reach[1].min()], direction)
    return np.clip(line, 0.0, size)


def inside(line, size, step):
    """The longest stretch of a line on the rectangle from 0 to `size`, in pieces up to `step`."""
    pieces = np.hypot(*np.diff(line, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(pieces)])
    count = max(2, min(100_000, int(along[-1] / step) + 2))
    at = np.linspace(0.0, along[-1], count)
    fine = np.stack([np.interp(at, along, line[:, k]) for k in (0, 1)], axis=-1)
    on_map = ((fine >= 0) & (fine <= size)).all(axis=1)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], on_map, [0]])))
    if not len(edges):
        return fine[:0]
    first, last = max(edges.reshape(-1, 2), key=lambda run: run[1] - run[0])
    return fine[first:last]


def _drawn(context, terrain):
    """The first line of the first selected curve or grease pencil in world coordinates, or None."""
    for ob in context.selected_objects:
        if lines := read_lines(ob, context.scene.frame_current):
            return lines[0].points
    return None
