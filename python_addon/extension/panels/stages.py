"""The parameters, one panel a stage, drawn from the declarations."""

import bpy

from .. import terrains
from ..declarations import STAGES
from .tab import TerrainTab


class OROGEN_PT_stages(TerrainTab, bpy.types.Panel):
    bl_label = "Stages"

    def draw(self, _context):
        row = self.layout.row()
        row.operator("orogen.reset_parameters", text="Reset All", icon="LOOP_BACK").stage = ""
        row.operator("orogen.save_recipe", icon="FILE_TICK")


class StagePanel(TerrainTab):
    bl_parent_id = "OROGEN_PT_stages"
    stage = None

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and cls.stage.name in terrain.orogen.stage_names()

    def draw(self, context):
        column = self.layout.column(align=True)
        group = getattr(terrains.active(context).orogen.stages, self.stage.name)
        for parameter in self.stage.parameters:
            draw_parameter(column, group, parameter)
        reset = self.layout.operator("orogen.reset_parameters", text="Reset", icon="LOOP_BACK")
        reset.stage = self.stage.name


def draw_parameter(column, group, parameter):
    """The label, with its unit, inside the field: beside it there is no room for both."""
    if parameter.type == "choice":
        split = column.split(factor=0.45)
        split.label(text=parameter.label)
        split.prop(group, parameter.name, text="")
    else:
        column.prop(group, parameter.name)


def panel_of(stage):
    name = f"OROGEN_PT_stage_{stage.name}"
    members = {
        "__module__": __name__,
        "bl_idname": name,
        "bl_label": stage.label,
        "bl_description": f"{stage.text} ({stage.citation})",
        "stage": stage,
    }
    return type(name, (StagePanel, bpy.types.Panel), members)


PANELS = tuple(panel_of(stage) for stage in STAGES if stage.parameters)
