"""The rocks below a terrain as objects: children of the terrain, meshes in metres."""

import bpy

from ..material import strata_material
from . import children, rock_mesh


def write(terrain, kind, meshes):
    """Makes or rewrites the objects of one kind. Sections are added; of the others there is one
    set a terrain."""
    if kind == "section":
        objects = {part: children.add(terrain, kind, part, _new_mesh) for part in meshes}
    else:
        objects = children.renew(terrain, kind, meshes, _new_mesh)
    for part, ob in objects.items():
        rock_mesh.write(ob.data, meshes[part])
        children.place(ob, terrain, terrain.data["orogen_offset"])


def _new_mesh(name):
    mesh = bpy.data.meshes.new(name)
    mesh.materials.append(strata_material.ensure())
    return mesh
