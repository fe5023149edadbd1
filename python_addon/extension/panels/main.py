"""The input, Grow, progress and messages."""

import textwrap

import bpy

from .. import terrains
from .grow import draw_grow, draw_progress
from .input import draw_input
from .tab import Tab, property_layout

CHARACTER = 7.5  # pixels, about, at a scale of 1


class OROGEN_PT_main(Tab, bpy.types.Panel):
    bl_label = "Orogen"

    def draw(self, context):
        layout = property_layout(self)
        session = context.window_manager.orogen
        terrain = terrains.active(context)
        if terrain is None:
            layout.label(text="No terrain is active")
            layout.operator_menu_enum("orogen.add_terrain", "start", text="Add Terrain", icon="ADD")
            layout.popover("OROGEN_PT_presets", text="Add from Preset", icon="PRESET")
        else:
            draw_input(layout, context, terrain)
            draw_grow(layout, terrain)
        if session.running:
            draw_progress(layout, session)
        if session.message:
            draw_message(layout, context, session)


def draw_message(layout, context, session):
    box = layout.box()
    box.alert = session.is_error
    draw_text(box, context, session.message, "ERROR" if session.is_error else "INFO")


def draw_text(layout, context, text, icon):
    """A label over as many lines as the sidebar's width asks for."""
    width = context.region.width / (CHARACTER * context.preferences.system.ui_scale) - 6
    column = layout.column(align=True)
    column.scale_y = 0.8
    for i, line in enumerate(textwrap.wrap(text, max(16, int(width)))):
        column.label(text=line, icon="BLANK1" if i else icon)
