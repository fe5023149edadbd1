"""What a host shows of plates while they are drawn: an answer within milliseconds, in JSON."""

import numpy as np

from . import _core, tectonics

CELLS = 320  # along the longer side


def describe_gestures(request):
    """Of each plate, in order: the rigid motion that is nearest to its arrows, the arrows that this
    makes of them, and its hull. Where there is a `size`: the borders between the influence regions
    too, segments (n, 4) from x, y to x, y; none while the plates' rigid parts meet, which `problem`
    then says."""
    plates = [tectonics.rigid_plates([plate])[0] for plate in request["plates"]]
    answer = {"plates": [_describe(plate) for plate in plates], "borders": [], "problem": ""}
    if "size" not in request:
        return answer
    grid = _grid(request["origin"], request["size"])
    try:
        apart = tectonics.rigid_plates(request["plates"])
        regions = tectonics.compression_field(apart, grid, 1).influence
    except _core.InputError as error:
        answer["problem"] = str(error)
    else:
        answer["borders"] = np.round(borders(regions, grid), 1).tolist()
    return answer


def borders(regions, grid):
    """Segments (n, 4) in metres between cells that differ. Through a square of four cells' centres
    they run straight from side to side, or from three and more sides to its middle."""
    a, b = regions[:-1, :-1], regions[:-1, 1:]
    c, d = regions[1:, 1:], regions[1:, :-1]
    rows, columns = np.nonzero((a != b) | (a != c) | (a != d))
    a, b, c, d = (corner[rows, columns] for corner in (a, b, c, d))
    crossed = np.stack([a != b, b != c, c != d, d != a], axis=-1)
    sides = np.array([(0.5, 0.0), (1.0, 0.5), (0.5, 1.0), (0.0, 0.5)])
    square = np.column_stack([columns, rows]) + 0.5
    passes = crossed.sum(axis=-1, keepdims=True) == 2
    ends = (square[:, None] + sides)[crossed & passes].reshape(-1, 4)
    joint, side = np.nonzero(crossed & ~passes)
    joints = np.hstack([square[joint] + sides[side], square[joint] + 0.5])
    return np.vstack([ends, joints]) * grid.cell_size + np.tile(grid.origin, 2)


def _describe(plate):
    return {
        "angle": plate.angle,
        "translation": plate.translation,
        "arrows": plate.arrows.tolist(),
        "hull": plate.hull.tolist(),
        "residual_m": plate.residual_m,
    }


def _grid(origin, size):
    cell = max(size) / CELLS
    nx, ny = (max(2, round(side / cell)) for side in size)
    return _core.Grid(nx, ny, cell, tuple(origin))
