"""What operators share that ask the worker for something. EXEC waits for the result (scripts,
background); INVOKE goes on in the background, shows progress and ends on Esc."""

import time

import bpy

from .. import map_features, recipe, terrains
from ..mesh import growing_mesh, terrain_mesh
from ..mesh.watched_growth import watched_growth
from ..panels import status
from ..properties.session import tell
from ..worker.jobs import CANCELLED, DONE, RUNNING, SUPERSEDED, NoCore, jobs

CANCELLED_TEXT = "Cancelled: the terrain is as it was"
TICK = 0.05  # s between looks at the worker
PAUSE = 0.002  # s between parts of what is done at the end, where nobody looks

REFUSALS = (recipe.NotARecipe, map_features.NothingDrawn, terrain_mesh.NotNow, NoCore, OSError)


class JobOperator:
    """A class has `ask` and `take`; both may raise one of REFUSALS."""

    _timer = None
    _work = None  # what is done in parts at the end

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Add a terrain or make one active first")
        return terrains.active(context) is not None

    def ask(self, context, terrain):
        """Starts the job and returns it."""
        raise NotImplementedError

    def take(self, context, terrain, result):
        """Puts the job's result into the scene. May be a generator, which does a part of the work
        at each step and, closed before its end, leaves the scene as it was. It yields nothing, or
        what it does and how much of it is done."""
        raise NotImplementedError

    def failed(self, context, terrain, message):
        """Keeps with the terrain why the worker could not do it."""

    def execute(self, context):
        if not self._start(context):
            return {"CANCELLED"}
        jobs.wait(self._job)
        work = self._finish(context, {"ERROR"})
        while True:
            try:
                next(work)
            except StopIteration as end:
                return end.value
            time.sleep(PAUSE)

    def invoke(self, context, _event):
        if bpy.app.background:
            return self.execute(context)
        return self.begin_modal(context)

    def begin_modal(self, context):
        if not self._start(context):
            return {"CANCELLED"}
        manager = context.window_manager
        self._timer = manager.event_timer_add(TICK, window=context.window)
        manager.modal_handler_add(self)
        status.begin(context, terrains.active(context).name)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            context.window_manager.orogen.stop = True
        elif event.type != "TIMER":
            return {"PASS_THROUGH"}
        if context.window_manager.orogen.stop:
            jobs.cancel(self._job)
            if self._work:
                return self._give_up(context)
        if self._work:
            return self._go_on(context)
        jobs.poll()
        if self._job.state == RUNNING:
            status.show(context, self._job)
            self._show_frame()
            return {"PASS_THROUGH"}
        self._work = self._finish(context, {"WARNING"})
        return self._go_on(context)

    def _go_on(self, context):
        """Does the next part of what there is to do at the end."""
        try:
            progress = next(self._work)
        except StopIteration as end:
            self._end_modal(context)
            return end.value
        if progress:
            status.show_step(context, *progress)
        return {"PASS_THROUGH"}

    def _give_up(self, context):
        self._work.close()
        self._end_modal(context)
        tell(context, CANCELLED_TEXT)
        return {"CANCELLED"}

    def cancel(self, context):
        """Blender ends the operator: another file is loaded, the window closes."""
        jobs.cancel(self._job)
        if self._work:
            self._work.close()
        self._end_modal(context)

    def _start(self, context):
        terrain = terrains.active(context)
        growing_mesh.end(terrain)
        try:
            terrain_mesh.check_writable(terrain)
            jobs.temporary_folder = bpy.app.tempdir or None
            self._job = self.ask(context, terrain)
        except REFUSALS as error:
            self._complain(context, str(error), {"ERROR"})
            return False
        self._uid = terrain.session_uid
        tell(context, "")
        return True

    def _show_frame(self):
        """Growth that is watched."""
        terrain, frame = terrains.by_uid(self._uid), self._job.take_frame()
        if frame is None:
            return
        if terrain is not None and terrain.mode == "OBJECT":
            growing_mesh.show(terrain, frame)
        watched_growth.add(frame)
        frame.close()

    def _end_modal(self, context):
        context.window_manager.event_timer_remove(self._timer)
        if (terrain := terrains.by_uid(self._uid)) is not None:
            growing_mesh.end(terrain)
        if self._job.state != SUPERSEDED:  # the status is the later job's
            status.end(context)

    def _finish(self, context, level):
        """A generator, as `take` may be one; it returns what the operator does."""
        job = self._job
        if job.state == DONE:
            return (yield from self._apply(context, job.result, level))
        if job.state == CANCELLED:
            tell(context, CANCELLED_TEXT)
        elif job.state != SUPERSEDED:
            if terrain := terrains.by_uid(self._uid):
                self.failed(context, terrain, job.message)
            self._complain(context, job.message, level)
        return {"CANCELLED"}

    def _apply(self, context, result, level):
        terrain = terrains.by_uid(self._uid)
        try:
            if terrain is None:
                raise terrain_mesh.NotNow("The terrain that was to grow is gone")
            growing_mesh.end(terrain)
            yield from self.take(context, terrain, result) or ()
        except REFUSALS as error:
            self._complain(context, str(error), level)
            return {"CANCELLED"}
        finally:
            result.close()
        return {"FINISHED"}

    def _complain(self, context, message, level):
        tell(context, message, is_error=True)
        self.report(level, message)
