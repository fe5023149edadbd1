"""A terrain cut into tiles, made coarser, closed to a body: children of the terrain, in its own
units. They are its ground as it stands; another scale or growth does not change them."""

import bpy
import numpy as np

from . import children, grid_mesh, pieces, tin_mesh
from . import ground as grounds
from .terrain_mesh import NotNow

TILES, LODS, SOLID, DECIMATED, TIN = "tiles", "lods", "solid", "decimated", "tin"


def split(terrain, count, skirt_depth):
    """`count` tiles along each side; neighbours share their border. `skirt_depth` in metres."""
    ground = _ground(terrain)
    if count > min(ground.shape) - 1:
        raise NotNow(f"{count} tiles a side are more than the ground has faces")
    rows, columns = (np.rint(np.linspace(0, n - 1, count + 1)).astype(int) for n in ground.shape)
    wanted = {}
    for i, (south, north) in enumerate(zip(rows[:-1], rows[1:], strict=True)):
        for j, (west, east) in enumerate(zip(columns[:-1], columns[1:], strict=True)):
            wanted[f"tile {i} {j}"] = np.arange(south, north + 1), np.arange(west, east + 1)
    return _write(terrain, TILES, ground, wanted, skirt_depth)


def make_coarser(terrain, levels, skirt_depth):
    """Copies of every 2nd, 4th ... row and column, and always the last ones."""
    ground = _ground(terrain)
    if 2**levels > max(ground.shape) - 1:
        raise NotNow(f"{levels} levels are more than the ground has rows for")
    wanted = {
        f"LOD {k}": tuple(np.unique([*range(0, n, 2**k), n - 1]) for n in ground.shape)
        for k in range(1, levels + 1)
    }
    return _write(terrain, LODS, ground, wanted, skirt_depth)


def close(terrain, depth):
    """A body with walls and a floor, `depth` metres below the lowest ground."""
    ground = _ground(terrain)
    all_of_it = tuple(np.arange(n) for n in ground.shape)
    return _write(terrain, SOLID, ground, {SOLID: all_of_it}, depth, closed=True)


def decimate(terrain, ratio):
    """The terrain's own mesh once more, with Blender's modifier on it: it follows the terrain."""
    (ob,) = children.renew(terrain, DECIMATED, [DECIMATED], lambda _: terrain.data).values()
    modifier = ob.modifiers.get("Decimate") or ob.modifiers.new("Decimate", "DECIMATE")
    modifier.ratio = ratio
    grounds.dress(ob, terrain)
    return ob


def triangulate(terrain, arrays):
    """The triangles that the terrain grew on: small where it is rough."""
    ground = _ground(terrain)
    (ob,) = children.renew(terrain, TIN, [TIN], bpy.data.meshes.new).values()
    tin_mesh.write(ob.data, terrain, ground, **arrays)
    grounds.dress(ob, terrain)


def _write(terrain, role, ground, wanted, depth, closed=False):
    base = None
    if depth > 0:
        base = ground.positions[:, 2].min() - depth * terrain.orogen.local_scale()[1]
    objects = children.renew(terrain, role, wanted, bpy.data.meshes.new)
    for part, (rows, columns) in wanted.items():
        source = pieces.indices(rows, columns, ground.shape[1])
        pieces.write(objects[part].data, ground, source, base, closed)
        grounds.dress(objects[part], terrain)
    return list(objects.values())


def _ground(terrain):
    nx, ny = terrain.data["orogen_grid"]
    if not grid_mesh.has_topology(terrain.data, nx, ny):
        raise NotNow("The terrain's mesh was edited: grow it anew first")
    if min(nx, ny) < 2:
        raise NotNow("The ground has no faces")
    return grounds.read(terrain)
