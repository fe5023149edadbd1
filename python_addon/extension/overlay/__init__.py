"""What the viewport shows over the scene: nothing of it is an object, nothing is rendered."""

from . import features, frame, legend, plates, polygons, problems

OVERLAYS = (frame, polygons, plates, features, legend, problems)


def register():
    for overlay in OVERLAYS:
        overlay.register()


def unregister():
    for overlay in reversed(OVERLAYS):
        overlay.unregister()
