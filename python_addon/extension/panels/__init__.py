"""The tab Orogen of the 3D view's sidebar."""

import bpy

from . import help, input, main, output, plates, problems, rocks, size, stages, view

CLASSES = (
    main.OROGEN_PT_main,
    input.OROGEN_PT_frame,
    plates.OROGEN_UL_plates,
    plates.OROGEN_PT_plates,
    problems.OROGEN_PT_problems,
    size.OROGEN_PT_size,
    view.OROGEN_MT_view_field,
    view.OROGEN_PT_view,
    rocks.OROGEN_PT_rocks,
    rocks.OROGEN_PT_growth,
    output.OROGEN_PT_output,
    output.OROGEN_PT_meshes,
    output.OROGEN_PT_nodes,
    stages.OROGEN_PT_stages,
    *stages.PANELS,
    help.OROGEN_PT_help,
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
