"""Variations of a terrain, side by side: children of it, each a preview of another seed.

They stand in a square east of the terrain, in its local units at the time; another scale moves and
scales the objects.
"""

import math

import bpy

from . import children, terrain_mesh
from .roles import ROLE, with_role

KIND = "variation"
SEED = "orogen_seed"
PLACE = "orogen_place"  # m, of the middle from the terrain's origin
PITCH = 1.06  # widths from one to the next


def of(terrain):
    return with_role(terrain, KIND)


def write(terrain, grid, meshes):
    """Makes the objects, in place of earlier ones. `meshes`: fields by name, by seed."""
    clear(terrain)
    columns = math.ceil(math.sqrt(len(meshes)))
    size = [PITCH * grid["cell_size"] * grid[n] for n in ("nx", "ny")]
    west, south = terrain_mesh.offset_of(terrain, grid)
    for i, (seed, fields) in enumerate(meshes.items()):
        row, column = divmod(i, columns)
        ob = _new(terrain, int(seed))
        ob[PLACE] = [
            west + (column + 1.5) * size[0],
            south + (0.5 + (columns - 1) / 2 - row) * size[1],
        ]
        ob[children.MADE_FOR] = terrain.orogen.local_scale()
        terrain_mesh.fill(ob, terrain.orogen, grid, fields, terrain_mesh.centred(grid))
        place(ob, terrain)


def clear(terrain):
    for ob in of(terrain):
        for part in (*ob.children, ob):
            bpy.data.meshes.remove(part.data)  # and the object with it


def place_all(terrain):
    for ob in of(terrain):
        place(ob, terrain)


def place(ob, terrain):
    across, _ = terrain.orogen.local_scale()
    x, y = ob[PLACE]
    ob.location = (x * across, y * across, 0.0)
    children.rescale(ob, terrain)


def _new(terrain, seed):
    name = f"Seed {seed}"
    ob = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    ob[ROLE], ob[SEED] = KIND, seed
    ob.parent = terrain
    ob.show_name = True
    for collection in terrain.users_collection:
        collection.objects.link(ob)
    return ob
