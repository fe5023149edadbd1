"""Arrows that show the rigid motion of their plate: the one that is nearest to them, as the core
finds it."""

import bpy
import numpy as np
from mathutils import Matrix, Vector

from ..worker.jobs import NoCore, jobs
from .plane import Planes
from .plates import arrows_of, read_plate

TOLERANCE = 1e-5  # of the longest arrow
ROUNDING = 0.05  # m: what reading the scene may cost


class NotRigid(RuntimeError):
    """No rigid motion is to be had."""


def ask(plates, **extent):
    """Asks for the rigid motions of plates, and the borders of their influence within an extent."""
    jobs.temporary_folder = bpy.app.tempdir or None
    return jobs.ask("gestures", plates=plates, **extent)


def is_rigid(drawn, found):
    """Whether a plate's arrows are those of its rigid motion."""
    error = np.abs(np.subtract(found["arrows"], drawn["arrows"])).max()
    return error <= ROUNDING + TOLERANCE * np.abs(found["arrows"]).max()


def make_rigid(terrain, plate):
    """Turns and stretches the arrows of a plate to its rigid motion. Raises NotRigid."""
    planes = Planes(terrain)
    drawn = read_plate(plate, planes)
    if not drawn["points"]:
        raise NotRigid(f"{plate.name} has no arrows")
    try:
        answer = jobs.wait_for_answer(ask([drawn]))
    except (NoCore, OSError) as error:
        raise NotRigid(str(error)) from None
    if "error" in answer:
        raise NotRigid(answer["error"])
    (found,) = answer["plates"]
    if not is_rigid(drawn, found):
        for ob, arrow in zip(arrows_of(plate), found["arrows"], strict=True):
            _point(ob, planes.of(ob), arrow)


def _point(ob, plane, arrow):
    """Lays an arrow along `arrow` (m). One that does not move stands upright."""
    start, tip = plane.world([(0.0, 0.0), arrow])
    along = Vector(tip - start)
    moves = np.hypot(*arrow) > ROUNDING
    size = along.length / ob.empty_display_size if moves else ob.matrix_world.median_scale
    turn = (along if moves else Vector(plane.up)).to_track_quat("Z", "Y")
    ob.matrix_world = Matrix.LocRotScale(ob.matrix_world.translation, turn, (size,) * 3)
