"""Growth as it is watched: a coarse mesh that stands in for the terrain's own. Where running water
wears it, its colours show the water or the change.

The terrain's mesh is untouched meanwhile, and comes back when growth is over or given up.
"""

import bpy

from ..material import terrain_material, view_material
from ..view import show as field_view
from ..view import watched
from . import grid_mesh, terrain_mesh
from .roles import INSTEAD_OF, own_mesh

NAME = "Orogen Growth"


def show(terrain, frame):
    """Shows a frame of growth: a Result with the heights, and what water does."""
    grid, elevation = frame.grid, frame.fields["elevation"]
    mesh = terrain.data if is_shown(terrain) else _begin(terrain)
    if not grid_mesh.has_topology(mesh, grid["nx"], grid["ny"]):
        grid_mesh.build_topology(mesh, grid["nx"], grid["ny"])
    offset, scale = terrain_mesh.offset_of(terrain, grid), terrain.orogen.local_scale()
    grid_mesh.set_positions(mesh, grid_mesh.positions(grid, offset, elevation, scale))
    if watched.has_colours(frame.fields):
        _colour(terrain, mesh, frame.fields)


def _colour(terrain, mesh, fields):
    if field_view.LEGEND not in mesh:
        mesh.materials[0] = view_material.ensure()
        field_view.in_solid_view(bpy.context, True)
    watched.colour(mesh, fields, terrain.orogen.live.watch_shows)


def is_shown(terrain):
    return INSTEAD_OF in terrain.data


def end(terrain):
    """Brings the terrain's own mesh back; not while somebody edits what stands in for it."""
    mesh = terrain.data
    own = own_mesh(terrain)
    if own != mesh and terrain.mode == "OBJECT":
        terrain.data = own
        own.use_fake_user = False
        if field_view.LEGEND in mesh:
            field_view.in_solid_view(bpy.context, field_view.shown_field(terrain) is not None)
        bpy.data.meshes.remove(mesh)


def end_all():
    for ob in bpy.data.objects:
        if ob.orogen.is_terrain and not ob.library and is_shown(ob):
            end(ob)


def _begin(terrain):
    own, mesh = terrain.data, bpy.data.meshes.new(NAME)
    mesh[INSTEAD_OF] = own.name
    own.use_fake_user = True  # nothing must drop it
    mesh.materials.append(terrain_material.ensure())
    terrain.data = mesh
    return mesh
