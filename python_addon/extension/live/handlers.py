"""Events of Blender that may change what a preview shows."""

import bpy

from ..mesh import growing_mesh
from ..scene import ground
from ..view import tiles
from . import loop

INPUTS = {  # kinds of data whose change may be one of a terrain's inputs
    "OBJECT",
    "COLLECTION",
    "SCENE",
    "GREASEPENCIL",
    "GREASEPENCIL_V3",
    "CURVE",
    "CURVES",
}


@bpy.app.handlers.persistent
def notice_change(_scene, depsgraph):
    """A preview's own mesh is among what changed. It does no harm: a recipe that is grown already
    is not grown again."""
    ground.notice_change(depsgraph)
    if not any(update.id.id_type in INPUTS for update in depsgraph.updates):
        return
    loop.note_edit()
    if loop.is_watching():
        loop.wake()
    elif loop.watches_inputs():
        loop.wake_inputs()


@bpy.app.handlers.persistent
def look_again(*_):
    growing_mesh.end_all()
    ground.forget()
    loop.forget_edits()
    loop.note_edit()
    loop.wake()
    tiles.wake()


@bpy.app.handlers.persistent
def begin_anew(*_):
    loop.reset()
    loop.note_edit()
    growing_mesh.end_all()
    ground.forget()
    loop.wake()
    tiles.wake()


@bpy.app.handlers.persistent
def end_watching(*_):
    """What is saved is the terrain, not a picture of its growth."""
    growing_mesh.end_all()
