"""Growth that is watched: pause, and keeping it as an animation."""

import json

import bpy

from .. import terrains
from ..mesh import attributes, growth_animation, large_ground, terrain_mesh
from ..mesh.watched_growth import watched_growth
from ..properties.session import tell
from ..worker.jobs import jobs
from .animate_growth import AnimationSettings, cache_file


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


class OROGEN_OT_keep_growth(AnimationSettings, bpy.types.Operator):
    """Keep the growth that was watched as an animation, in a file beside the .blend, without
    growing anew. It is coarser than one that is grown for it"""

    bl_idname = "orogen.keep_growth"
    bl_label = "Keep Watched Growth"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        if terrain is not None and large_ground.is_tiled(terrain):
            cls.poll_message_set(large_ground.TOO_LARGE)
            return False
        cls.poll_message_set("Watch the terrain grow to its end first")
        return terrain is not None and watched_growth.is_of(
            terrain.session_uid, terrain_mesh.grown_from(terrain)
        )

    def execute(self, context):
        terrain, scene = terrains.active(context), context.scene
        mesh = terrain.data
        nx, ny = mesh["orogen_grid"]
        still = attributes.read(mesh, "elevation", (ny, nx))
        phases = json.loads(mesh[terrain_mesh.RECIPE]).get("phases", ())
        years = sum(phase["years"] for phase in phases) or watched_growth.years
        frames = watched_growth.frames(self.frames, years, still)
        try:
            terrain_mesh.check_writable(terrain)
            file = cache_file(terrain, self.filepath)
            last = growth_animation.write(terrain, frames, file, scene.frame_start, self.step)
        except (terrain_mesh.NotNow, growth_animation.NoAnimation, OSError) as error:
            tell(context, str(error), is_error=True)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        scene.frame_end = max(scene.frame_end, last)
        return {"FINISHED"}
