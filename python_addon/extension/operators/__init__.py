"""The operators `orogen.*`."""

import bpy

from . import (
    add_rocks,
    add_terrain,
    animate_growth,
    cancel,
    grow,
    live_growth,
    load_map,
    reset_parameters,
    save_recipe,
    seeds,
)

CLASSES = (
    add_rocks.OROGEN_OT_add_block,
    add_rocks.OROGEN_OT_add_section,
    add_rocks.OROGEN_OT_add_horizons,
    add_terrain.OROGEN_OT_add_terrain,
    animate_growth.OROGEN_OT_animate_growth,
    cancel.OROGEN_OT_cancel,
    grow.OROGEN_OT_grow,
    live_growth.OROGEN_OT_keep_growth,
    live_growth.OROGEN_OT_pause_growth,
    load_map.OROGEN_OT_load_map,
    reset_parameters.OROGEN_OT_reset_parameters,
    save_recipe.OROGEN_OT_save_recipe,
    seeds.OROGEN_OT_browse_seeds,
    seeds.OROGEN_OT_pick_seed,
    seeds.OROGEN_OT_clear_seeds,
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.VIEW3D_MT_mesh_add.append(add_terrain.draw_menu)
    bpy.types.TOPBAR_MT_file_import.append(load_map.draw_menu)
    seeds.register_keys()


def unregister():
    seeds.unregister_keys()
    bpy.types.TOPBAR_MT_file_import.remove(load_map.draw_menu)
    bpy.types.VIEW3D_MT_mesh_add.remove(add_terrain.draw_menu)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
