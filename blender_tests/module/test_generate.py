"""orogen.Recipe, orogen.generate, orogen.Terrain."""

import gc
import hashlib
import json
import subprocess
import sys
import threading

import numpy as np
import orogen
import pytest


def digests(terrain):
    return {name: hashlib.sha256(terrain[name].data).hexdigest() for name in terrain}


def test_a_terrain_has_every_field_its_stages_write(recipe):
    terrain = orogen.generate(recipe)
    stages = {stage["name"]: stage for stage in orogen.schema()["stages"]}
    names = [item["stage"] for item in recipe.to_dict()["stages"]]
    assert set(terrain.fields) == {field for name in names for field in stages[name]["writes"]}
    declared = {field["name"]: field for field in orogen.schema()["fields"]}
    for name in terrain:
        assert terrain[name].shape == (terrain.grid.ny, terrain.grid.nx) == terrain.grid.shape
        assert terrain[name].dtype == declared[name]["type"]
        assert terrain[name].flags.c_contiguous
        assert np.isfinite(terrain[name]).all()
    assert "elevation" in terrain
    with pytest.raises(KeyError):
        terrain["altitude"]


def test_land_and_sea_lie_where_the_map_says(recipe):
    terrain = orogen.generate(recipe)
    land = terrain["land"] == 1
    assert 0.3 < land.mean() < 0.8
    assert (terrain["elevation"][~land] <= 0).all()
    grid = terrain.grid
    assert grid.origin == (-20000, -15000)
    row = int((18000 + -15000 - grid.origin[1]) / grid.cell_size)
    column = int((21000 + -20000 - grid.origin[0]) / grid.cell_size)
    assert land[row, column]


@pytest.mark.parametrize("resolution", [2, 3, 31, 97])
def test_any_resolution(recipe, resolution):
    terrain = orogen.generate(recipe, resolution=resolution)
    assert max(terrain.grid.shape) == resolution
    assert np.isfinite(terrain["elevation"]).all()


def test_the_same_bytes_on_any_number_of_threads_and_in_every_run(recipe):
    first = digests(orogen.generate(recipe, threads=1, cache=None))
    for threads in (1, 2, 4):
        assert digests(orogen.generate(recipe, threads=threads, cache=None)) == first


def test_seed(recipe):
    default = orogen.generate(recipe)
    other = orogen.generate(recipe, seed=12)
    assert other.seed == 12 and default.seed == recipe.seed
    assert digests(other)["elevation"] != digests(default)["elevation"]


def test_the_cache_spares_what_did_not_change(recipe):
    cache = orogen.Cache(1 << 30)
    first = orogen.generate(recipe, cache=cache)
    assert first.report["from_cache"] == []
    again = orogen.generate(recipe, cache=cache)
    assert again.report["from_cache"] == list(first.report["seconds"])
    assert digests(again) == digests(first)
    assert 0 < cache.bytes <= cache.capacity_bytes
    document = recipe.to_dict()
    document["stages"][-1]["parameters"] = {"shelf_depth": 99}
    changed = orogen.generate(document, cache=cache)
    assert len(changed.report["from_cache"]) == len(document["stages"]) - 1
    cache.clear()
    assert len(cache) == 0


def test_arrays_outlive_everything_else(recipe):
    cache = orogen.Cache(1 << 30)
    terrain = orogen.generate(recipe, cache=cache)
    array = terrain["elevation"]
    copy = array.copy()
    row = array[3]
    del terrain
    cache.clear()
    gc.collect()
    orogen.generate(recipe, seed=5, cache=cache)
    assert (array == copy).all() and (row == copy[3]).all()


def test_arrays_are_views_and_read_only(recipe):
    terrain = orogen.generate(recipe)
    a, b = terrain["elevation"], terrain["elevation"]
    assert np.shares_memory(a, b)
    assert not a.flags.owndata
    with pytest.raises(ValueError):
        a[0, 0] = 1


def test_the_gil_is_free_during_the_work(recipe):
    done = threading.Event()
    ticks = []

    def tick():
        while not done.wait(0.001):
            ticks.append(1)

    thread = threading.Thread(target=tick)
    thread.start()
    orogen.generate(recipe, cache=None)
    done.set()
    thread.join()
    assert len(ticks) > 5


def test_progress_is_monotone_and_on_the_calling_thread(recipe):
    seen = []
    orogen.generate(
        recipe,
        cache=None,
        progress=lambda stage, fraction: seen.append((stage, fraction, threading.get_ident())),
    )
    fractions = [fraction for _, fraction, _ in seen]
    assert fractions == sorted(fractions) and fractions[-1] == pytest.approx(1.0)
    assert {ident for _, _, ident in seen} == {threading.get_ident()}
    stages = [item["stage"] for item in recipe.to_dict()["stages"]]
    assert list(dict.fromkeys(stage for stage, _, _ in seen)) == stages


def test_an_exception_in_progress_comes_through(recipe):
    def fail(stage, fraction):
        raise LookupError(stage)

    with pytest.raises(LookupError, match="land"):
        orogen.generate(recipe, progress=fail, cache=None)
    with pytest.raises(TypeError):
        orogen.generate(recipe, progress=3)


