"""What is drawn over the 3D view."""

from . import legend

MODULES = (legend,)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
