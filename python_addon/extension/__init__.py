"""Orogen for Blender: draw a map, grow terrain that obeys first-order geology."""

from . import cli_command, live, operators, overlay, panels, properties
from .worker.jobs import jobs

MODULES = (properties, operators, panels, overlay, live, cli_command)


def register():
    for module in MODULES:
        module.register()


def unregister():
    jobs.shutdown()
    for module in reversed(MODULES):
        module.unregister()
