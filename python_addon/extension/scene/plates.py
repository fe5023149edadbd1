"""Moving plates of the scene as phases of a recipe.

A plate is a collection that is marked as one: its empties shown as single arrows are its points,
and each one's arrow ends where the ground there goes. Or it is a grease-pencil layer whose name
begins with "Plate": each stroke is an arrow, a dot ground that stays.

Keyed empties move in phases: at each frame with a key a phase begins, with the arrows as they then
stand, and the next one ends it. The last key begins none.
"""

import numpy as np

from .keys import key_frames
from .lines import read_lines
from .plane import Planes

LAYER = "plate"
ARROW = "SINGLE_ARROW"


def root_of(terrain, scene):
    """The collection that the terrain is read from."""
    return terrain.orogen.drawing or scene.collection


def plate_collections(terrain, scene):
    return [c for c in root_of(terrain, scene).children_recursive if c.orogen_plate.is_plate]


def active_plate(context, terrain):
    """The plate of the active arrow, else the one picked in the list, or None."""
    plates = plate_collections(terrain, context.scene)
    for plate in plates:
        if context.object in list(plate.objects):
            return plate
    listed = root_of(terrain, context.scene).children
    index = terrain.orogen.input.active_plate
    return listed[index] if index < len(listed) and listed[index] in plates else None


def arrows_of(plate):
    return [ob for ob in plate.objects if ob.type == "EMPTY" and ob.empty_display_type == ARROW]


def arrow_objects(terrain, scene):
    """Names of the empties that are arrows of plates, and so no peaks."""
    return {ob.name for plate in plate_collections(terrain, scene) for ob in arrows_of(plate)}


def read_phases(terrain, scene):
    """The phases as a recipe has them. Changes the scene's frame and puts it back, but only if
    something is keyed."""
    settings = terrain.orogen.input
    keys = key_frames(ob for plate in plate_collections(terrain, scene) for ob in arrows_of(plate))
    if len(keys) < 2:
        return [{"years": settings.phase_years, "plates": read_plates(terrain, scene)}]
    now, part = scene.frame_current, scene.frame_subframe
    phases = []
    try:
        for begin, end in zip(keys[:-1], keys[1:], strict=True):
            scene.frame_set(int(begin), subframe=begin % 1.0)
            years = (end - begin) * settings.years_per_frame
            phases.append({"years": years, "plates": read_plates(terrain, scene)})
    finally:
        scene.frame_set(now, subframe=part)
    return phases


def read_plates(terrain, scene):
    """The plates as they stand now, those without arrows left out."""
    planes = Planes(terrain)
    plates = [read_plate(c, planes) for c in plate_collections(terrain, scene)]
    plates += _of_strokes(root_of(terrain, scene), scene.frame_current, planes)
    return [plate for plate in plates if plate["points"]]


def read_plate(collection, planes):
    """The plate of one collection; `planes` tells where its arrows lie."""
    plate = {"name": collection.name, "points": [], "arrows": []}
    for ob in arrows_of(collection):
        plane = planes.of(ob)
        tip = ob.matrix_world.to_3x3().col[2] * ob.empty_display_size
        plate["points"].append(_listed(plane.metres(ob.matrix_world.translation)[0, :2]))
        plate["arrows"].append(_listed(plane.arrow(tip)))
    settings = collection.orogen_plate
    if settings.stable:
        plate["stable"] = True
    if settings.crust != "continental":
        plate["crust"] = settings.crust
    return plate


def _of_strokes(root, frame, planes):
    plates = {}
    for ob in root.all_objects:
        for stroke in read_lines(ob, frame):
            if stroke.layer.lower().startswith(LAYER):
                line = planes.of(ob).metres(stroke.points)[:, :2]
                plate = plates.setdefault(
                    stroke.layer, {"name": stroke.layer, "points": [], "arrows": []}
                )
                plate["points"].append(_listed(line[0]))
                plate["arrows"].append(_listed(line[-1] - line[0]))
    return list(plates.values())


def _listed(place):
    return np.round(place, 2).tolist()
