"""The layers of rock: a preset, or a list of one's own, the top layer first."""

import bpy

from .. import terrains
from ..column_recipe import beds_of
from ..declarations import LAYER_NUMBERS
from .stages import GroupPanel
from .tab import TerrainTab, property_layout

LAYERED = ("PLATES", "JOIN")  # starts whose layers are chosen here


class OROGEN_UL_layers(bpy.types.UIList):
    def draw_item(self, _context, layout, _data, layer, _icon, _active_data, _active_name):
        row = layout.row(align=True)
        color = row.row()
        color.ui_units_x = 1.0
        color.prop(layer, "color", text="")
        row.prop(layer, "name", text="", emboss=False)
        thickness = row.row()
        thickness.alignment = "RIGHT"
        thickness.label(text=f"{layer.thickness:.0f} m")


class OROGEN_PT_strata(GroupPanel, bpy.types.Panel):
    bl_label = group = "Strata"

    def draw(self, context):
        layout = property_layout(self)
        settings = terrains.active(context).orogen
        if settings.source not in LAYERED:
            layout.label(text="The layers are the recipe's own", icon="INFO")
            layout.operator("orogen.edit_recipe", icon="GREASEPENCIL")
            return
        column = settings.column
        if not column.use_layers:
            layout.prop(settings.input, "column_preset")
        layout.prop(column, "use_layers")
        if column.use_layers:
            draw_list(layout, column)
            draw_from_preset(layout, column)


def draw_list(layout, column):
    row = layout.row()
    row.template_list("OROGEN_UL_layers", "", column, "layers", column, "active_layer")
    buttons = row.column(align=True)
    buttons.operator("orogen.add_layer", text="", icon="ADD")
    buttons.operator("orogen.remove_layer", text="", icon="REMOVE")
    buttons.separator()
    buttons.operator("orogen.move_layer", text="", icon="TRIA_UP").direction = "UP"
    buttons.operator("orogen.move_layer", text="", icon="TRIA_DOWN").direction = "DOWN"
    if layer := column.active():
        draw_layer(layout, layer)
        layout.template_ID(layer, "thickness_map", open="image.open", text="Thickness Map")
    else:
        layout.label(text="No layers of rock yet", icon="ERROR")


def draw_from_preset(layout, column):
    text = "Replace by Preset" if column.layers else "Start from Preset"
    layout.operator_menu_enum("orogen.copy_column", "preset", text=text, icon="PRESET")


def draw_layer(layout, layer):
    column = layout.column(align=True)
    column.prop(layer, "lithology")
    column.prop(layer, "resistance", slider=True)
    column = layout.column(align=True)
    column.use_property_split = False
    for parameter in LAYER_NUMBERS:
        column.prop(layer, parameter.name)
    beds = beds_of(layer)
    if len(beds) > 1:
        layout.label(text=f"{len(beds)} beds; Rock is the thickest", icon="INFO")


class OROGEN_PT_basement(TerrainTab, bpy.types.Panel):
    bl_label = "Basement"
    bl_parent_id = "OROGEN_PT_strata"

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        if terrain is None or terrain.orogen.source not in LAYERED:
            return False
        return terrain.orogen.column.use_layers

    def draw(self, context):
        draw_layer(property_layout(self), terrains.active(context).orogen.column.basement)
