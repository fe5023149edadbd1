"""The polygons of the active terrain's island, asked whenever what makes them changes."""

import bpy

from .. import given_fields, recipe, terrains
from ..operators.job_operator import REFUSALS
from ..settings_recipe import to_recipe
from ..worker.jobs import jobs
from .viewports import redraw

TICK = 0.02  # s between looks for an answer
PARTS = ("orogen", "seed", "resolution", "extent", "map", "rasters")  # of a recipe that count
STAGES = ("island", "mapped_island")


class Polygons:
    def __init__(self):
        self.changed = False
        self.asked = self.question = None  # what is asked and has no answer yet
        self.shown = None  # what was asked last, and the answer

    def step(self, context):
        """Does what is due; returns the seconds until the next look, or None."""
        if self.question and self.question.answer is not None:
            answer = self.question.answer
            self.shown = (self.asked, None if "error" in answer else answer)
            self.question = self.asked = None
            redraw(context)
        if self.changed and not self.question:
            self._look(context)
        return TICK if self.question else None

    def _look(self, context):
        self.changed = False
        terrain = terrains.active(context)
        if not is_wanted(terrain):
            return
        try:
            asked, document = wanted(terrain, context.scene)
            if self.shown is None or asked != self.shown[0]:
                self.question, self.asked = ask(document), asked
        except REFUSALS:  # growing tells
            self.shown = None


def is_wanted(terrain):
    if terrain is None or not terrain.orogen.input.show_polygons:
        return False
    return given_fields.has_island(terrain.orogen.stage_names())


def wanted(terrain, scene):
    """What tells apart what is asked, and the recipe of the island alone. Raises REFUSALS."""
    whole = to_recipe(terrain, scene, jobs.pack)
    stages = [item for item in whole["stages"] if item["stage"] in STAGES]
    rasters = {k: v for k, v in whole.get("rasters", {}).items() if k.endswith("_change")}
    document = {part: whole[part] for part in PARTS if part in whole}
    document |= {"stages": stages, "rasters": rasters}
    return (terrain.session_uid, recipe.fingerprint(document)), document


def ask(document):
    jobs.temporary_folder = bpy.app.tempdir or None
    return jobs.ask("polygons", recipe=document)


def now(terrain, scene):
    """The polygons, waited for (operators); what `describe_polygons` of the core says. Raises
    REFUSALS."""
    return jobs.wait_for_answer(ask(wanted(terrain, scene)[1]))
