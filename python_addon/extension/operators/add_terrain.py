"""Add > Mesh > Terrain."""

import bpy

from .. import terrains


class OROGEN_OT_add_terrain(bpy.types.Operator):
    """Add a terrain, to be grown from a map"""

    bl_idname = "orogen.add_terrain"
    bl_label = "Terrain"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def execute(self, context):
        terrains.add(context)
        return {"FINISHED"}


def draw_menu(self, _context):
    self.layout.operator(OROGEN_OT_add_terrain.bl_idname, icon="RNDCURVE")
