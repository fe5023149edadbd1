"""The tab Orogen of the 3D view's sidebar."""

import bpy

from . import input, main, plates, problems, rocks, size, stages

CLASSES = (
    main.OROGEN_PT_main,
    input.OROGEN_PT_frame,
    plates.OROGEN_UL_plates,
    plates.OROGEN_PT_plates,
    problems.OROGEN_PT_problems,
    size.OROGEN_PT_size,
    rocks.OROGEN_PT_rocks,
    rocks.OROGEN_PT_growth,
    stages.OROGEN_PT_stages,
    *stages.PANELS,
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
