"""The operators `orogen.*`."""

import bpy

from .. import preset_files
from . import (
    add_lines,
    add_meshes,
    add_nodes,
    add_rocks,
    add_terrain,
    add_volume,
    animate_growth,
    cancel,
    copy_system_report,
    draw,
    draw_arrow,
    drop_map,
    edit_recipe,
    export_section,
    export_terrain,
    feature_curves,
    fold_edits,
    grow,
    layers,
    live_growth,
    load_map,
    make_ready_scene,
    paint,
    plates,
    polygons,
    presets,
    problems,
    reset_parameters,
    save_asset_library,
    save_map,
    save_recipe,
    seeds,
    set_up_scene,
    springs,
)

CLASSES = (
    add_lines.OROGEN_OT_add_traces,
    add_lines.OROGEN_OT_add_folds,
    add_lines.OROGEN_OT_add_rivers,
    add_meshes.OROGEN_OT_split_tiles,
    add_meshes.OROGEN_OT_add_lods,
    add_meshes.OROGEN_OT_add_solid,
    add_meshes.OROGEN_OT_add_decimated,
    add_meshes.OROGEN_OT_add_uv,
    add_meshes.OROGEN_OT_add_tin,
    add_nodes.OROGEN_OT_add_scatter,
    add_nodes.OROGEN_OT_add_water,
    add_rocks.OROGEN_OT_add_block,
    add_rocks.OROGEN_OT_add_section,
    add_rocks.OROGEN_OT_add_horizons,
    add_terrain.OROGEN_MT_add_terrain,
    add_terrain.OROGEN_OT_add_inputs,
    add_terrain.OROGEN_OT_add_terrain,
    add_volume.OROGEN_OT_add_volume,
    animate_growth.OROGEN_OT_animate_growth,
    cancel.OROGEN_OT_cancel,
    copy_system_report.OROGEN_OT_copy_system_report,
    drop_map.OROGEN_FH_map,
    export_section.OROGEN_OT_export_section,
    export_section.OROGEN_OT_add_section_picture,
    export_terrain.OROGEN_OT_export_terrain,
    draw.OROGEN_OT_draw,
    draw_arrow.OROGEN_OT_draw_arrow,
    edit_recipe.OROGEN_OT_edit_recipe,
    feature_curves.OROGEN_OT_add_feature_curve,
    feature_curves.OROGEN_OT_set_feature_kind,
    feature_curves.OROGEN_OT_lay_feature_curve,
    feature_curves.OROGEN_OT_forget_point_values,
    fold_edits.OROGEN_OT_edit_folds,
    fold_edits.OROGEN_OT_clear_fold_edits,
    grow.OROGEN_OT_grow,
    layers.OROGEN_OT_add_layer,
    layers.OROGEN_OT_copy_column,
    layers.OROGEN_OT_move_layer,
    layers.OROGEN_OT_remove_layer,
    live_growth.OROGEN_OT_keep_growth,
    live_growth.OROGEN_OT_pause_growth,
    load_map.OROGEN_OT_load_map,
    make_ready_scene.OROGEN_OT_make_ready_scene,
    paint.OROGEN_OT_paint,
    paint.OROGEN_OT_clear_paint,
    paint.OROGEN_OT_end_painting,
    plates.OROGEN_OT_add_arrow,
    plates.OROGEN_OT_add_plate,
    plates.OROGEN_OT_make_rigid,
    plates.OROGEN_OT_follow_move,
    plates.OROGEN_OT_follow_rotate,
    plates.OROGEN_OT_follow_resize,
    plates.OROGEN_OT_remove_plate,
    polygons.OROGEN_OT_change_polygon,
    polygons.OROGEN_OT_clear_polygons,
    presets.OROGEN_MT_terrain_presets,
    presets.OROGEN_OT_add_from_preset,
    presets.OROGEN_OT_add_terrain_preset,
    presets.OROGEN_OT_load_preset,
    problems.OROGEN_OT_check_drawing,
    problems.OROGEN_OT_show_problem,
    reset_parameters.OROGEN_OT_reset_parameter,
    reset_parameters.OROGEN_OT_reset_parameters,
    save_asset_library.OROGEN_OT_save_asset_library,
    save_map.OROGEN_OT_save_map,
    save_recipe.OROGEN_OT_save_recipe,
    seeds.OROGEN_OT_browse_seeds,
    seeds.OROGEN_OT_pick_seed,
    seeds.OROGEN_OT_clear_seeds,
    set_up_scene.OROGEN_OT_set_up_scene,
    springs.OROGEN_OT_add_spring,
)


def register():
    for cls in CLASSES:
        if cls.__doc__:
            cls.__doc__ = " ".join(cls.__doc__.split())  # a tooltip would show the line's break
        bpy.utils.register_class(cls)
    preset_files.register()
    bpy.utils.register_preset_path(presets.folder())
    bpy.app.handlers.save_pre.append(paint.keep_images)
    bpy.types.VIEW3D_MT_mesh_add.append(add_terrain.draw_menu)
    bpy.types.VIEW3D_MT_curve_add.append(feature_curves.draw_menu)
    bpy.types.TOPBAR_MT_file_import.append(load_map.draw_menu)
    bpy.types.TOPBAR_MT_file_export.append(export_terrain.draw_menu)
    seeds.register_keys()
    draw_arrow.register_tool()
    polygons.register_tool()


def unregister():
    polygons.unregister_tool()
    draw_arrow.unregister_tool()
    seeds.unregister_keys()
    bpy.types.TOPBAR_MT_file_export.remove(export_terrain.draw_menu)
    bpy.types.TOPBAR_MT_file_import.remove(load_map.draw_menu)
    bpy.types.VIEW3D_MT_curve_add.remove(feature_curves.draw_menu)
    bpy.types.VIEW3D_MT_mesh_add.remove(add_terrain.draw_menu)
    bpy.app.handlers.save_pre.remove(paint.keep_images)
    bpy.utils.unregister_preset_path(presets.folder())
    preset_files.unregister()
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
