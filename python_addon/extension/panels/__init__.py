"""The tab Orogen of the 3D view's sidebar."""

import bpy

from . import (
    feature,
    folds,
    help,
    input,
    main,
    output,
    paint,
    plates,
    polygons,
    presets,
    problems,
    rocks,
    size,
    springs,
    stages,
    strata,
    view,
)

CLASSES = (
    presets.OROGEN_PT_presets,
    feature.OROGEN_MT_draw_features,
    feature.OROGEN_PT_feature,
    feature.OROGEN_PT_feature_points,
    main.OROGEN_PT_main,
    problems.OROGEN_PT_problems,
    input.OROGEN_PT_frame,
    stages.OROGEN_PT_input_stages,
    plates.OROGEN_UL_plates,
    plates.OROGEN_PT_plates,
    folds.OROGEN_PT_folds,
    strata.OROGEN_UL_layers,
    strata.OROGEN_PT_strata,
    strata.OROGEN_PT_basement,
    stages.OROGEN_PT_erosion,
    stages.OROGEN_PT_detail,
    stages.OROGEN_PT_life,
    *stages.PANELS,
    springs.OROGEN_PT_springs,
    polygons.OROGEN_PT_polygons,
    paint.OROGEN_PT_paint,
    size.OROGEN_PT_size,
    view.OROGEN_MT_view_field,
    view.OROGEN_PT_view,
    rocks.OROGEN_PT_rocks,
    rocks.OROGEN_PT_growth,
    output.OROGEN_PT_output,
    output.OROGEN_PT_meshes,
    output.OROGEN_PT_nodes,
    help.OROGEN_PT_help,
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
