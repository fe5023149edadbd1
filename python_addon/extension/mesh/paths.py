"""Paths of files that a .blend refers to."""

import bpy


def relative(file):
    """Relative to the .blend where both lie on one drive, so that they can move together."""
    if not bpy.data.filepath:
        return str(file)
    try:
        return bpy.path.relpath(str(file))
    except ValueError:
        return str(file)
