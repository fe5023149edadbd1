"""The browser of seeds: variations of a terrain side by side, of which one is picked."""

import bpy

from .. import terrains
from ..mesh import variations
from ..settings_recipe import to_recipe
from ..worker.jobs import jobs
from .job_operator import JobOperator

LARGEST = 2**31 - 1  # of Blender's integers


class OROGEN_OT_browse_seeds(JobOperator, bpy.types.Operator):
    """Grow small previews of several seeds beside the terrain. Select one and pick it"""

    bl_idname = "orogen.browse_seeds"
    bl_label = "Browse Seeds"
    bl_options = {"UNDO"}

    count: bpy.props.IntProperty(
        name="Variations", description="How many seeds are shown", default=6, min=1, max=36
    )
    first: bpy.props.IntProperty(
        name="First Seed",
        description="Negative: after those that are shown, else the terrain's own",
        default=-1,
        min=-1,
        options={"SKIP_SAVE"},
    )

    def ask(self, context, terrain):
        first = min(self._first(terrain), LARGEST - self.count + 1)
        seeds = list(range(first, first + self.count))
        return jobs.start_variations(to_recipe(terrain, context.scene), seeds)

    def take(self, context, terrain, result):
        variations.write(terrain, result.grid, result.meshes())

    def _first(self, terrain):
        if self.first >= 0:
            return self.first
        shown = [ob[variations.SEED] for ob in variations.of(terrain)]
        return max(shown) + 1 if shown else terrain.orogen.seed


class SeedsOperator:
    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Browse seeds first")
        terrain = terrains.active(context)
        return terrain is not None and bool(variations.of(terrain))

    def leave(self, context, terrain):
        """Takes the variations away; the terrain becomes the active object."""
        variations.clear(terrain)
        context.view_layer.objects.active = terrain
        terrain.select_set(True)


class OROGEN_OT_pick_seed(SeedsOperator, bpy.types.Operator):
    """Take the seed of the active variation for the terrain, and remove the variations"""

    bl_idname = "orogen.pick_seed"
    bl_label = "Pick Seed"
    bl_options = {"REGISTER", "UNDO"}

    seed: bpy.props.IntProperty(
        name="Seed",
        description="Negative: that of the active variation",
        default=-1,
        min=-1,
        options={"SKIP_SAVE"},
    )

    def execute(self, context):
        terrain = terrains.active(context)
        seed = self.seed if self.seed >= 0 else context.object.get(variations.SEED)
        if seed is None:
            self.report({"ERROR"}, "Make the variation that you want the active object")
            return {"CANCELLED"}
        terrain.orogen.seed = seed
        self.leave(context, terrain)
        return {"FINISHED"}


class OROGEN_OT_clear_seeds(SeedsOperator, bpy.types.Operator):
    """Remove the variations and keep the terrain's seed"""

    bl_idname = "orogen.clear_seeds"
    bl_label = "Clear Seeds"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        self.leave(context, terrains.active(context))
        return {"FINISHED"}


_keys = []


def register_keys():
    """Esc in object mode, where there are variations."""
    if configuration := bpy.context.window_manager.keyconfigs.addon:  # none in the background
        keymap = configuration.keymaps.new(name="Object Mode")
        _keys.append(
            (keymap, keymap.keymap_items.new(OROGEN_OT_clear_seeds.bl_idname, "ESC", "PRESS"))
        )


def unregister_keys():
    for keymap, item in _keys:
        keymap.keymap_items.remove(item)
    _keys.clear()
