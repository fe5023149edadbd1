"""Ground with too many cells for one mesh: tiles that share their borders, children of the terrain,
and a coarse mesh of the terrain's own, which is not rendered and shows in the viewport as a box.

Tiles are made one at a time, out of sight, so that the window lives on; the last step puts them in
place. Until then, and if it is given up, the terrain is as it was.
"""

import bpy
import numpy as np

from . import attributes, children, grid_mesh
from . import ground as grounds
from .roles import with_role

ROLE = "ground tile"
MOST_CELLS = 2048 * 2048  # of a terrain in one mesh
TILE = 512  # cells along a side: Blender makes the edges of one in less than 0.1 s
COARSE = 512  # vertices along the longer side of the terrain's own mesh, at most
TOO_LARGE = "Ground in tiles is too large for this: grow it with 2048 x 2048 cells at most"


def is_large(grid):
    return grid["nx"] * grid["ny"] > MOST_CELLS


def coarsened(grid, fields, offset):
    """Every k-th row and column, as a grid, fields and offset of their own."""
    step = -(-max(grid["nx"], grid["ny"]) // COARSE)
    few = {name: values[::step, ::step] for name, values in fields.items()}
    ny, nx = few["elevation"].shape
    shift = 0.5 * grid["cell_size"] * (1 - step)
    coarse = {**grid, "nx": nx, "ny": ny, "cell_size": step * grid["cell_size"]}
    coarse["origin"] = [value + shift for value in grid["origin"]]
    return coarse, few, [value + shift for value in offset]


class Tiles:
    """Meshes that are being made; their names, as no mesh is kept between events."""

    def __init__(self):
        self._names = {}

    def make(self, grid, fields, offset, scale):
        """A generator that makes one mesh at each step."""
        for row in range(0, grid["ny"] - 1, TILE):
            for column in range(0, grid["nx"] - 1, TILE):
                mesh = bpy.data.meshes.new(f"Tile {row // TILE} {column // TILE}")
                self._names[f"ground {row // TILE} {column // TILE}"] = mesh.name
                few = _part(fields, row, column)
                ny, nx = few["elevation"].shape
                grid_mesh.build_topology(mesh, nx, ny)
                mesh["orogen_cell_size"] = grid["cell_size"]
                attributes.write(mesh, few)
                place = grid_mesh.positions(grid, offset, few["elevation"], scale, (row, column))
                grid_mesh.set_positions(mesh, place)
                yield

    def put(self, terrain):
        """Puts them in place of the tiles that were there."""
        objects = children.renew(terrain, ROLE, self._names, bpy.data.meshes.new)
        for part, ob in objects.items():
            older, ob.data = ob.data, bpy.data.meshes[self._names[part]]
            bpy.data.meshes.remove(older)
            ob[children.MADE_FOR] = terrain.orogen.local_scale()
            grounds.dress(ob, terrain)
        self._names = {}
        place_all(terrain)
        show(terrain)

    def drop(self):
        for name in self._names.values():
            if mesh := bpy.data.meshes.get(name):
                bpy.data.meshes.remove(mesh)
        self._names = {}


def add(terrain, fields):
    """Attributes of fields of the whole ground, beside those that the tiles have."""
    for ob in with_role(terrain, ROLE):
        row, column = (TILE * int(number) for number in ob[children.PART].split()[1:])
        attributes.add(ob.data, _part(fields, row, column))


def _part(fields, row, column):
    part = np.s_[row : row + TILE + 1, column : column + TILE + 1]
    return {name: values[part] for name, values in fields.items()}


def place_all(terrain):
    """Another scale of the terrain moves no vertex of its tiles."""
    for ob in with_role(terrain, ROLE):
        children.rescale(ob, terrain)


def remove(terrain):
    for ob in with_role(terrain, ROLE):
        children.remove(ob)
    show(terrain)


def is_tiled(terrain):
    return bool(with_role(terrain, ROLE))


def show(terrain, to_paint=False):
    """The tiles, or the terrain's own mesh where there are none and where it is painted on."""
    tiles = with_role(terrain, ROLE)
    for ob in tiles:
        ob.hide_viewport = to_paint
    look = bool(tiles) + 2 * to_paint
    if terrain.get("orogen_tiled", 0) != look:
        terrain.display_type = "BOUNDS" if tiles and not to_paint else "TEXTURED"
        terrain.hide_render = bool(tiles)
        terrain["orogen_tiled"] = look
