"""Objects of a scene that are there once, whatever terrain the picture is of."""

import bpy

from ..mesh.roles import ROLE


def ensure(scene, terrain, role, new_data):
    """The scene's object of that role, made beside the terrain if there is none."""
    found = next((ob for ob in scene.objects if ob.get(ROLE) == role), None)
    if found is None:
        name = f"Orogen {role.capitalize()}"
        found = bpy.data.objects.new(name, new_data(name))
        found[ROLE] = role
        terrain.users_collection[0].objects.link(found)
    return found
