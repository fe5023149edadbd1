"""What was mended in the map, and where."""

import bpy

from .. import terrains
from .main import draw_text
from .tab import TerrainTab


class OROGEN_PT_warnings(TerrainTab, bpy.types.Panel):
    bl_label = "Warnings of the Map"

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and len(terrain.orogen.warnings) > 0

    def draw_header_preset(self, context):
        self.layout.label(text=str(len(terrains.active(context).orogen.warnings)))

    def draw(self, context):
        for warning in terrains.active(context).orogen.warnings:
            draw_text(self.layout, context, warning.text, "DOT")
