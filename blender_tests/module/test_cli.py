"""python -m orogen, as a process."""

import json
import os
import subprocess
import sys

import numpy as np
import orogen
import pytest


def run(*arguments, timeout=120):
    return subprocess.run(
        [sys.executable, "-m", "orogen", *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=timeout,
    )


def test_generate_writes_what_it_says(recipe, recipe_file, tmp_path):
    out = tmp_path / "deep" / "out"
    result = run("generate", recipe_file, "-o", out, "--resolution", 80, "--threads", 2)
    assert result.returncode == 0, result.stderr
    assert {"island.npz", "report.json", "island.orogen.json"} <= set(os.listdir(out))
    terrain = orogen.generate(recipe, resolution=80)
    with np.load(out / "island.npz") as archive:
        assert set(archive.files) == {*terrain.fields, "cell_size", "origin"}
        assert archive["cell_size"] == terrain.grid.cell_size
        assert archive["origin"].tolist() == list(terrain.grid.origin)
        for name in terrain:
            assert archive[name].dtype == terrain[name].dtype
            assert (archive[name] == terrain[name]).all()
    report = json.loads((out / "report.json").read_text())
    assert report["sha256"] == terrain.report["sha256"]
    assert orogen.Recipe.load(out / "island.orogen.json").hash == recipe.hash
    assert os.listdir(tmp_path / "deep") == ["out"]


def test_seed_and_geojson(island, tmp_path):
    file = tmp_path / "m.geojson"
    file.write_text(json.dumps(island))
    result = run("generate", file, "-o", tmp_path / "out", "--resolution", 40, "--seed", 3)
    assert result.returncode == 0, result.stderr
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    assert report["seed"] == 3
    digest = orogen.generate(file, resolution=40, seed=3).report["sha256"]
    assert report["sha256"] == digest


BAD = [
    ("{", "JSON"),
    ("[]", "neither a recipe"),
    ('{"orogen": 1}', "map"),
    ('{"orogen": 9, "map": {}}', "orogen: 9"),
    ('{"type": "FeatureCollection", "features": []}', ""),
    ("[" * 100000, "64"),
    ("\x00\xff", "JSON"),
]


@pytest.mark.parametrize("text, says", BAD)
def test_bad_input_is_one_line_and_nothing_is_written(text, says, tmp_path):
    file = tmp_path / "bad.json"
    file.write_text(text, encoding="latin-1")
    result = run("generate", file, "-o", tmp_path / "out")
    assert result.returncode == 2
    assert len(result.stderr.splitlines()) == 1
    assert result.stderr.startswith("orogen: ") and says in result.stderr
    assert result.stdout == ""
    assert os.listdir(tmp_path) == ["bad.json"]


@pytest.mark.parametrize(
    "arguments, says",
    [
        (["--resolution", "1"], "resolution: 1"),
        (["--resolution", "70000"], "resolution: 70000"),
        (["--resolution", "30000", "--memory-limit", "0.5"], "536870912 bytes"),
        (["--threads", "-2"], "threads: -2"),
        (["--seed", "-2"], "seed: -2"),
        (["--fields", "altitude"], "altitude"),
    ],
)
def test_bad_options(recipe_file, tmp_path, arguments, says):
    result = run("generate", recipe_file, "-o", tmp_path / "out", *arguments)
    assert result.returncode == 2
    assert len(result.stderr.splitlines()) == 1 and says in result.stderr
    assert not (tmp_path / "out").exists()


def test_output_that_cannot_be_written(recipe_file, tmp_path):
    (tmp_path / "file").write_text("")
    result = run("generate", recipe_file, "-o", tmp_path / "file", "--resolution", 20)
    assert result.returncode == 2 and len(result.stderr.splitlines()) == 1
    assert (tmp_path / "file").read_text() == ""


def test_strict_refuses_what_is_mended(island, tmp_path):
    island["features"][1]["geometry"]["coordinates"][-1] = [5.5, 8.2]  # ends short of the coast
    file = tmp_path / "m.geojson"
    file.write_text(json.dumps(island))
    mended = run("generate", file, "-o", tmp_path / "out", "--resolution", 20)
    assert mended.returncode == 0
    assert "warning" in mended.stderr
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    assert report["warnings"]
    strict = run("generate", file, "-o", tmp_path / "strict", "--resolution", 20, "--strict")
    assert strict.returncode == 2 and not (tmp_path / "strict").exists()


def test_schema():
    result = run("schema")
    assert result.returncode == 0
    schema = json.loads(result.stdout)
    assert json.loads(json.dumps(orogen.schema())) == schema
    for stage in schema["stages"]:
        for parameter in stage["parameters"]:
            assert set(parameter) == {
                "name", "type", "default", "min", "max", "unit", "description", "choices"
            }  # fmt: skip
            assert parameter["type"] in ("bool", "int", "float", "choice")
    assert set(schema["default_stages"]) <= {stage["name"] for stage in schema["stages"]}


def test_info(recipe, recipe_file, tmp_path):
    result = run("info", recipe_file)
    assert json.loads(result.stdout)["recipe_sha256"] == recipe.hash
    run("generate", recipe_file, "-o", tmp_path, "--resolution", 20)
    info = json.loads(run("info", tmp_path / "island.npz").stdout)
    assert info["shape"] == [15, 20]
    assert info["fields"]["elevation"]["dtype"] == "float32"
    bad = tmp_path / "bad.npz"
    bad.write_bytes(b"PK\x03\x04 no archive")
    result = run("info", bad)
    assert result.returncode == 2 and len(result.stderr.splitlines()) == 1


@pytest.mark.parametrize("name", ["corsica", "cyprus", "imaginary"])
def test_shipped_names(name, tmp_path):
    result = run("generate", name, "-o", tmp_path / "out", "--resolution", 32)
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "out" / f"{name}.npz").exists()
