"""Settings of older files brought up to date.

`version` is stored with every terrain. A change of meaning raises VERSION and adds a step here,
under the version it starts from.
"""

import bpy

VERSION = 1
STEPS = {}  # version: function that brings settings from it to the next


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
