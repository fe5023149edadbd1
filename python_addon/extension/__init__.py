"""Orogen for Blender: draw a map, grow terrain that obeys first-order geology."""

from . import live, operators, panels, properties
from .worker.jobs import jobs

MODULES = (properties, operators, panels, live)


def register():
    for module in MODULES:
        module.register()


def unregister():
    jobs.shutdown()
    for module in reversed(MODULES):
        module.unregister()
