"""The sea's surface: a plane at height 0, a child of the terrain."""

import bpy
import numpy as np

from ..material import sea_material
from . import surroundings
from .roles import ROLE, with_role


def of(terrain):
    return next(iter(with_role(terrain, "sea")), None)


def is_shown(terrain):
    plane = of(terrain)
    return plane is not None and not plane.hide_render


def update(terrain, settings, below_sea):
    """Makes the plane where ground lies below the sea, and lays it over the terrain's rectangle, at
    the scale of the settings."""
    plane = of(terrain)
    if plane is None and not below_sea:
        return
    if plane is None:
        plane = _new(terrain)
    plane.hide_render = not below_sea
    plane.hide_viewport = not below_sea
    _fit(plane.data, terrain.data, settings.local_scale()[0], surroundings.reach(terrain))


def hide_from_view(terrain, hidden):
    """Takes sea and surroundings out of the viewport, not out of the picture, or puts them back."""
    for ob in filter(None, (of(terrain), surroundings.of(terrain))):
        ob.hide_viewport = hidden or ob.hide_render


def _new(terrain):
    name = f"{terrain.name} Sea"
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(0, 0, 0)] * 4, [], [(0, 1, 2, 3)])
    mesh.materials.append(sea_material.ensure())
    plane = bpy.data.objects.new(name, mesh)
    plane[ROLE] = "sea"
    plane.parent = terrain
    plane.hide_select = True
    for collection in terrain.users_collection:
        collection.objects.link(plane)
    return plane


def _fit(mesh, ground, across, reach):
    """`reach`: how many times as large as the terrain's rectangle."""
    count, corner = np.array(ground["orogen_grid"]), np.array(ground["orogen_offset"])
    cell = ground["orogen_cell_size"]
    middle, half = corner + 0.5 * count * cell, 0.5 * (count - 1) * cell * reach
    (left, bottom), (right, top) = (middle - half) * across, (middle + half) * across
    corners = [left, bottom, 0, right, bottom, 0, right, top, 0, left, top, 0]
    mesh.vertices.foreach_set("co", corners)
    mesh.update()
