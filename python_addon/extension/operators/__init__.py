"""The operators `orogen.*`."""

import bpy

from . import (
    add_rocks,
    add_terrain,
    animate_growth,
    cancel,
    draw,
    edit_recipe,
    grow,
    load_map,
    plates,
    presets,
    problems,
    reset_parameters,
    save_recipe,
)

CLASSES = (
    add_rocks.OROGEN_OT_add_block,
    add_rocks.OROGEN_OT_add_section,
    add_rocks.OROGEN_OT_add_horizons,
    add_terrain.OROGEN_MT_add_terrain,
    add_terrain.OROGEN_OT_add_inputs,
    add_terrain.OROGEN_OT_add_terrain,
    animate_growth.OROGEN_OT_animate_growth,
    cancel.OROGEN_OT_cancel,
    draw.OROGEN_OT_draw,
    edit_recipe.OROGEN_OT_edit_recipe,
    grow.OROGEN_OT_grow,
    load_map.OROGEN_OT_load_map,
    plates.OROGEN_OT_add_arrow,
    plates.OROGEN_OT_add_plate,
    plates.OROGEN_OT_remove_plate,
    presets.OROGEN_MT_terrain_presets,
    presets.OROGEN_OT_add_terrain_preset,
    presets.OROGEN_OT_load_preset,
    problems.OROGEN_OT_check_drawing,
    problems.OROGEN_OT_show_problem,
    reset_parameters.OROGEN_OT_reset_parameters,
    save_recipe.OROGEN_OT_save_recipe,
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.utils.register_preset_path(presets.folder())
    bpy.types.VIEW3D_MT_mesh_add.append(add_terrain.draw_menu)
    bpy.types.TOPBAR_MT_file_import.append(load_map.draw_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(load_map.draw_menu)
    bpy.types.VIEW3D_MT_mesh_add.remove(add_terrain.draw_menu)
    bpy.utils.unregister_preset_path(presets.folder())
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
