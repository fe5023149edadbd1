"""The timer that grows previews and asks about plates and polygons. It runs only while something
waits or grows.

A preview is grown where the recipe that the settings ask for now is not the one that the mesh was
grown from (it keeps a fingerprint). So nothing runs in circles, and what an undo or another file
brings is known. A preview is no step of undo: it follows from the scene.
"""

import time

import bpy

from .. import recipe, terrains
from ..mesh import terrain_mesh
from ..operators.job_operator import REFUSALS
from ..properties.session import tell
from ..settings_recipe import to_recipe
from ..worker.jobs import DONE, FAILED, RUNNING, SUPERSEDED, jobs
from .gestures import Gestures
from .polygons import Polygons, is_wanted
from .turns import Turns

TICK = 0.005  # s between looks at the worker
REST = 0.1  # s, while a job of another kind runs


class Loop:
    def __init__(self):
        self.watching = False  # whether some terrain's live preview may be on
        self.changed = False
        self.turns = Turns()
        self.job = self.recipe = self.mark = None  # of the preview that grows, and its fingerprint
        self.failed = None  # fingerprint of what cannot grow
        self.landing = None  # terrain and fingerprint of a preview that is about to be written

    def step(self, context):
        """Does what is due; returns the seconds until the next look, or None."""
        jobs.poll()
        landed = self.job and self.job.state != RUNNING and self._land(context)
        if self.changed:
            self._notice()
        others = jobs.busy and self.job is None
        now = time.monotonic()
        if not others and (uid := self.turns.due(now)) is not None:
            self._look(context, uid, now)
        if landed:  # the worker is busy with the next meanwhile
            self._apply(context, *landed)
        self.landing = None
        if self.turns.idle:
            return None
        return REST if others else TICK

    def _notice(self):
        self.changed = False
        live = [ob for ob in bpy.data.objects if ob.orogen.is_terrain and ob.orogen.live.enabled]
        self.watching = bool(live)
        for terrain in live:
            self.turns.notice(terrain.session_uid)

    def _look(self, context, uid, now):
        terrain = terrains.by_uid(uid)
        try:
            if terrain is None or not terrain.orogen.live.enabled:
                return self.turns.drop(uid)
            terrain_mesh.check_writable(terrain)
            jobs.temporary_folder = bpy.app.tempdir or None
            asked = to_recipe(terrain, context.scene, jobs.pack)
            mark = recipe.fingerprint(asked)
            known = terrain_mesh.grown_from(terrain), self.failed, self.mark
            if mark in known or self.landing == (uid, mark):
                return self.turns.drop(uid)
            self.job = jobs.start_preview(asked)
            self.recipe, self.mark = asked, mark
        except REFUSALS as error:
            self._complain(context, str(error))
            return self.turns.drop(uid)
        self.turns.start(uid, now)

    def _land(self, context):
        """Ends the job; returns what `_apply` writes, if anything."""
        uid, job, grown, mark = self.turns.growing, self.job, self.recipe, self.mark
        self.job = self.recipe = self.mark = None
        self.turns.end(time.monotonic())
        if job.state == DONE:
            self.landing = uid, mark
            return uid, job.result, grown
        if job.state == FAILED:
            self.failed = mark
            self._complain(context, job.message)
        elif job.state == SUPERSEDED:  # by what the user asked for: look again afterwards
            self.turns.notice(uid)
        return None

    def _apply(self, context, uid, result, grown):
        terrain = terrains.by_uid(uid)
        try:
            if terrain is not None:
                terrain_mesh.write(terrain, result, grown, is_preview=True)
                self._complain(context, "")
        except terrain_mesh.NotNow as error:
            self._complain(context, str(error))
        finally:
            result.close()

    def _complain(self, context, message):
        if context.window_manager.orogen.message != message:
            tell(context, message, is_error=bool(message))


_loop, _gestures, _polygons = Loop(), Gestures(), Polygons()
edits = 0  # how often something changed that may be drawn over the viewport


def tick():
    waits = [part.step(bpy.context) for part in (_loop, _gestures, _polygons)]
    return min((wait for wait in waits if wait is not None), default=None)


def is_watching():
    return _loop.watching


def watches_inputs():
    """Whether the active terrain has plates or shows polygons, or the one that was active had."""
    terrain = terrains.active(bpy.context)
    has_plates = terrain is not None and terrain.orogen.source == "PLATES"
    return has_plates or is_wanted(terrain) or _gestures.shown is not None


def plates_shown():
    """What was asked about the active terrain's plates, and the answer; or None."""
    return _gestures.shown


def polygons_shown():
    """What was asked about the active terrain's polygons, and the answer; or None."""
    return _polygons.shown


def note_edit():
    global edits
    edits += 1


def wake():
    """Something may have changed: the timer looks at every terrain whose preview is on, and at the
    active one's plates and polygons."""
    _loop.changed = True
    wake_inputs()


def wake_inputs():
    _gestures.changed = _polygons.changed = True
    if not bpy.app.timers.is_registered(tick):
        bpy.app.timers.register(tick, first_interval=0.0)


def sleep():
    if bpy.app.timers.is_registered(tick):
        bpy.app.timers.unregister(tick)


def reset():
    """Another file was loaded."""
    global _loop, _gestures, _polygons
    sleep()
    _loop, _gestures, _polygons = Loop(), Gestures(), Polygons()


def forget_edits():
    """The plates are as an undo made them: no arrow follows."""
    _gestures.forget()
