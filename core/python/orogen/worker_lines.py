"""Lines on a terrain, as a worker hands them over: traces of horizons, folds, rivers.

A set of lines is `points` (n, 3) in metres, counted from the grid's lower-left corner, `starts`
(k), where each line's points begin, and `closed` (k), 1 for a line whose last point joins its
first.
"""

import numpy as np

from . import _core, hydrology
from .worker_files import rocks_of

LEAST_AREA_M2 = 5e6  # from which on a river is drawn


def traces(terrain, _request):
    """Where each horizon comes to light."""
    rocks = rocks_of(terrain)
    found = {}
    for k, name in enumerate(horizon_names(rocks)):
        lines = rocks.horizon_traces(k)
        if lines:
            found[f"trace of {k} {name}"] = _joined(lines)
    return found


def folds(terrain, _request):
    """Crests and troughs of the layers that folded, laid on the ground; what lies beside the map is
    cut off."""
    if not terrain.folds:
        raise _core.InputError("folds: no layers fold in this recipe")
    found = {}
    for fold in terrain.folds:
        skeleton = fold["skeleton"]
        for kind, lines in (("crests", skeleton.top), ("troughs", skeleton.bottom)):
            name = f"{kind} of layer {fold['layer']}, phase {fold['phase']}"
            pieces = [piece for line in lines for piece in _within(terrain.grid, line)]
            if pieces:
                found[name] = _joined([on_ground(terrain, piece) for piece in pieces])
    return found


def _within(grid, line):
    """The stretches (n, 2) of a fold that lie on the grid, in steps of a cell or less."""
    corners = np.vstack([line.points, line.points[:1]]) if line.closed else line.points
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(corners, axis=0).T))])
    between = np.arange(0.0, along[-1], grid.cell_size)
    at = np.union1d(along, between)
    places = np.column_stack([np.interp(at, along, axis) for axis in corners.T])
    local = (places - grid.origin) / grid.cell_size
    inside = ((local >= 0) & (local <= [grid.nx, grid.ny])).all(axis=1)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], inside, [0]])))
    return [places[a:b] for a, b in edges.reshape(-1, 2) if b - a > 1]


def rivers(terrain, request):
    """The network of rivers that drain `least_area_m2` or more; each line runs down to where it
    meets another, or the sea."""
    if "drainage_area" not in terrain:
        raise _core.InputError("rivers: the terrain has no field 'drainage_area'")
    grid = terrain.grid
    least = request.get("least_area_m2", LEAST_AREA_M2)
    elevation = terrain["elevation"]
    leaves = _base_level(terrain)
    flow = hydrology.route_flow(elevation, leaves, grid.cell_size)
    receivers = flow.receivers().ravel()
    area = hydrology.drainage_area(flow).ravel()
    lines = [_cell_centres(grid, line) for line in river_lines(receivers, area, least)]
    if not lines:
        raise _core.InputError(f"rivers: none drains {least * 1e-6:g} km2 or more")
    heights = elevation.ravel()
    for line, cells in lines:
        line[:, 2] = heights[cells]
    return {"rivers": _joined([line for line, _ in lines])}


def river_lines(receivers, area, least):
    """Lists of cells, from springs and joints down. At a joint the largest of the tributaries goes
    on; the others end there."""
    wet = np.flatnonzero(area >= least)
    wet = wet[np.argsort(-area[wet], kind="stable")]
    goes_on = {}  # the cell whose river flows through a cell
    for cell in wet.tolist():
        if receivers[cell] != cell:
            goes_on.setdefault(int(receivers[cell]), cell)
    lines = []
    for mouth in wet.tolist():
        below = int(receivers[mouth])
        if below != mouth and goes_on[below] == mouth and area[below] >= least:
            continue  # its river flows on
        line = [below] if below != mouth else []
        while mouth is not None:
            line.append(mouth)
            mouth = goes_on.get(mouth)
        if len(line) > 1:
            lines.append(np.array(line[::-1]))
    return lines


def fold_edges(terrain, _request):
    """The crests of each layer and phase as a network that can be edited: `points` (n, 3), less
    the grid's origin, as high as the layer folds there (m), and `edges` (m, 2). Those whose middle
    lies beside the map are left out."""
    if not terrain.folds:
        raise _core.InputError("fold_edges: no layers fold in this recipe")
    grid, found = terrain.grid, {}
    size = grid.cell_size * np.array([grid.nx, grid.ny])
    for fold in terrain.folds:
        skeleton = fold["skeleton"]
        edges = skeleton.edges[skeleton.choice > 0, :2]
        middles = skeleton.points[edges].mean(axis=1) - grid.origin
        edges = edges[((middles >= 0) & (middles <= size)).all(axis=1)]
        used, ends = np.unique(edges, return_inverse=True)
        points = raised(grid, fold["speed"], skeleton.points[used])
        points[:, 2] *= fold["years"]
        found[f"layer {fold['layer']}, phase {fold['phase']}"] = {
            "points": points.astype(np.float32),
            "edges": ends.reshape(-1, 2).astype(np.int32),
        }
    return found


def on_ground(terrain, places):
    """Points (n, 3), less the grid's origin, on the ground at places (n, 2)."""
    return raised(terrain.grid, terrain["elevation"], places)


def raised(grid, z, places):
    """Points (n, 3), less the grid's origin, as high as a field says at places (n, 2); bilinear."""
    local = np.asarray(places) - np.asarray(grid.origin)
    c, r = np.clip(local / grid.cell_size - 0.5, 0.0, np.array([grid.nx, grid.ny]) - 1.0).T
    c0 = np.minimum(c.astype(int), max(grid.nx - 2, 0))
    r0 = np.minimum(r.astype(int), max(grid.ny - 2, 0))
    c1, r1 = np.minimum(c0 + 1, grid.nx - 1), np.minimum(r0 + 1, grid.ny - 1)
    east, north = c - c0, r - r0
    south_side = z[r0, c0] * (1 - east) + z[r0, c1] * east
    north_side = z[r1, c0] * (1 - east) + z[r1, c1] * east
    return np.column_stack([local, south_side * (1 - north) + north_side * north])


def horizon_names(rocks):
    column = rocks.column
    return [column["basement"]["name"], *(layer["name"] for layer in column["layers"])]


def _base_level(terrain):
    """Where water leaves: the sea, and the map's sides."""
    leaves = np.zeros(terrain.grid.shape, np.int32)
    leaves[[0, -1], :] = leaves[:, [0, -1]] = 1
    if "land" in terrain:
        leaves[terrain["land"] == 0] = 1
    return leaves


def _cell_centres(grid, cells):
    rows, columns = np.divmod(cells, grid.nx)
    points = np.column_stack([columns + 0.5, rows + 0.5, np.zeros(len(cells))])
    return points * [grid.cell_size, grid.cell_size, 1.0], cells


def _joined(lines):
    """Lines one after the other; one that repeats its first point is closed."""
    closed = [len(line) > 3 and np.array_equal(line[0], line[-1]) for line in lines]
    lines = [line[:-1] if ends else line for line, ends in zip(lines, closed, strict=True)]
    starts = np.cumsum([0, *(len(line) for line in lines[:-1])])
    return {
        "points": np.concatenate(lines).astype(np.float32),
        "starts": starts.astype(np.int32),
        "closed": np.array(closed, np.int32),
    }
