"""What a worker makes of a terrain when it is asked for `plants`: where they stand, their meshes.

A request has `layers`, a dictionary of "trees" and "ground_cover", each with `region` and
`most_plants` as `Terrain.plants` takes them; `variants`, how many meshes of each kind; `quality`
of trees as `make_tree` takes it.

Arrays are called "LAYER/positions" (n, 3; metres from the grid's lower-left corner), "LAYER/kinds",
"LAYER/scales", "LAYER/rotations", and "NAME VARIANT/positions", "…/corners" and so on as a
`PlantMesh` has them.
"""

import hashlib
import json

import numpy as np

from . import vegetation

STAGES = ("lakes", "climate", "biomes", "vegetation")
FIELDS = ("elevation", "biome", "water_depth", "snow_cover")  # shown where the terrain has them
COLORS = ("bark_color", "stem_color", "leaf_color", "other_leaf_color", "petal_color")
ARRAYS = ("positions", "corners", "face_starts", "uvs", "materials")


def with_plants(document, stages):
    """A recipe, as a dictionary, with the stages that plants need and that it lacks.

    `stages`: as `orogen.schema` describes them.
    """
    writes = {stage["name"]: set(stage["writes"]) for stage in stages}
    present = [stage["stage"] for stage in document["stages"]]
    written = set().union(*(writes[name] for name in present))
    lacking = [{"stage": name} for name in STAGES if not writes[name] <= written]
    return {**document, "stages": [*document["stages"], *lacking]}


def make_plants(terrain, request, progress):
    """What a request asks for: arrays, and a description of the kinds that stand there.

    Parameters
    ----------
    terrain : Terrain
        With the stage `vegetation`.
    request : dict
    progress : callable
        Called as progress(stage, fraction); may raise.

    Returns
    -------
    arrays : dict
        Fields and the arrays above.
    plants : list of dict
        Of each kind that stands there: layer, kind (its place in that layer's table), name,
        variants (names of meshes), fingerprint (of what the meshes were made from), colors.
    """
    arrays = {name: terrain[name] for name in FIELDS if name in terrain}
    described = []
    for layer, wishes in request["layers"].items():
        cloud = terrain.plants(layer, wishes.get("region"), wishes["most_plants"])
        for name in ("positions", "kinds", "scales", "rotations"):
            arrays[f"{layer}/{name}"] = getattr(cloud, name)
        kinds = terrain.plant_tables[layer]["kinds"]
        standing = np.unique(cloud.kinds).tolist()
        described += [_describe(layer, kind, kinds[kind]["name"], request) for kind in standing]
    for i, plant in enumerate(described):
        progress("plants", i / len(described))
        for seed, variant in enumerate(plant["variants"]):
            mesh = _mesh(plant, seed, request["quality"])
            arrays |= {f"{variant}/{name}": getattr(mesh, name) for name in ARRAYS}
    return arrays, described


def _describe(layer, kind, name, request):
    species = _species(layer, name)
    wanted = json.dumps([species, request["quality"], request["variants"]], sort_keys=True)
    return {
        "layer": layer,
        "kind": kind,
        "name": name,
        "variants": [f"{name} {seed}" for seed in range(request["variants"])],
        "fingerprint": hashlib.sha256(wanted.encode()).hexdigest()[:16],
        "colors": {name: species[name] for name in COLORS if name in species},
    }


def _species(layer, name):
    known = vegetation.tree_species() if layer == "trees" else vegetation.ground_cover()
    return next((species for species in known if species["name"] == name), {})


def _mesh(plant, seed, quality):
    if plant["layer"] == "trees":
        return vegetation.make_tree(plant["name"], seed, quality=quality)
    return vegetation.make_ground_cover(plant["name"], seed)
