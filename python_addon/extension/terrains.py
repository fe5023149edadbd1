"""Finding terrain objects. None is kept between events: an undo would leave it dangling."""

import bpy

from .properties.migration import VERSION


def active(context):
    """The terrain that settings and operators mean: the active object, or its parent (the sea)."""
    # A timer may come while the window changes its screen, and then nothing else is known.
    ob = getattr(context, "object", context.view_layer.objects.active)
    while ob is not None and not ob.orogen.is_terrain:
        ob = ob.parent
    return ob


def own(context):
    """The active terrain if it is this file's own, not linked: its inputs can be changed."""
    terrain = active(context)
    return None if terrain is None or terrain.library else terrain


def by_uid(uid):
    return next((ob for ob in bpy.data.objects if ob.session_uid == uid), None)


def add(context, name="Terrain"):
    """A new terrain object, empty, active and selected, at the 3D cursor."""
    ob = new(name)
    ob.location = context.scene.cursor.location
    context.collection.objects.link(ob)
    activate(context, ob)
    return ob


def new(name):
    """A terrain object that is in no scene."""
    ob = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    ob.orogen.is_terrain, ob.orogen.version = True, VERSION
    ob.orogen.example = ob.orogen.example  # takes over what its recipe says
    return ob


def activate(context, ob):
    """Makes it the one object that is active and selected."""
    for other in context.selected_objects:
        other.select_set(False)
    ob.select_set(True)
    context.view_layer.objects.active = ob