def test_recipes_go_out_and_in(recipe, tmp_path):
    document = recipe.to_dict()
    assert orogen.Recipe.from_dict(document).hash == recipe.hash
    recipe.save(tmp_path / "a.orogen.json")
    loaded = orogen.Recipe.load(tmp_path / "a.orogen.json")
    assert loaded.hash == recipe.hash
    assert loaded.to_dict() == document
    assert hashlib.sha256(recipe._core.to_json().encode()).hexdigest() == recipe.hash


def test_everything_that_is_a_recipe(recipe, island, recipe_file, tmp_path):
    expected = digests(orogen.generate(recipe))
    assert digests(orogen.generate(recipe_file)) == expected
    assert digests(orogen.generate(str(recipe_file))) == expected
    assert digests(orogen.generate(recipe.to_dict())) == expected
    bare = tmp_path / "island.geojson"
    bare.write_text(json.dumps(island))
    assert digests(orogen.generate(bare, resolution=96)) == expected
    assert digests(orogen.generate(island, resolution=96)) == expected
    beside = tmp_path / "beside.orogen.json"
    beside.write_text(json.dumps({"orogen": 1, "map": {"file": "island.geojson"}}))
    assert orogen.Recipe.load(beside).name == "beside"
    assert digests(orogen.generate(beside, resolution=96)) == expected


def test_the_recipes_that_ship():
    assert orogen.shipped() == [
        "alternating_beds",
        "andes",
        "cirque",
        "corsica",
        "corsica_biomes",
        "corsica_folded_strata",
        "cyprus",
        "digne",
        "folded_range",
        "forested_folds",
        "hard_cap",
        "imaginary",
        "island",
        "new_zealand",
        "one_fold_layer",
        "two_fold_layers_10_5",
        "two_fold_layers_15_3",
        "viscous_only",
        "zagros",
    ]


@pytest.mark.parametrize("name", orogen.shipped())
def test_shipped_recipes(name):
    recipe = orogen.Recipe.load(name)
    assert recipe.name == name
    assert np.isfinite(orogen.generate(recipe, resolution=64)["elevation"]).all()


def test_refusals_are_input_errors_that_name_the_place(recipe, island, tmp_path):
    assert issubclass(orogen.InputError, ValueError)

    def refusal(document, **options):
        with pytest.raises(orogen.InputError) as caught:
            orogen.generate(document, **options)
        return str(caught.value)

    document = recipe.to_dict()
    document["stages"][2]["parameters"] = {"plate_speed": 99}
    assert refusal(document).startswith("stages[2].parameters.plate_speed: 99")
    assert "sed" in refusal({"orogen": 1, "map": island, "sed": 1})
    assert refusal({"orogen": 1, "map": island, "seed": float("nan")}).startswith("seed: ")
    corner = {"origin": [0, 0], "size": [1, float("inf")]}
    assert refusal({"orogen": 1, "map": island, "extent": corner}).startswith("extent.size[1]: ")
    assert "cannot be read" in refusal(tmp_path / "missing.geojson")
    assert "resolution: 1" in refusal(recipe, resolution=1)
    assert "resolution: -1" in refusal(recipe, resolution=-1)
    assert "seed: -1" in refusal(recipe, seed=-1)
    assert "threads: -1" in refusal(recipe, threads=-1)
    island["features"][2]["geometry"]["coordinates"] = [39, 29]
    assert "peak" in refusal(island).lower()
    for key, value in (("a", object()), ("b", [])):
        with pytest.raises((orogen.InputError, TypeError)):
            orogen.generate({"orogen": 1, key: value})


def test_too_much_memory_is_refused_with_figures(recipe):
    with pytest.raises(orogen.MemoryLimitError, match="bytes") as caught:
        orogen.generate(recipe, resolution=20000, memory_limit_bytes=10**9)
    assert isinstance(caught.value, MemoryError)
    assert "1000000000 bytes" in str(caught.value)


def test_report(recipe):
    terrain = orogen.generate(recipe, cache=None)
    report = terrain.report
    json.dumps(report)
    assert report["sha256"] == digests(terrain)
    assert report["recipe_sha256"] == recipe.hash
    assert report["version"] == orogen.__version__
    assert list(report["seconds"]) == [item["stage"] for item in recipe.to_dict()["stages"]]
    assert all(seconds >= 0 for seconds in report["seconds"].values())
    assert report["projection"].startswith("+proj=aeqd")
    assert report["peak_memory_bytes"] is None or report["peak_memory_bytes"] > 1 << 20
    assert report["grid"]["cell_size"] == terrain.grid.cell_size


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_peak_memory_lies_within_the_estimate():
    """In a process of its own, so that nothing else counts."""
    code = """
import orogen
from orogen.report import peak_memory_bytes as peak
orogen.generate("imaginary", resolution=16, cache=None)
before = peak()
terrain = orogen.generate("imaginary", resolution=900, cache=None)
print(peak() - before, terrain.report["estimated_memory_bytes"])
"""
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    peak, estimate = map(int, result.stdout.split())
    assert 0.4 * estimate < peak < 1.2 * estimate
