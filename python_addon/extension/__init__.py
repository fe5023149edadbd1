"""Orogen for Blender: draw a map, grow terrain that obeys first-order geology."""

from . import operators, overlay, panels, properties
from .worker.jobs import jobs

MODULES = (properties, operators, panels, overlay)


def register():
    for module in MODULES:
        module.register()


def unregister():
    jobs.shutdown()
    for module in reversed(MODULES):
        module.unregister()
