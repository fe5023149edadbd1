"""What belongs to a terrain and stands under it: its children, each with a role and a part.

The data of most is in metres. A child's location and scale put it where the terrain stands, so that
another scale of the terrain moves no vertex.
"""

import bpy

from .roles import ROLE, with_role

PART = "orogen_part"
OFFSET = "orogen_offset"  # m, of the data's origin from the terrain's; of children in metres
MADE_FOR = "orogen_made_for"  # the terrain's scale at the time; of children in local units


def renew(terrain, role, parts, new_data):
    """The children of a role by part: those that are there, new ones for the parts that are not,
    with `new_data(name)`. Others of the role go."""
    older = {ob[PART]: ob for ob in with_role(terrain, role)}
    for part in set(older) - set(parts):
        remove(older.pop(part))
    return {part: older.get(part) or add(terrain, role, part, new_data) for part in parts}


def add(terrain, role, part, new_data):
    name = f"{terrain.name} {part.capitalize() if part == role else part}"
    ob = bpy.data.objects.new(name, new_data(name))
    ob[ROLE], ob[PART] = role, part
    ob.parent = terrain
    for collection in terrain.users_collection:
        collection.objects.link(ob)
    return ob


def remove(ob):
    data = ob.data
    bpy.data.objects.remove(ob)
    if data and not data.users:
        bpy.data.batch_remove([data])


def place(ob, terrain, offset=None):
    """Puts a child whose data is in metres where the terrain stands. `offset`: OFFSET, to be kept;
    else the one that is kept."""
    if offset is not None:
        ob[OFFSET] = list(offset)
    across, up = terrain.orogen.local_scale()
    x, y = ob[OFFSET]
    ob.location = (x * across, y * across, 0.0)
    ob.scale = (across, across, up)


def place_all(terrain):
    for ob in terrain.children:
        if OFFSET in ob:
            place(ob, terrain)


def rescale(ob, terrain):
    """Lets a child whose data is in local units follow another scale of the terrain."""
    across, up = terrain.orogen.local_scale()
    ob.scale = (across / ob[MADE_FOR][0], across / ob[MADE_FOR][0], up / ob[MADE_FOR][1])
