"""Recipes as plain dicts of the core's recipe format. No bpy here."""

import base64
import functools
import hashlib
import json
from pathlib import Path

from .declarations import COLLISION_STAGES, HEIGHT_STAGES, ISLAND_STAGES, MAP_STAGES

VERSION = 1
TARGET_STAGES = tuple(  # of heights that are grown towards
    "fitted_growth" if name == "river_erosion" else name for name in HEIGHT_STAGES
)
FEATURE_STAGE = "feature_curves"
WATER_STAGE = "hydraulic_erosion"
AFTER_FEATURES = (WATER_STAGE, "rock_detail", "map_law", "outcrop", "lakes")  # may follow
WATCHED_STAGES = {"mountain_growth", WATER_STAGE}  # which can be watched
LIFE_STAGES = ("lakes", "climate", "biomes", "vegetation")
ELEVATION_MODELS = (".tif", ".tiff", ".hgt", ".npy")  # what the core reads heights from


class NotARecipe(ValueError):
    """The file is neither a recipe nor a map."""


def make(map_, name):
    return {"orogen": VERSION, "name": name, "map": map_}


def make_collision(name, lower, size, phases, column):
    """Plates that move on a rectangle (m), without a map."""
    extent = {"origin": list(lower), "size": list(size)}
    return {"orogen": VERSION, "name": name, "extent": extent, "phases": phases, "column": column}


def make_heights(name, lower, size, elevation):
    """Given heights (a packed raster) on a rectangle (m)."""
    extent = {"origin": list(lower), "size": list(size)}
    return {"orogen": VERSION, "name": name, "extent": extent, "rasters": {"elevation": elevation}}


def make_island(name, lower, size):
    """An island from nothing, on a rectangle (m)."""
    return {"orogen": VERSION, "name": name, "extent": {"origin": list(lower), "size": list(size)}}


def towards(recipe):
    """The recipe of given heights with stages that grow towards them."""
    return {**recipe, "stages": [{"stage": stage} for stage in TARGET_STAGES]}


def make_join(map_, name, stages, column):
    """A map whose own plates fold a column of rock."""
    listed = [{"stage": stage} for stage in stages]
    return {**make(map_, name), "column": column, "stages": listed}


def with_life(names):
    """Stages with those of climate and plants after them. Islands have a climate of their own."""
    own = {"island", "mapped_island"} & set(names)
    return (*names, *(name for name in LIFE_STAGES if not (own and name == "climate")))


def stage_names(recipe):
    """The stages of a recipe in order: its own, else those of its kind, as in the core."""
    if "stages" in recipe:
        return tuple(item["stage"] for item in recipe["stages"])
    if "map" in recipe:
        return MAP_STAGES
    if recipe.get("phases"):
        return COLLISION_STAGES
    return HEIGHT_STAGES if "elevation" in recipe.get("rasters", {}) else ISLAND_STAGES


def with_settings(recipe, seed, resolution, parameters):
    """The recipe with these settings; `parameters` is {stage: {parameter: value}}."""
    stages = [{"stage": name, "parameters": parameters[name]} for name in stage_names(recipe)]
    return {**recipe, "seed": seed, "resolution": resolution, "stages": stages}


def with_features(recipe, features, parameters):
    """The recipe with more feature curves, and with the stage that bends the ground to them."""
    if not features:
        return recipe
    stages = recipe["stages"]
    names = [item["stage"] for item in stages]
    if FEATURE_STAGE not in names:
        at = next((i for i, name in enumerate(names) if name in AFTER_FEATURES), len(names))
        stage = {"stage": FEATURE_STAGE, "parameters": parameters}
        stages = [*stages[:at], stage, *stages[at:]]
    return {**recipe, "stages": stages, "features": [*recipe.get("features", ()), *features]}


def with_river_sources(recipe, sources):
    """The recipe with more springs."""
    if not sources:
        return recipe
    return {**recipe, "river_sources": [*recipe.get("river_sources", ()), *sources]}


def fingerprint(recipe):
    """The same for recipes that `with_settings` made where at most resolution and the frames of
    growth differ: how finely, and in how many pictures."""
    stages = [
        {**item, "parameters": {k: v for k, v in item["parameters"].items() if k != "frames"}}
        for item in recipe["stages"]
    ]
    rasters = {name: _raster_mark(raster) for name, raster in recipe.get("rasters", {}).items()}
    marked = {**recipe, "resolution": None, "stages": stages, "rasters": rasters}
    return hashlib.sha256(json.dumps(marked, sort_keys=True).encode()).hexdigest()


def _raster_mark(raster):
    """The same for a raster in the recipe and one that was handed over as a file."""
    if "sha256" in raster:
        return raster["sha256"]
    if "float32" in raster:
        return hashlib.sha256(base64.b64decode(raster["float32"])).hexdigest()
    return raster


def read(path):
    """The file as a recipe, its map inline; a bare map, or an elevation model, becomes a recipe
    with that alone."""
    path = Path(path)
    if path.suffix.lower() in ELEVATION_MODELS:
        name = path.name.split(".")[0]
        return {"orogen": VERSION, "name": name, "rasters": {"elevation": {"file": str(path)}}}
    document = _read_json(path)
    if "orogen" not in document:
        return make(document, path.name.split(".")[0])
    map_ = document.get("map")
    if isinstance(map_, dict) and isinstance(map_.get("file"), str):
        return {**document, "map": _read_json(path.parent / map_["file"])}
    return document


def _read_json(path):
    try:
        state = path.stat()
    except OSError as error:
        raise NotARecipe(f"{path.name} cannot be read: {error.strerror}") from None
    return _parsed(path, state.st_mtime_ns, state.st_size)


@functools.lru_cache(maxsize=8)
def _parsed(path, _written, _bytes):
    """What a file holds, as long as it is not written anew. Not to be changed."""
    try:
        document = json.loads(path.read_text(encoding="utf-8"), parse_constant=_refuse)
    except OSError as error:
        raise NotARecipe(f"{path.name} cannot be read: {error.strerror}") from None
    except (ValueError, RecursionError) as error:
        raise NotARecipe(f"{path.name} is no JSON: {error}") from None
    if not isinstance(document, dict):
        raise NotARecipe(f"{path.name} is neither a map nor a recipe")
    return document


def _refuse(constant):
    raise ValueError(f"{constant} is no number")
