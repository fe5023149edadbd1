"""What is drawn in the scene as a recipe, without the settings of its stages."""

import numpy as np

from . import column_recipe, examples, given_fields, map_features, recipe
from .declarations import COLLISION_STAGES, HEIGHT_STAGES, ISLAND_STAGES, MAP_STAGES
from .problems import Problem
from .scene.drawn_map import read_drawing
from .scene.plates import read_phases

MARGIN = 0.06  # of the longer side, around plates without a frame


def make(terrain, scene):
    """Raises map_features.NothingDrawn, where there are no layers of rock too."""
    settings = terrain.orogen
    frame = settings.input.frame_size()
    if settings.source == "PLATES":
        phases = read_phases(terrain, scene)
        lower, size = extent(phases, frame)
        column = column_recipe.make(settings)
        return recipe.make_collision(terrain.name, lower, size, phases, column)
    if settings.source == "HEIGHTS":
        lower, size, heights = given_fields.elevation(terrain, frame)
        return recipe.make_heights(terrain.name, lower, size, given_fields.pack(heights))
    if settings.source == "ISLAND":
        size = frame or settings.input.frame_metres()
        return recipe.make_island(terrain.name, [-0.5 * side for side in size], size)
    map_ = map_features.to_geojson(read_drawing(terrain, scene), terrain.name, frame)
    if settings.source == "JOIN":
        column = column_recipe.make(settings)
        return recipe.make_join(map_, terrain.name, examples.join_stages(), column)
    return recipe.make(map_, terrain.name)


def stages_of(source):
    if source == "JOIN":
        return examples.join_stages()
    return {"PLATES": COLLISION_STAGES, "HEIGHTS": HEIGHT_STAGES, "ISLAND": ISLAND_STAGES}.get(
        source, MAP_STAGES
    )


def problems(terrain, scene):
    """What is wrong with a drawing that can be used all the same."""
    if terrain.orogen.source in ("HEIGHTS", "ISLAND"):
        return []
    if terrain.orogen.source == "PLATES":
        plates = [plate for phase in read_phases(terrain, scene) for plate in phase["plates"]]
        if any(any(arrow) for plate in plates for arrow in plate["arrows"]):
            return []
        return [Problem("No plate moves: turn an arrow, or make it longer")]
    return read_drawing(terrain, scene).problems


def extent(phases, frame):
    """Lower-left corner and size (m)."""
    points = [point for phase in phases for plate in phase["plates"] for point in plate["points"]]
    if not points:
        raise map_features.NothingDrawn("There is no plate with arrows: add one, or two")
    if frame:
        return [-0.5 * side for side in frame], frame
    lower, upper = np.min(points, axis=0), np.max(points, axis=0)
    margin = MARGIN * (upper - lower).max()
    if not margin > 0:
        raise map_features.NothingDrawn("The plates have no extent: set their arrows apart")
    lower, upper = np.floor(lower - margin), np.ceil(upper + margin)
    return lower.tolist(), (upper - lower).tolist()
