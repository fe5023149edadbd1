"""Settings of older files brought up to date.

`version` is stored with every terrain. A change of meaning raises VERSION and adds a step here,
under the version it starts from.
"""

import bpy

FIRST_VERSION = 1  # its files do not say so: Blender keeps no value that is the default
VERSION = 2


def keep_strokes_apart(settings):
    """Every open coast was a ring of its own."""
    settings.input.join_tolerance = 0.0


STEPS = {1: keep_strokes_apart}  # version: function that brings settings from it to the next


def migrate(settings):
    while settings.version < VERSION:
        if step := STEPS.get(settings.version):
            step(settings)
        settings.version += 1


@bpy.app.handlers.persistent
def migrate_file(*_):
    for ob in bpy.data.objects:
        if ob.orogen.is_terrain and not ob.library:
            migrate(ob.orogen)
