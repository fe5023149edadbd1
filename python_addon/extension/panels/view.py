"""What the ground's colours tell."""

import bpy

from .. import terrains
from ..view import fields, show
from .tab import TerrainTab, property_layout


class OROGEN_MT_view_field(bpy.types.Menu):
    bl_label = "Show"

    def draw(self, context):
        terrain = terrains.active(context)
        for name in (show.NATURAL, *fields.names(terrain.data)):
            self.layout.prop_enum(terrain.orogen.view, "field", name)


class OROGEN_PT_view(TerrainTab, bpy.types.Panel):
    bl_label = "View"

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and len(terrain.data.vertices) > 0

    def draw(self, context):
        layout = property_layout(self)
        terrain = terrains.active(context)
        view, field = terrain.orogen.view, show.shown_field(terrain)
        chosen = view.bl_rna.properties["field"].enum_items[view.field].name
        layout.menu("OROGEN_MT_view_field", text=chosen)
        if field is None:
            if view.field != show.NATURAL:
                layout.label(text="This terrain has no such field", icon="INFO")
            return
        layout.prop(view, "legend")
        if field.type == "float32":
            draw_range(layout, view, fields.shown_unit(field))


def draw_range(layout, view, unit):
    layout.prop(view, "scale")
    layout.prop(view, "automatic")
    column = layout.column(align=True)
    column.enabled = not view.automatic
    suffix = f" ({unit})" if unit else ""
    column.prop(view, "low", text=f"From{suffix}")
    column.prop(view, "high", text=f"To{suffix}")
