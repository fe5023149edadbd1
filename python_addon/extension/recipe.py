"""Recipes as plain dicts of the core's recipe format. No bpy here."""

import hashlib
import json
from pathlib import Path

from .declarations import COLLISION_STAGES, HEIGHT_STAGES, MAP_STAGES

VERSION = 1
TARGET_STAGES = tuple(  # of heights that are grown towards
    "fitted_growth" if name == "river_erosion" else name for name in HEIGHT_STAGES
)
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


def towards(recipe):
    """The recipe of given heights with stages that grow towards them."""
    return {**recipe, "stages": [{"stage": stage} for stage in TARGET_STAGES]}


def make_join(map_, name, stages, column):
    """A map whose own plates fold a column of rock."""
    listed = [{"stage": stage} for stage in stages]
    return {**make(map_, name), "column": column, "stages": listed}


def stage_names(recipe):
    """The stages of a recipe in order: its own, else those of its kind, as in the core."""
    if "stages" in recipe:
        return tuple(item["stage"] for item in recipe["stages"])
    if "map" in recipe:
        return MAP_STAGES
    if recipe.get("phases"):
        return COLLISION_STAGES
    return HEIGHT_STAGES if "elevation" in recipe.get("rasters", {}) else MAP_STAGES


def with_settings(recipe, seed, resolution, parameters):
    """The recipe with these settings; `parameters` is {stage: {parameter: value}}."""
    stages = [{"stage": name, "parameters": parameters[name]} for name in stage_names(recipe)]
    return {**recipe, "seed": seed, "resolution": resolution, "stages": stages}


def fingerprint(recipe):
    """The same for recipes that `with_settings` made where at most resolution and the frames of
    growth differ: how finely, and in how many pictures."""
    stages = [
        {**item, "parameters": {k: v for k, v in item["parameters"].items() if k != "frames"}}
        for item in recipe["stages"]
    ]
    text = json.dumps({**recipe, "resolution": None, "stages": stages}, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


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
        document["map"] = _read_json(path.parent / map_["file"])
    return document


def _read_json(path):
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
