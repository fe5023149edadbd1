"""Previews that follow the hand: what changed is noticed, a timer grows it anew."""

import bpy

from . import handlers

HANDLERS = (
    ("depsgraph_update_post", handlers.notice_change),
    ("undo_post", handlers.look_again),
    ("redo_post", handlers.look_again),
    ("load_post", handlers.begin_anew),
    ("save_pre", handlers.end_watching),
)


def register():
    for name, handler in HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister():
    handlers.loop.sleep()
    handlers.tiles.sleep()
    for name, handler in reversed(HANDLERS):
        getattr(bpy.app.handlers, name).remove(handler)
