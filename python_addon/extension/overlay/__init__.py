"""What the viewport shows over the scene: nothing of it is an object, nothing is rendered."""

from . import features, frame, legend, plates, problems

OVERLAYS = (frame, plates, features, legend, problems)


def register():
    for overlay in OVERLAYS:
        overlay.register()


def unregister():
    for overlay in reversed(OVERLAYS):
        overlay.unregister()
