"""Springs, where water that wears the ground comes out of it."""

import bpy

from .. import terrains
from ..recipe import WATER_STAGE
from ..scene import new_inputs
from ..scene.feature_curves import sides
from ..scene.plane import cursor_place


class OROGEN_OT_add_spring(bpy.types.Operator):
    """Add a spring at the 3D cursor: water that comes out of the ground, or a river that enters the
    map, and wears its bed"""

    bl_idname = "orogen.add_spring"
    bl_label = "Add Spring"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("A terrain with hydraulic erosion is wanted, in object mode")
        terrain = terrains.own(context)
        if context.mode != "OBJECT" or terrain is None:
            return False
        return WATER_STAGE in terrain.orogen.stage_names()

    def execute(self, context):
        terrain = terrains.active(context)
        place = cursor_place(terrain, context.scene, sides(terrain))
        terrains.activate(context, new_inputs.add_spring(terrain, "Spring", place))
        return {"FINISHED"}
