"""Growing a terrain."""

import bpy

from .. import recipe, terrains
from ..mesh import large_ground, terrain_mesh
from ..mesh.watched_growth import watched_growth
from ..plants import points
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

    watch: bpy.props.BoolProperty(
        name="Watch",
        description="Show mountains between plates as they grow, and water as it wears the ground",
        options={"SKIP_SAVE"},
    )

    def invoke(self, context, event):
        if not self.properties.is_property_set("watch"):
            self.watch = terrains.active(context).orogen.live.watch
        return super().invoke(context, event)

    def ask(self, context, terrain):
        watched_growth.begin(terrain.session_uid)
        return super().ask(context, terrain)

    def start(self):
        watch = self.watch and not recipe.WATCHED_STAGES.isdisjoint(
            recipe.stage_names(self._recipe)
        )
        return jobs.start(self._recipe, threads=self.threads, watch=watch)

    def take(self, context, terrain, result):
        if large_ground.is_large(result.grid):
            yield from terrain_mesh.write_large(terrain, result, self._recipe)
            terrain = terrains.by_uid(self._uid)
        else:
            terrain_mesh.write(terrain, result, self._recipe)
        points.settle(terrain, result.grid, result.fields["elevation"])
        watched_growth.mark = terrain_mesh.grown_from(terrain)
        super().take(context, terrain, result)
