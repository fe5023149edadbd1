"""The active terrain's plates as the core sees them: rigid motions, hulls, borders of influence.

Asked whenever the plates change, one question at a time, the newest state next. When the user has
turned or moved arrows and let go, those of the plate are made rigid, as part of that edit's step of
undo.
"""

import time

import bpy

from .. import drawn_recipe, map_features, terrains
from ..scene.plates import arrows_of, plate_collections, read_plates
from ..scene.rigid import ask, is_rigid
from ..worker.jobs import NoCore
from .viewports import redraw

TICK, REST = 0.005, 0.05  # s between looks: for an answer, for the end of an edit
CALM = 0.2  # s without a change: a number that is dragged in a panel tells no end
FOLLOWERS = {  # by the operator whose step of undo they take over
    "TRANSFORM_OT_translate": "follow_move",
    "TRANSFORM_OT_rotate": "follow_rotate",
    "TRANSFORM_OT_resize": "follow_resize",
}


class Gestures:
    def __init__(self):
        self.changed = False
        self.asked = self.question = None  # what is asked and has no answer yet
        self.shown = None  # what was asked last, and the answer
        self.settled = None  # terrain and plates that need not be made rigid
        self.edited, self.since = [], 0.0  # names of plates that the user edits, the last change

    def forget(self):
        """No arrow follows what led to the plates as they are now."""
        self.asked = self.question = self.settled = None
        self.edited = []

    def step(self, context):
        """Does what is due; returns the seconds until the next look, or None."""
        if self.question and self.question.answer is not None:
            self._take(context)
        if self.changed and not self.question:
            self._look(context)
        if self.question:
            return TICK
        if self.edited:
            self._follow(context)
            return REST
        return None

    def _look(self, context):
        self.changed = False
        asked = wanted(context)
        if asked is None:
            self.forget()
            self._show(context, None)
        elif self.shown and asked == self.shown[0]:
            self.settled = self.settled or asked
        else:
            try:
                self.question, self.asked = ask(**asked), asked
            except (NoCore, OSError):  # growing tells
                self._show(context, None)

    def _take(self, context):
        asked, answer = self.asked, self.question.answer
        self.question = self.asked = None
        self._show(context, None if "error" in answer else (asked, answer))
        before, self.settled = self.settled, asked
        if before is None or before["terrain"] != asked["terrain"]:
            self.edited = []
        elif "error" not in answer:
            self._note_edits(context, before, asked, answer)

    def _note_edits(self, context, before, asked, answer):
        known = {plate["name"]: plate for plate in before["plates"]}
        names = set(editable(terrains.own(context), context.scene))
        for drawn, found in zip(asked["plates"], answer["plates"], strict=True):
            name = drawn["name"]
            if drawn != known.get(name, drawn):
                self.since = time.monotonic()
                self.edited = [other for other in self.edited if other != name]
                if name in names and not is_rigid(drawn, found):
                    self.edited.append(name)

    def _follow(self, context):
        if time.monotonic() - self.since < CALM or is_dragging(context):
            return
        names, self.edited = self.edited, []
        last = context.window_manager.operators[-1:]
        follower = FOLLOWERS.get(last[0].bl_idname if last else "", "make_rigid")
        operator = getattr(bpy.ops.orogen, follower)
        for name in names:
            if operator.poll():
                operator("EXEC_DEFAULT", True, plate=name)
        self.settled, self.changed = None, True  # what this changed is no edit

    def _show(self, context, shown):
        self.shown = shown
        redraw(context)


def wanted(context):
    """What to ask of the active terrain's plates, or None."""
    terrain = terrains.active(context)
    if terrain is None or terrain.orogen.source != "PLATES":
        return None
    settings = terrain.orogen.input
    plates = read_plates(terrain, context.scene)
    if not plates or not (settings.show_hulls or settings.rigid_arrows):
        return None
    asked = {"terrain": terrain.session_uid, "plates": plates}
    try:
        lower, size = drawn_recipe.extent([{"plates": plates}], settings.frame_size())
    except map_features.NothingDrawn:  # a single point has no extent
        return asked
    return asked | {"origin": lower, "size": size}


def editable(terrain, scene):
    """Names of the plates whose arrows may follow: none that is keyed or driven."""
    if terrain is None or not terrain.orogen.input.rigid_arrows:
        return []
    plates = plate_collections(terrain, scene)
    return [p.name for p in plates if not any(ob.animation_data for ob in arrows_of(p))]


def is_dragging(context):
    windows = context.window_manager.windows
    modal = [operator.bl_idname for window in windows for operator in window.modal_operators]
    return any(name.startswith("TRANSFORM_OT") for name in modal)
