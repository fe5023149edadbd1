"""Growing a terrain."""

import bpy

from ..mesh import terrain_mesh
from ..settings_recipe import to_recipe
from ..worker.jobs import jobs
from .job_operator import JobOperator


class OROGEN_OT_grow(JobOperator, bpy.types.Operator):
    """Grow the active terrain from its map. Esc stops and keeps it as it was"""

    bl_idname = "orogen.grow"
    bl_label = "Grow"
    bl_options = {"UNDO"}

    threads: bpy.props.IntProperty(
        name="Threads", description="At most so many; 0: all cores", min=0, options={"SKIP_SAVE"}
    )

    def ask(self, context, terrain):
        self._recipe = to_recipe(terrain, context.scene)
        return jobs.start(self._recipe, threads=self.threads)

    def take(self, context, terrain, result):
        take_terrain(terrain, result, self._recipe)


def take_terrain(terrain, result, recipe):
    """Writes the mesh, and what was mended in the map."""
    terrain_mesh.write(terrain, result, recipe)
    terrain.orogen.warnings.clear()
    for text in result.warnings:
        terrain.orogen.warnings.add().text = text
