"""Fields that the scene gives to a recipe: heights to start from, paint, ground that stays."""

import base64
import json

import bpy
import numpy as np

from . import map_features, polygon_edits
from .mesh import biome_paint, frozen, large_ground, middle, painted
from .scene import ground
from .scene.plane import Plane

KEEP_STAGE = "keep_region"
BEFORE = ("outcrop", "lakes")  # whose rock and water are those of the kept ground
HARDEST = 2.0  # the power of strength by which hardness counts beside uplift
FACTORS = {"uplift": ("uplift_factor", 1.0), "hardness": ("erodibility_factor", -HARDEST)}
CHANGES = {  # of islands, and of climate: black takes 1 away, white adds 1
    "height": "elevation_change",
    "warmth": "temperature_change",
    "moisture": "moisture_change",
}


def has_island(stage_names):
    return not {"island", "mapped_island"}.isdisjoint(stage_names)


def layers(stage_names):
    """The layers of paint that count for such stages."""
    used = set(CHANGES if has_island(stage_names) else FACTORS) | {"keep"}
    used |= {"warmth", "moisture"} if "climate" in stage_names else set()
    return used | ({"biome"} if "biomes" in stage_names else set())


def pack(values):
    """Rows from the south as a recipe's raster."""
    values = np.ascontiguousarray(values, "<f4")
    text = base64.b64encode(values).decode("ascii")
    return {"rows": values.shape[0], "columns": values.shape[1], "float32": text}


def elevation(terrain, frame):
    """Lower-left corner and size (m), and heights. Raises NothingDrawn."""
    given, plane = terrain.orogen.ground, Plane(terrain)
    if given.kind == "IMAGE":
        size = [1000.0 * side for side in terrain.orogen.input.frame_km]
        heights = ground.of_image(given.image, given.black, given.white) if given.image else None
        if heights is None:
            raise map_features.NothingDrawn("Pick an image of heights")
        return [-0.5 * side for side in size], size, heights
    if given.object is None:
        raise map_features.NothingDrawn("Pick a mesh whose heights the terrain starts from")
    lower, size = ground.footprint(given.object, plane)
    if frame:
        lower, size = [-0.5 * side for side in frame], frame
    if not min(size) > 0:
        raise map_features.NothingDrawn(f"'{given.object.name}' has no extent from above")
    depsgraph = bpy.context.evaluated_depsgraph_get()
    heights = ground.of_mesh(given.object, plane, lower, size, depsgraph)
    if heights is None:
        raise map_features.NothingDrawn(f"'{given.object.name}' does not lie on the frame")
    return lower, size, heights


def add_to(document, terrain, keep_parameters, pack=pack):
    """The recipe with what is painted on the terrain, and its frozen ground. `pack` makes a raster
    of rows of values."""
    paints = terrain.orogen.paints
    rasters = {}
    stages = document["stages"]
    for layer, (raster, power) in FACTORS.items():
        if (grey := _grey(terrain, layer)) is not None:
            strength = getattr(paints, layer).strength
            rasters[raster] = pack(strength ** (power * (2.0 * grey - 1.0)))
    used = layers([item["stage"] for item in stages])
    for layer, raster in CHANGES.items():
        if layer in used and (change := _change(terrain, layer, document)) is not None:
            rasters[raster] = pack(change)
    if "biome" in used and (labels := _biomes(paints)) is not None:
        rasters["biome"] = pack(labels)
    kept_ground = frozen.read(terrain.data) if paints.freeze else None
    if kept_ground and (mask := _kept(terrain, kept_ground)) is not None:
        if large_ground.is_tiled(terrain):  # the terrain's own mesh is coarser than its ground
            raise map_features.NothingDrawn(f"Freeze: {large_ground.TOO_LARGE}")
        rasters["kept"] = pack(mask)
        rasters["kept_elevation"] = pack(kept_ground.heights)
        at = next((i for i, s in enumerate(stages) if s["stage"] in BEFORE), len(stages))
        stages = [*stages[:at], {"stage": KEEP_STAGE, "parameters": keep_parameters}, *stages[at:]]
    if not rasters:
        return document
    return {**document, "stages": stages, "rasters": {**document.get("rasters", {}), **rasters}}


def _change(terrain, layer, document):
    """What paint and edits of polygons add to an island; None if there are none."""
    grey = _grey(terrain, layer)
    edits = [edit for edit in terrain.orogen.paints.polygons if edit.layer == layer]
    shift = middle.shift(terrain)
    if not edits or shift is None:
        return None if grey is None else 2.0 * grey - 1.0
    lower, size = _extent(document)
    shape = polygon_edits.shape_of(size) if grey is None else grey.shape
    values = np.zeros(shape, np.float32) if grey is None else 2.0 * grey - 1.0
    rings = [(np.array(json.loads(edit.ring)) + shift, edit.change) for edit in edits]
    polygon_edits.add(values, rings, lower, size)
    return np.clip(values, -1.0, 1.0)


def _extent(document):
    """Lower-left corner and size (m)."""
    if "extent" in document:
        return document["extent"]["origin"], document["extent"]["size"]
    frame = document["map"]["frame"]
    return frame["origin_m"], [1000.0 * side for side in frame["size_km"]]


def _grey(terrain, layer):
    """What is painted, from 0 to 1; None if nothing is."""
    paint = getattr(terrain.orogen.paints, layer)
    if paint.method == "IMAGE" and paint.image:
        return ground.of_image(paint.image, 0.0, 1.0)
    return painted.read(terrain.data, layer) if paint.method == "VERTEX" else None


def _biomes(paints):
    """Numbers of painted biomes; None if there is no paint."""
    painting = paints.biome.method == "IMAGE" and paints.biome.image
    return biome_paint.of_image(paints.biome.image) if painting else None


def _kept(terrain, kept_ground):
    """1 where the ground is to stay; None if it is nowhere."""
    area, masks = terrain.orogen.paints.keep_object, []
    if (grey := _grey(terrain, "keep")) is not None:
        masks.append((grey > 0.5).astype(np.float32))
    if area is not None:
        lower, size = kept_ground.lower, kept_ground.size
        depsgraph = bpy.context.evaluated_depsgraph_get()
        masks.append(ground.covered(area, Plane(terrain), lower, size, depsgraph))
    shape = max((mask.shape for mask in masks), default=None)
    masks = [painted.nearest(mask, shape) for mask in masks]
    kept = np.max(masks, axis=0) if masks else None
    return kept if kept is not None and kept.any() else None
