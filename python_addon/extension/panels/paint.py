"""What is painted on the terrain, and the ground that stays."""

import bpy

from .. import given_fields, terrains
from ..operators.paint import LAYERS
from .tab import TerrainTab, property_layout


class OROGEN_PT_paint(TerrainTab, bpy.types.Panel):
    bl_label = "Paint and Freeze"

    def draw(self, context):
        layout = property_layout(self)
        terrain = terrains.active(context)
        paints = terrain.orogen.paints
        used = given_fields.layers(terrain.orogen.stage_names())
        for layer, label, _ in LAYERS:
            if layer in used:
                draw_layer(layout, getattr(paints, layer), layer, label)
        if "biome" in used and paints.biome.method != "NONE":
            layout.prop(paints, "biome_brush")
        if context.mode in ("PAINT_VERTEX", "PAINT_TEXTURE"):
            layout.operator("orogen.end_painting", icon="CHECKMARK")
        layout.separator()
        layout.prop(paints, "freeze")
        column = layout.column()
        column.active = paints.freeze
        column.prop(paints, "keep_object")
        column.prop(terrain.orogen.stages.keep_region, "margin")


def draw_layer(layout, paint, layer, label):
    row = layout.row(align=True)
    row.prop(paint, "method", text=label)
    row.operator("orogen.paint", text="", icon="BRUSH_DATA").layer = layer
    row.operator("orogen.clear_paint", text="", icon="X").layer = layer
    if paint.method != "NONE" and layer in given_fields.FACTORS:
        layout.prop(paint, "strength")
