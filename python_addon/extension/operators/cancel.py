"""Stopping the job that runs."""

import bpy


class OROGEN_OT_cancel(bpy.types.Operator):
    """Stop growing and keep the terrain as it was"""

    bl_idname = "orogen.cancel"
    bl_label = "Cancel"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, context):
        return context.window_manager.orogen.running

    def execute(self, context):
        context.window_manager.orogen.stop = True  # seen by the running operator's timer
        return {"FINISHED"}
