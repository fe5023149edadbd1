"""The moving plates and their arrows."""

import bpy

from .. import terrains
from ..scene.plates import active_plate, root_of
from .stages import GroupPanel
from .tab import property_layout


class OROGEN_UL_plates(bpy.types.UIList):
    def draw_item(self, _context, layout, _data, plate, _icon, _active_data, _active_name):
        row = layout.row(align=True)
        color = row.row()
        color.ui_units_x = 1.0
        color.prop(plate.orogen_plate, "color", text="")
        row.prop(plate, "name", text="", emboss=False)
        if plate.orogen_plate.stable:
            row.label(text="", icon="PINNED")

    def filter_items(self, _context, data, name):
        shown = [
            self.bitflag_filter_item if child.orogen_plate.is_plate else 0
            for child in getattr(data, name)
        ]
        return shown, []


class OROGEN_PT_plates(GroupPanel, bpy.types.Panel):
    bl_label = group = "Plates"
    bl_options = set()

    def draw(self, context):
        terrain = terrains.active(context)
        if terrain.orogen.source != "PLATES":
            return
        layout = property_layout(self)
        settings = terrain.orogen.input
        row = layout.row()
        inputs = root_of(terrain, context.scene)
        row.template_list("OROGEN_UL_plates", "", inputs, "children", settings, "active_plate")
        column = row.column(align=True)
        column.operator("orogen.add_plate", text="", icon="ADD")
        column.operator("orogen.remove_plate", text="", icon="REMOVE")
        if plate := active_plate(context, terrain):
            layout.prop(plate.orogen_plate, "crust")
            layout.prop(plate.orogen_plate, "stable")
        row = layout.row(align=True)
        row.operator("orogen.add_arrow", icon="EMPTY_SINGLE_ARROW")
        row.operator("orogen.draw", text="Draw Arrows", icon="GREASEPENCIL").layer = "Plate"
        if context.mode.startswith("PAINT_G"):
            layout.operator("object.mode_set", text="Done", icon="CHECKMARK").mode = "OBJECT"
        if not settings.rigid_arrows:
            layout.operator("orogen.make_rigid")
        column = layout.column(heading="Show")
        column.prop(settings, "show_hulls")
        column = layout.column(heading="Edit")
        column.prop(settings, "rigid_arrows")
        layout.prop(settings, "phase_years")
        layout.prop(settings, "years_per_frame")
