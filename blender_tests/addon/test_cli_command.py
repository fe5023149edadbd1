"""What `blender -b FILE --command orogen` does, called without Blender's command line."""

import contextlib
import io
import json


def command(*arguments):
    """Exit status, standard output and the lines of standard error."""
    import steps

    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = steps.addon("cli_command").main([str(a) for a in arguments])
    return status, out.getvalue(), err.getvalue().splitlines()


def two_terrains(file):
    """Saves a .blend with two terrains and opens it."""
    import bpy
    import steps

    for name, seed in (("North", 1), ("South", 2)):
        steps.corsica(resolution=48, seed=seed).name = name
    bpy.ops.wm.save_as_mainfile(filepath=str(file))
    return file


def test_generate_grows_all_and_saves(tmp_path):
    import bpy
    import numpy as np
    import orogen
    import steps

    file = two_terrains(tmp_path / "two.blend")
    status, text, complaints = command("generate", "--threads", "1")
    assert (status, complaints) == (0, []), complaints
    assert text.splitlines()[:2] == ["North: 1200 vertices", "South: 1200 vertices"], text
    bpy.ops.wm.open_mainfile(filepath=str(file))
    for name in ("North", "South"):
        terrain = bpy.data.objects[name]
        recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
        expected = orogen.generate(recipe)["elevation"].ravel()
        assert np.array_equal(steps.attribute(terrain, "elevation"), expected)


def test_generate_one_elsewhere_at_another_size(tmp_path):
    import bpy

    file = two_terrains(tmp_path / "two.blend")
    before = file.read_bytes()
    other = tmp_path / "other.blend"
    status, _, complaints = command("generate", "South", "--resolution", 64, "--save", other)
    assert (status, complaints) == (0, [])
    assert file.read_bytes() == before
    bpy.ops.wm.open_mainfile(filepath=str(other))
    assert bpy.data.objects["South"].orogen.resolution == 64
    assert len(bpy.data.objects["South"].data.vertices) > 0
    assert len(bpy.data.objects["North"].data.vertices) == 0


def test_export_and_recipe(tmp_path):
    import orogen

    file = two_terrains(tmp_path / "two.blend")
    before = file.read_bytes()
    recipe = tmp_path / "north.orogen.json"
    assert command("recipe", "North", recipe) == (0, "", [])
    expected = orogen.generate(recipe).report["sha256"]
    status, _, complaints = command("generate", "--export", tmp_path / "out", "--format", "vdb")
    assert (status, complaints) == (0, [])
    report = json.loads((tmp_path / "out/North/report.json").read_text())
    assert report["sha256"] == expected and report["formats"] == ["npz", "vdb"]
    assert (tmp_path / "out/South/ground.vdb").exists()
    assert file.read_bytes() == before


def test_report():
    import orogen
    import steps

    steps.corsica(resolution=48)
    status, text, _ = command("report")
    rows = dict(line.split(": ", 1) for line in text.splitlines())
    assert status == 0 and rows["Core"] == orogen.__version__
    assert rows["Orogen"].startswith(orogen.__version__)
    assert len(rows["Recipe"].split(",")[0]) == 64 and "48 cells" in rows["Recipe"]
    assert "GiB" in rows["Memory available"] and rows["Message"] == "none"


def test_report_when_the_core_fails():
    import steps

    launch = steps.addon("worker.launch")
    launch.environment = lambda: {"PYTHONPATH": "/nowhere"}
    status, text, _ = command("report")
    assert status == 0 and "Core: failed: ModuleNotFoundError" in text


def refused(says, *arguments):
    status, _, complaints = command(*arguments)
    assert status == 2, complaints
    assert len(complaints) == 1 and complaints[0].startswith("orogen: "), complaints
    assert says in complaints[0], complaints


def test_complaints_are_one_line(tmp_path):
    import bpy
    import steps

    refused("--save or --export", "generate")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "none.blend"))
    refused("has no terrain", "generate")
    two_terrains(tmp_path / "two.blend")
    refused("'West'", "generate", "West")
    refused("--resolution: 1 ", "generate", "--resolution", 1)
    refused("'shp'", "generate", "--export", tmp_path / "out", "--format", "shp")
    assert not (tmp_path / "out").exists()
    refused("nowhere", "recipe", "North", tmp_path / "nowhere/a.json")
    bad = tmp_path / "bad.geojson"
    bad.write_text('{"type": "FeatureCollection", "features": []}')
    steps.new_terrain(source="FILE", path=str(bad)).name = "Bad"
    refused("Bad: ", "generate", "Bad", "--save", tmp_path / "bad.blend")
    assert not (tmp_path / "bad.blend").exists()
    status, _, complaints = command("grow")
    assert status == 2 and "invalid choice: 'grow'" in complaints[-1]
    assert command("--help")[0] == 0


def test_operator_prints_the_report_in_the_background():
    import bpy

    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        assert bpy.ops.orogen.copy_system_report() == {"FINISHED"}
    assert "Terrain: none is active" in out.getvalue()
