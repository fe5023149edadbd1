"""The parameters, one panel a stage, drawn from the declarations, in the panel of their group."""

import bpy

from .. import terrains
from ..declarations import STAGES
from ..properties.stages import value_of
from .groups import GROUPS, uses
from .tab import TerrainTab

LONGEST = 20  # letters of a label inside a field, in a sidebar of Blender's usual width


class GroupPanel(TerrainTab):
    """A panel for stages of one group: only where the chosen start has some."""

    group = ""

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and uses(terrain.orogen, cls.group)

    def draw(self, _context):
        pass


class OROGEN_PT_input_stages(GroupPanel, bpy.types.Panel):
    bl_label = group = "Input"


class OROGEN_PT_erosion(GroupPanel, bpy.types.Panel):
    bl_label = group = "Erosion"


class OROGEN_PT_detail(GroupPanel, bpy.types.Panel):
    bl_label = group = "Detail"


class OROGEN_PT_life(GroupPanel, bpy.types.Panel):
    bl_label = group = "Climate and Plants"


class StagePanel(TerrainTab):
    stage = None

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and cls.stage.name in terrain.orogen.stage_names()

    def draw(self, context):
        column = self.layout.column(align=True)
        group = getattr(terrains.active(context).orogen.stages, self.stage.name)
        changed = [p for p in self.stage.parameters if value_of(group, p) != p.default]
        for parameter in self.stage.parameters:
            row = column.row(align=True)
            draw_parameter(row, group, parameter)
            if parameter in changed:
                reset = row.operator("orogen.reset_parameter", text="", icon="LOOP_BACK")
                reset.stage, reset.parameter = self.stage.name, parameter.name
        row = self.layout.row()
        row.enabled = bool(changed)
        reset = row.operator("orogen.reset_parameters", text="Reset", icon="LOOP_BACK")
        reset.stage = self.stage.name


def draw_parameter(row, group, parameter):
    """The label, with its unit, inside the field: beside it there is no room for both. What is too
    long for that stands above it."""
    if parameter.type == "choice":
        split = row.split(factor=0.45)
        split.label(text=parameter.label)
        split.prop(group, parameter.name, text="")
    elif parameter.type != "bool" and len(parameter.label) > LONGEST:
        column = row.column(align=True)
        column.label(text=parameter.label)
        column.prop(group, parameter.name, text="")
    else:
        row.prop(group, parameter.name)


PARENTS = {
    "Input": "OROGEN_PT_input_stages",
    "Plates": "OROGEN_PT_plates",
    "Folds": "OROGEN_PT_folds",
    "Strata": "OROGEN_PT_strata",
    "Erosion": "OROGEN_PT_erosion",
    "Detail": "OROGEN_PT_detail",
    "Climate and Plants": "OROGEN_PT_life",
}


def panel_of(stage, parent):
    name = f"OROGEN_PT_stage_{stage.name}"
    members = {
        "__module__": __name__,
        "bl_idname": name,
        "bl_label": stage.label,
        "bl_description": f"{stage.text} ({stage.citation})",
        "bl_parent_id": parent,
        "stage": stage,
    }
    return type(name, (StagePanel, bpy.types.Panel), members)


KNOWN = {stage.name: stage for stage in STAGES if stage.parameters}
PANELS = tuple(
    panel_of(KNOWN[name], PARENTS[group])
    for group, names in GROUPS.items()
    for name in names
    if name in KNOWN
)
