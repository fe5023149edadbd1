"""Previews, and growth that is watched."""

import copy
import hashlib
import json
import subprocess
import sys

import numpy as np
import orogen
import pytest
from orogen.pipeline import shipped
from orogen.preview import (
    AT_MOST,
    OMITTED,
    RESOLUTION,
    averaged,
    generate_preview,
    preview_recipe,
)


def parameters(document):
    return {item["stage"]: item.get("parameters", {}) for item in document["stages"]}


def test_what_is_lightened_exists():
    known = {stage["name"]: stage for stage in orogen.schema()["stages"]}
    assert set(OMITTED) <= set(known)
    for stage, limits in AT_MOST.items():
        declared = {p["name"]: p for p in known[stage]["parameters"]}
        for name, limit in limits.items():
            assert declared[name]["min"] <= limit <= declared[name]["default"]


def test_seed_inputs_and_other_parameters_stay():
    recipe = orogen.Recipe.load("folded_range").to_dict()
    recipe["stages"][2]["parameters"]["steps"] = 4
    light = preview_recipe(recipe)
    assert light["resolution"] == RESOLUTION
    assert parameters(light)["mountain_growth"]["west_side"] == "closed"
    assert parameters(light)["mountain_growth"]["steps"] == 4, "fewer than a preview's"
    assert {k: v for k, v in light.items() if k not in ("resolution", "stages")} == {
        k: v for k, v in recipe.items() if k not in ("resolution", "stages")
    }


@pytest.mark.parametrize("kind", ["default_stages", "collision_stages"])
def test_default_stages(kind):
    recipe = orogen.Recipe.load("folded_range" if kind == "collision_stages" else "corsica")
    document = recipe.to_dict()
    del document["stages"]
    wanted = [name for name in orogen.schema()[kind] if name not in OMITTED]
    assert list(parameters(preview_recipe(document))) == wanted
    if kind == "default_stages":
        assert list(parameters(preview_recipe(document["map"]))) == wanted


