"""Looking for what is wrong with a drawing, and showing where."""

import bpy

from .. import drawn_recipe, terrains
from ..mesh import middle
from ..problems import located
from ..properties.problem import keep
from ..properties.session import tell
from ..scene import feature_curves
from ..scene.plane import Plane
from ..settings_recipe import to_recipe
from ..worker.jobs import jobs
from .job_operator import JobOperator

COARSE = 48  # cells along the longer side: enough for the core to read and check everything


class FindsProblems(JobOperator):
    """A job that keeps with the terrain what is wrong with what it is grown from."""

    def ask(self, context, terrain):
        self._recipe = to_recipe(terrain, context.scene)
        drawn = terrain.orogen.is_drawn()
        self._problems = drawn_recipe.problems(terrain, context.scene) if drawn else []
        self._problems += feature_curves.problems(terrain, context.scene)
        self._shift = middle.shift(terrain) or (0.0, 0.0)
        return self.start()

    def take(self, context, terrain, result):
        told = [located(text, self._recipe, shift=self._shift) for text in result.warnings]
        keep(terrain, self._problems + told)

    def failed(self, context, terrain, message):
        keep(terrain, [located(message, self._recipe, True, self._shift), *self._problems])


class OROGEN_OT_check_drawing(FindsProblems, bpy.types.Operator):
    """Look for what is wrong with the drawing, without growing the terrain"""

    bl_idname = "orogen.check_drawing"
    bl_label = "Check"
    bl_options = {"UNDO"}

    def start(self):
        return jobs.start(self._recipe, resolution=COARSE)

    def take(self, context, terrain, result):
        super().take(context, terrain, result)
        count = len(terrain.orogen.problems)
        tell(context, f"It can grow; problems: {count}" if count else "Nothing is wrong with it")


class OROGEN_OT_show_problem(bpy.types.Operator):
    """Put the 3D cursor where the drawing is wrong, and look there"""

    bl_idname = "orogen.show_problem"
    bl_label = "Show Problem"
    bl_options = {"REGISTER", "UNDO"}

    index: bpy.props.IntProperty(name="Index", description="In the list of problems", min=0)

    @classmethod
    def poll(cls, context):
        return terrains.active(context) is not None

    def execute(self, context):
        terrain = terrains.active(context)
        problems = terrain.orogen.problems
        if self.index >= len(problems) or not problems[self.index].has_place:
            self.report({"ERROR"}, f"There is no place of a problem {self.index + 1}")
            return {"CANCELLED"}
        place = Plane(terrain).world(problems[self.index].place)[0]
        context.scene.cursor.location = place
        if context.space_data and context.space_data.type == "VIEW_3D":
            context.space_data.region_3d.view_location = place
        return {"FINISHED"}
