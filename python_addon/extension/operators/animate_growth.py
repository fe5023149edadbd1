"""Growing a terrain with an animation of its growth, in a cache beside the .blend."""

import bpy

from .. import recipe, terrains
from ..mesh import growth_animation, large_ground, terrain_mesh
from ..worker.jobs import jobs
from .problems import FindsProblems

STAGE = "mountain_growth"


class AnimationSettings:
    """Where an animation of growth goes, and how long it is."""

    filepath: bpy.props.StringProperty(
        name="File",
        subtype="FILE_PATH",
        description="The cache. Without one: beside the .blend, by the terrain's name",
        options={"SKIP_SAVE"},
    )
    frames: bpy.props.IntProperty(
        name="Steps", description="Of the animation", default=60, min=2, max=10000
    )
    step: bpy.props.IntProperty(
        name="Frames a Step",
        description="Frames of the scene from one step to the next",
        default=2,
        min=1,
        max=1000,
    )


class OROGEN_OT_animate_growth(AnimationSettings, FindsProblems, bpy.types.Operator):
    """Grow the terrain step by step, write the steps into a file beside the .blend, and play them
    from the scene's first frame on. It plays without the extension too"""

    bl_idname = "orogen.animate_growth"
    bl_label = "Grow with Animation"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Mountains between colliding plates are wanted")
        terrain = terrains.active(context)
        return terrain is not None and STAGE in terrain.orogen.stage_names()

    def ask(self, context, terrain):
        self._file = cache_file(terrain, self.filepath)
        return super().ask(context, terrain)

    def start(self):
        self._recipe = with_frames(self._recipe, self.frames)
        return jobs.start_growth(self._recipe)

    def take(self, context, terrain, result):
        if large_ground.is_large(result.grid):
            raise terrain_mesh.NotNow(large_ground.TOO_LARGE)
        terrain_mesh.write(terrain, result, self._recipe)
        super().take(context, terrain, result)
        scene = context.scene
        frames = growth_animation.ending_in(result.frames(), result.fields["elevation"])
        last = growth_animation.write(terrain, frames, self._file, scene.frame_start, self.step)
        scene.frame_end = max(scene.frame_end, last)


def cache_file(terrain, wanted):
    """The file of a terrain's animation: the one that is wanted, else one beside the .blend."""
    if wanted:
        return bpy.path.abspath(wanted)
    if not bpy.data.filepath:
        raise terrain_mesh.NotNow("Save the .blend first: the animation's file lies beside it")
    name = bpy.path.clean_name(terrain.name) + growth_animation.SUFFIX
    return bpy.path.abspath(f"//{name}")


def with_frames(document, count):
    """The recipe, asking for so many frames of growth."""
    wanted = {STAGE: {"frames": count}}
    if STAGE not in recipe.stage_names(document):
        raise recipe.NotARecipe("No mountains grow in this recipe: there is nothing to animate")
    stages = [
        {**item, "parameters": {**item["parameters"], **wanted.get(item["stage"], {})}}
        for item in document["stages"]
    ]
    return {**document, "stages": stages}
