"""The rocks below a terrain as objects: children of the terrain, meshes in metres.

A child's location and scale put it where the terrain stands, so that another scale moves no vertex.
"""

import bpy

from ..material import strata_material
from . import rock_mesh
from .roles import ROLE, with_role

PART = "orogen_part"
OFFSET = "orogen_offset"  # m, of the mesh's origin from the terrain's


def write(terrain, kind, meshes):
    """Makes or rewrites the objects of one kind. Sections are added; of the others there is one
    set a terrain."""
    older = {} if kind == "section" else {ob[PART]: ob for ob in with_role(terrain, kind)}
    for part in set(older) - set(meshes):
        bpy.data.meshes.remove(older.pop(part).data)  # and the object with it
    for part, arrays in meshes.items():
        ob = older.get(part) or _new(terrain, kind, part)
        rock_mesh.write(ob.data, arrays)
        ob[OFFSET] = list(terrain.data["orogen_offset"])
        place(ob, terrain)


def place_all(terrain):
    for kind in ("block", "section", "horizons"):
        for ob in with_role(terrain, kind):
            place(ob, terrain)


def place(ob, terrain):
    across, up = terrain.orogen.local_scale()
    x, y = ob[OFFSET]
    ob.location = (x * across, y * across, 0.0)
    ob.scale = (across, across, up)


def _new(terrain, kind, part):
    name = f"{terrain.name} {part.capitalize() if part == kind else part}"
    mesh = bpy.data.meshes.new(name)
    mesh.materials.append(strata_material.ensure())
    ob = bpy.data.objects.new(name, mesh)
    ob[ROLE], ob[PART] = kind, part
    ob.parent = terrain
    for collection in terrain.users_collection:
        collection.objects.link(ob)
    return ob
