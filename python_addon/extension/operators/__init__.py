"""The operators `orogen.*`."""

import bpy

from . import (
    add_rocks,
    add_terrain,
    animate_growth,
    cancel,
    copy_system_report,
    grow,
    load_map,
    reset_parameters,
    save_recipe,
)

CLASSES = (
    add_rocks.OROGEN_OT_add_block,
    add_rocks.OROGEN_OT_add_section,
    add_rocks.OROGEN_OT_add_horizons,
    add_terrain.OROGEN_OT_add_terrain,
    animate_growth.OROGEN_OT_animate_growth,
    cancel.OROGEN_OT_cancel,
    copy_system_report.OROGEN_OT_copy_system_report,
    grow.OROGEN_OT_grow,
    load_map.OROGEN_OT_load_map,
    reset_parameters.OROGEN_OT_reset_parameters,
    save_recipe.OROGEN_OT_save_recipe,
)


def register():
    for cls in CLASSES:
        if cls.__doc__:
            cls.__doc__ = " ".join(cls.__doc__.split())  # a tooltip would show the line's break
        bpy.utils.register_class(cls)
    bpy.types.VIEW3D_MT_mesh_add.append(add_terrain.draw_menu)
    bpy.types.TOPBAR_MT_file_import.append(load_map.draw_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(load_map.draw_menu)
    bpy.types.VIEW3D_MT_mesh_add.remove(add_terrain.draw_menu)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
