"""The colours of a field on the tiles of large ground, a tile at each tick of a timer.

A tile keeps the legend after which it was coloured: what an undo or another growth brings is known
by it. Borders of tiles have the colours of both; only the slope, which needs neighbours, may differ
there by a shade.
"""

import json

import bpy

from ..material import view_material
from ..mesh import large_ground
from ..mesh.roles import with_role
from . import show

TICK = 0.01  # s


def wake():
    """Something may have changed."""
    if bpy.app.background:  # where no timer fires
        while tick() is not None:
            pass
    elif not bpy.app.timers.is_registered(tick):
        bpy.app.timers.register(tick, first_interval=TICK)


def sleep():
    if bpy.app.timers.is_registered(tick):
        bpy.app.timers.unregister(tick)


def tick():
    """Colours one tile that does not show what its terrain does; None if there is no such tile."""
    for terrain in bpy.data.objects:
        if terrain.orogen.is_terrain and not terrain.library:
            wanted = terrain.data.get(show.LEGEND)
            for tile in with_role(terrain, large_ground.ROLE):
                if tile.mode == "OBJECT" and tile.data.get(show.LEGEND) != wanted:
                    _refresh(tile, show.shown_field(terrain), wanted)
                    return TICK
    return None


def _refresh(tile, field, legend):
    mesh, slot = tile.data, tile.material_slots[0]
    if field is None or legend is None:
        show.clear(mesh)
        slot.link = "DATA"
    else:
        show.colour(mesh, field, json.loads(legend))
        mesh[show.LEGEND] = legend
        slot.link, slot.material = "OBJECT", view_material.ensure()
    tile.update_tag()
