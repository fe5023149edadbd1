"""The springs whose water wears the ground."""

import bpy

from .. import terrains
from ..declarations import SPRING_NUMBERS
from ..recipe import WATER_STAGE
from ..scene import springs
from .stages import KNOWN, StagePanel


class OROGEN_PT_springs(StagePanel, bpy.types.Panel):
    bl_label = "Springs"
    bl_parent_id = f"OROGEN_PT_stage_{WATER_STAGE}"
    stage = KNOWN[WATER_STAGE]

    def draw(self, context):
        found = springs.objects(terrains.active(context), context.scene)
        column = self.layout.column(align=True)
        if found:
            row = column.row(align=True)
            for text in ("Name", *(number.label for number in SPRING_NUMBERS)):
                row.label(text=text)
        for ob in found:
            row = column.row(align=True)
            row.prop(ob, "name", text="", icon="DOT" if ob != context.object else "RADIOBUT_ON")
            for number in SPRING_NUMBERS:
                row.prop(ob.orogen_spring, number.name, text="")
        self.layout.operator("orogen.add_spring", icon="ADD")
