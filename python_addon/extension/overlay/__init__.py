"""What the viewport shows over the scene: nothing of it is an object, nothing is rendered."""

import bpy

from . import features, frame, legend, plates, polygons, problems

IN_SPACE, ON_SCREEN = "POST_VIEW", "POST_PIXEL"
OVERLAYS = (
    (frame, IN_SPACE),
    (polygons, IN_SPACE),
    (plates, IN_SPACE),
    (features, IN_SPACE),
    (legend, ON_SCREEN),
    (problems, ON_SCREEN),
)
_handles = []


def register():
    for overlay, when in OVERLAYS:
        add = bpy.types.SpaceView3D.draw_handler_add
        _handles.append(add(overlay.draw, (), "WINDOW", when))


def unregister():
    while _handles:
        bpy.types.SpaceView3D.draw_handler_remove(_handles.pop(), "WINDOW")
    features.forget()
    polygons.forget()