@pytest.mark.parametrize("name", ["corsica", "folded_range", "corsica_folded_strata"])
def test_a_preview_is_the_terrain_at_large(name):
    document = orogen.Recipe.load(name).to_dict()
    preview, terrain = generate_preview(document), orogen.generate(document, resolution=RESOLUTION)
    a, b = preview["elevation"], terrain["elevation"]
    assert a.shape == b.shape and set(preview.fields) == set(terrain.fields)
    land = b > 0
    assert 0.7 < a[land].mean() / b[land].mean() < 1.3
    blocks = [
        z[: z.shape[0] // 16 * 16, : z.shape[1] // 16 * 16].reshape(-1, 16, z.shape[1] // 16, 16)
        for z in (a, b)
    ]
    coarse = [block.mean(axis=(1, 3)).ravel() for block in blocks]
    assert np.corrcoef(coarse)[0, 1] > 0.78


def test_every_shipped_recipe_has_a_preview():
    for name in shipped():
        terrain = generate_preview(orogen.Recipe.load(name).to_dict())
        assert max(terrain["elevation"].shape) == RESOLUTION, name


def test_a_seed_of_its_own():
    document = orogen.Recipe.load("folded_range").to_dict()
    other = generate_preview(document, seed=5)
    assert other.seed == 5
    same = generate_preview({**document, "seed": 5})
    assert np.array_equal(other["elevation"], same["elevation"])


HASH = """
import hashlib, json, sys
from orogen.preview import generate_preview
terrain = generate_preview(json.load(sys.stdin))
print(hashlib.sha256(b"".join(terrain[name].tobytes() for name in terrain)).hexdigest())
"""


def hash_of(terrain):
    return hashlib.sha256(b"".join(terrain[name].tobytes() for name in terrain)).hexdigest()


def dragged(document, x):
    """The same with the first plate's corner, or the first peak, moved."""
    document = copy.deepcopy(document)
    if "phases" in document:
        document["phases"][0]["plates"][0]["points"][0][0] += x
    else:
        features = document["map"]["features"]
        peak = next(f for f in features if f["properties"]["kind"] == "peak")
        peak["geometry"]["coordinates"][0] += 1e-5 * x
    return document


@pytest.mark.parametrize("name", ["folded_range", "corsica", "corsica_folded_strata"])
def test_whatever_was_grown_before_the_bytes_are_those_of_a_fresh_process(name):
    document = orogen.Recipe.load(name).to_dict()
    generate_preview(document, seed=77)
    for x in (100.0, 900.0, 300.0):
        moved = dragged(document, x)
        after_edits = hash_of(generate_preview(moved))
    again = hash_of(generate_preview(moved))
    fresh = subprocess.run(
        [sys.executable, "-c", HASH], input=json.dumps(moved), capture_output=True, text=True
    )
    assert after_edits == again == fresh.stdout.strip(), fresh.stderr


def test_rasters_are_averaged(tmp_path):
    values = np.random.default_rng(5).random((300, 700)).astype("f4")
    means = averaged(values)
    assert means.shape == (110, 256) and means.dtype == np.float32
    assert abs(means.mean(dtype=float) - values.mean(dtype=float)) < 1e-6
    even = values[:, :512]
    blocks = even.reshape(150, 2, 256, 2).mean(axis=(1, 3), dtype=float)
    assert np.abs(averaged(even) - blocks).max() < 1e-7
    assert averaged(even[:100, :256]) is not None and averaged(means) is means
    assert (averaged(np.ones((999, 600))) == 1.0).all()

    recipe = orogen.Recipe.load("folded_range").to_dict()
    file = tmp_path / "uplift.npy"
    for factor in (0.5 + values, 1.5 - values):  # a file that is written anew is read anew
        np.save(file, factor)
        inside, beside = (
            generate_preview({**recipe, "rasters": {"uplift_factor": raster}})["elevation"]
            for raster in (orogen.pack_raster(factor), {"file": str(file), "sha256": "of a host"})
        )
        assert np.array_equal(inside, beside)


def test_a_watch_changes_nothing():
    seen = []

    def watch(years, fields, grid):
        assert list(fields) == ["elevation"]
        elevation = fields["elevation"]
        assert elevation.shape == (grid.ny, grid.nx) and max(elevation.shape) <= 256
        seen.append((years, float(elevation.max())))

    watched = orogen.generate("folded_range", resolution=300, watch=watch, cache=None)
    alone = orogen.generate("folded_range", resolution=300, cache=None)
    assert np.array_equal(watched["elevation"], alone["elevation"])
    assert seen == sorted(seen) and len(seen) > 1
    assert seen[-1][1] > 500.0


def test_running_water_is_watched():
    """Its depth, and what it wore off and laid down. A fast machine shows the first step alone."""
    seen = []
    extent = {"origin": [0, 0], "size": [60e3, 60e3]}
    stages = [{"stage": "island"}, {"stage": "hydraulic_erosion"}]
    recipe = {"orogen": 1, "resolution": 400, "extent": extent, "stages": stages}
    watched = orogen.generate(recipe, watch=lambda *frame: seen.append(frame), cache=None)
    assert np.array_equal(watched["elevation"], orogen.generate(recipe, cache=None)["elevation"])
    years, fields, grid = seen[-1]
    assert list(fields) == ["elevation", "water_depth", "change"] and years > 0
    assert {values.shape for values in fields.values()} == {(grid.ny, grid.nx)}
    assert fields["water_depth"].max() > 0 and abs(fields["change"]).max() < 200


def test_an_error_of_the_watch_comes_back():
    def watch(*_):
        raise ZeroDivisionError("on purpose")

    with pytest.raises(ZeroDivisionError, match="on purpose"):
        orogen.generate("folded_range", resolution=128, watch=watch, cache=None)


def test_a_recipe_without_stages_gets_those_of_its_kind():
    extent = {"origin": [0, 0], "size": [9000, 9000]}
    heights = {"elevation": [[0, 100], [50, 200]]}
    for more in ({}, {"rasters": heights}, {"rasters": {"moisture_change": [[0.1]]}}):
        document = {"orogen": 1, "extent": extent, **more}
        core = orogen.Recipe.from_dict(document).to_dict()["stages"]
        asked = preview_recipe(document)["stages"]
        assert [s["stage"] for s in asked] == [s["stage"] for s in core]
        assert orogen.Recipe.from_dict(preview_recipe(document)).resolution == 256
