"""What helps when something goes wrong."""

import bpy

from .tab import Tab, property_layout


class OROGEN_PT_help(Tab, bpy.types.Panel):
    bl_label = "Help"
    bl_parent_id = "OROGEN_PT_main"
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 100  # the last one

    def draw(self, _context):
        layout = property_layout(self)
        reset = layout.operator(
            "orogen.reset_parameters", text="Reset All Parameters", icon="LOOP_BACK"
        )
        reset.stage = ""
        layout.operator("orogen.copy_system_report", icon="COPYDOWN")
