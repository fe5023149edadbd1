"""The polygons of an island: seeing and changing them."""

import bpy

from .. import given_fields, terrains
from .tab import TerrainTab, property_layout


class OROGEN_PT_polygons(TerrainTab, bpy.types.Panel):
    bl_label = "Polygons"

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and given_fields.has_island(terrain.orogen.stage_names())

    def draw_header(self, context):
        self.layout.prop(terrains.active(context).orogen.input, "show_polygons", text="")

    def draw(self, context):
        layout = property_layout(self)
        terrain = terrains.active(context)
        column = layout.column()
        column.active = terrain.orogen.input.show_polygons
        column.prop(terrain.orogen.input, "show_downslopes")
        row = layout.row(align=True)
        tool = row.operator("wm.tool_set_by_id", text="Click to Change", icon="RESTRICT_SELECT_OFF")
        tool.name = "orogen.polygon_tool"
        row.operator("orogen.clear_polygons", text="", icon="X")
        if count := len(terrain.orogen.paints.polygons):
            layout.label(text=f"{count} changed", icon="INFO")
