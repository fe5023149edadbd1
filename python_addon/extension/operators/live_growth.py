"""Growth that is watched: pause."""

import bpy

from ..worker.jobs import jobs


class OROGEN_OT_pause_growth(bpy.types.Operator):
    """Let the growth that is watched rest, or go on"""

    bl_idname = "orogen.pause_growth"
    bl_label = "Pause Growth"
    bl_options = {"INTERNAL"}

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Nothing grows that is watched")
        return jobs.watched is not None

    def execute(self, context):
        job = jobs.watched
        jobs.pause(job, not job.paused)
        return {"FINISHED"}
