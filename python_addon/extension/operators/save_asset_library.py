"""Making an asset library of the presets' terrains, the materials and the groups of nodes."""

from pathlib import Path

import bpy

from .. import asset_library, preset_files
from ..panels import status
from ..properties.session import tell
from ..worker.jobs import DONE, RUNNING, jobs
from .job_operator import REFUSALS, TICK

PACKAGE = __package__.rpartition(".")[0]


class Stopped(RuntimeError):
    """The library is not whole; the message says why."""


class OROGEN_OT_save_asset_library(bpy.types.Operator):
    """Grow the terrain of every preset, and write them, the materials and the groups of nodes into
    a folder that Blender's asset browser shows from then on. Esc stops; what is written stays"""

    bl_idname = "orogen.save_asset_library"
    bl_label = "Make Asset Library"

    directory: bpy.props.StringProperty(
        name="Folder",
        description="Where the library lies. Without one: the extension's own user folder",
        subtype="DIR_PATH",
        options={"SKIP_SAVE"},
    )
    resolution: bpy.props.IntProperty(
        name="Resolution",
        description="Cells along the longer side of each terrain",
        default=512,
        min=16,
        max=2048,
    )

    _timer = _work = None
    _asked = False

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Wait until what grows is done, in object mode")
        return not jobs.busy and context.mode == "OBJECT"

    def invoke(self, context, _event):
        self._asked = not bpy.app.background
        return context.window_manager.invoke_props_dialog(self, width=400)

    def execute(self, context):
        self._work = self._write_all(context)
        if self._asked:
            manager = context.window_manager
            self._timer = manager.event_timer_add(TICK, window=context.window)
            manager.modal_handler_add(self)
            status.begin(context, asset_library.NAME)
            return {"RUNNING_MODAL"}
        while True:
            if (end := self._step(context)) is not None:
                return end

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            context.window_manager.orogen.stop = True
        elif event.type != "TIMER":
            return {"PASS_THROUGH"}
        return self._step(context) or {"PASS_THROUGH"}

    def cancel(self, context):
        """Blender ends the operator: the dialog or the window closes, another file is loaded."""
        if self._work:
            self._work.close()
            self._end(context)

    def _step(self, context):
        """Does the next part of the work; what the operator returns if it was the last."""
        try:
            next(self._work)
        except StopIteration:
            self._end(context)
            return {"FINISHED"}
        except (Stopped, *REFUSALS) as error:
            self._end(context)
            tell(context, str(error), is_error=True)
            self.report({"WARNING"} if self._asked else {"ERROR"}, str(error))
            return {"CANCELLED"}

    def _end(self, context):
        if self._timer:
            context.window_manager.event_timer_remove(self._timer)
            status.end(context)

    def _write_all(self, context):
        """A generator: at each step something has been done, or still grows."""
        jobs.temporary_folder = bpy.app.tempdir or None
        folder = self._folder()
        folder.mkdir(parents=True, exist_ok=True)
        presets = [file for file in preset_files.found() if file.parent == preset_files.OWN]
        for done, preset in enumerate(presets):
            name = preset_files.name_of(preset)
            tell(context, f"Asset library: {name}, {done + 1} of {len(presets)}")
            recipe = asset_library.recipe_of(context, preset, self.resolution)
            job = jobs.start(recipe)
            try:
                yield from self._wait(context, job, done, len(presets))
                asset_library.write_terrain(
                    context, folder, preset, self.resolution, job.result, recipe
                )
            finally:
                jobs.cancel(job)
                if job.result:
                    job.result.close()
            yield
        asset_library.write_parts(context, folder)
        asset_library.add_to_preferences(context, folder)
        tell(context, f"The asset library is in {folder}")

    def _wait(self, context, job, done, count):
        if not self._asked:
            jobs.wait(job)
        while job.state == RUNNING:
            if context.window_manager.orogen.stop:
                raise Stopped(f"Stopped: {done} of {count} terrains are in the folder")
            jobs.poll()
            status.show(context, job)
            yield
        if job.state != DONE:
            raise Stopped(job.message or f"Stopped: {done} of {count} terrains are in the folder")

    def _folder(self):
        if self.directory:
            return Path(bpy.path.abspath(self.directory)).resolve()
        return Path(bpy.utils.extension_path_user(PACKAGE, path="assets", create=True))
