"""Growing a terrain."""

import bpy

from ..mesh import terrain_mesh
from ..worker.jobs import jobs
from .problems import FindsProblems


class OROGEN_OT_grow(FindsProblems, bpy.types.Operator):
    """Grow the active terrain from its map. Esc stops and keeps it as it was"""

    bl_idname = "orogen.grow"
    bl_label = "Grow"
    bl_options = {"UNDO"}

    threads: bpy.props.IntProperty(
        name="Threads", description="At most so many; 0: all cores", min=0, options={"SKIP_SAVE"}
    )

    def start(self):
        return jobs.start(self._recipe, threads=self.threads)

    def take(self, context, terrain, result):
        terrain_mesh.write(terrain, result, self._recipe)
        super().take(context, terrain, result)
