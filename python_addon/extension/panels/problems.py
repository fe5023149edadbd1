"""What is wrong with what the terrain was grown from, or was mended in it, and where."""

import bpy

from .. import terrains
from .main import draw_text
from .tab import TerrainTab


class OROGEN_PT_problems(TerrainTab, bpy.types.Panel):
    bl_label = "Problems"
    bl_options = set()  # open: it is there only if something is wrong

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and len(terrain.orogen.problems) > 0

    def draw_header_preset(self, context):
        self.layout.label(text=str(len(terrains.active(context).orogen.problems)))

    def draw(self, context):
        for i, problem in enumerate(terrains.active(context).orogen.problems):
            row = self.layout.row()
            row.alert = problem.is_error
            icon = "ERROR" if problem.is_error else "DOT"
            draw_text(row, context, f"{i + 1}  {problem.text}", icon)
            if problem.has_place:
                row.operator("orogen.show_problem", text="", icon="VIEWZOOM").index = i
