"""Files of folded rocks, and the command that cuts them open."""

import json
import os
import re
import subprocess
import sys
from xml.etree import ElementTree

import numpy as np
import orogen
import pytest
from orogen import files, rock_files


@pytest.fixture
def terrain(collision):
    collision["extent"]["origin"] = [5e3, -2e3]
    return orogen.generate(collision)


@pytest.fixture
def collision_file(collision, tmp_path):
    file = tmp_path / "range.orogen.json"
    file.write_text(json.dumps(collision))
    return file


def run(*arguments):
    return subprocess.run(
        [sys.executable, "-m", "orogen", *map(str, arguments)],
        capture_output=True, text=True, timeout=120,
    )  # fmt: skip


def read_ply(file):
    plyfile = pytest.importorskip("plyfile")
    data = plyfile.PlyData.read(file)
    points = np.stack([data["vertex"][axis] for axis in "xyz"], axis=1)
    return points, data["face"].data, data.comments


def test_ply_has_every_face_with_its_rock(terrain, tmp_path):
    terrain.save(tmp_path, formats=["ply"], pictures=False)
    rocks = terrain.rocks
    names = ["block.ply", *(f"horizon_{k}.ply" for k in range(len(rocks.horizons)))]
    assert sorted(n for n in os.listdir(tmp_path) if n.endswith("ply")) == sorted(names)
    meshes = [rocks.block_diagram(), *(rocks.horizon_mesh(k) for k in range(len(rocks.horizons)))]
    for name, mesh in zip(names, meshes, strict=True):
        points, faces, comments = read_ply(tmp_path / name)
        assert (points == mesh["vertices"]).all()
        assert "metres from 5000.0 -2000.0" in comments[0]
        rows = [(*f[0], *list(f)[1:]) for f in faces]
        expected = zip(mesh["faces"], mesh["color"], mesh["layer"], mesh["sub_layer"], strict=True)
        assert rows == [(*f, *c, layer, sub) for f, c, layer, sub in expected]
    assert read_ply(tmp_path / "block.ply")[0][:, 0].min() == pytest.approx(
        terrain.grid.cell_size / 2
    )


def test_corners_named_twice_make_triangles(tmp_path):
    mesh = {
        "vertices": np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 5]], np.float32),
        "faces": np.array([[0, 1, 2, 2], [0, 1, 2, 3], [0, 0, 2, 3], [3, 1, 2, 3]], np.int32),
        "color": np.arange(12, dtype=np.uint8).reshape(4, 3),
        "layer": np.array([1, 2, 3, 4], np.int32),
        "sub_layer": np.zeros(4, np.int32),
    }
    rock_files.write_ply(tmp_path / "m.ply", mesh, (0.0, 0.0))
    _, faces, _ = read_ply(tmp_path / "m.ply")
    assert {int(f["layer"]): f["vertex_indices"].tolist() for f in faces} == {
        1: [0, 1, 2],
        2: [0, 1, 2, 3],
        3: [0, 2, 3],
        4: [3, 1, 2],
    }
    assert {int(f["layer"]): int(f["green"]) for f in faces} == {1: 1, 2: 4, 3: 7, 4: 10}


def test_section_files(terrain, tmp_path):
    image = pytest.importorskip("PIL.Image")
    line = [(10e3, 50e3), (95e3, 60e3)]
    terrain.save(tmp_path, formats=["section", "ply"], section=line)
    section = terrain.rocks.section(line)
    svg = ElementTree.parse(tmp_path / "section.svg").getroot()
    assert svg.tag.endswith("svg")
    assert len(svg.findall("{*}polygon")) == len(section.bands)
    picture = np.asarray(image.open(tmp_path / "section.png"))
    assert max(picture.shape) == rock_files.LARGEST
    assert 0.2 < picture.shape[0] / picture.shape[1] < 0.4
    colors = {band["color"] for band in section.bands}
    assert {tuple(c) for c in np.unique(picture[picture[..., 3] > 0][:, :3], axis=0)} <= colors
    points, faces, _ = read_ply(tmp_path / "section.ply")
    assert points[:, 2].max() == pytest.approx(section.surface.max())
    assert points[:, :2].min(0) == pytest.approx((5e3, 52e3))
    assert {tuple(f) for f in faces[["red", "green", "blue"]].tolist()} <= colors
    terrain.save(tmp_path / "default", formats=["section"], pictures=False)
    assert not (tmp_path / "default" / "section.ply").exists()


def test_default_section_runs_through_the_middle(terrain):
    assert rock_files.section_line(terrain.grid) == [(55e3, -2e3), (55e3, 98e3)]


@pytest.mark.parametrize(
    "line, says",
    [
        ([(0, 0), (50e3, 50e3)], r"\(0, 0\) lies outside .* \(5000, -2000\) to \(105000, 98000\)"),
        ([(50e3, 50e3), (50e3, float("nan"))], "nan.* lies outside"),
        ([(50e3, 50e3), (50e3, 50e3)], "same place"),
    ],
)
def test_bad_lines(terrain, tmp_path, line, says):
    with pytest.raises(orogen.InputError, match=f"section: .*{says}"):
        terrain.save(tmp_path / "out", formats=["section"], section=line)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", files.ROCK_FORMATS)
def test_a_terrain_without_rocks_is_refused(recipe, tmp_path, name):
    terrain = orogen.generate(recipe, resolution=16)
    with pytest.raises(orogen.InputError, match="no column"):
        terrain.save(tmp_path / "out", formats=[name])
    assert not (tmp_path / "out").exists()


def test_a_recipe_without_an_outcrop_is_refused(collision, tmp_path):
    stages = orogen.schema()["collision_stages"]
    collision["stages"] = [{"stage": s} for s in stages if s != "outcrop"]
    terrain = orogen.generate(collision)
    assert terrain.rocks is None
    with pytest.raises(orogen.InputError, match="stage 'outcrop'"):
        terrain.save(tmp_path / "out", formats=["ply"])


def test_volume_of_the_rocks_beside_the_ground(terrain, recipe, tmp_path):
    terrain.save(tmp_path, formats=["vdb"], pictures=False)
    assert {"ground.vdb", "rock.vdb"} <= set(os.listdir(tmp_path))
    data = (tmp_path / "rock.vdb").read_bytes()
    assert data.startswith(b" BDV\0\0\0\0")
    for layer in terrain.rocks.column["layers"]:
        assert f"{layer['name']}/{layer['sub_layers'][0]['lithology']}".encode() in data
    orogen.generate(recipe, resolution=16).save(tmp_path / "map", formats=["vdb"], pictures=False)
    assert not (tmp_path / "map" / "rock.vdb").exists()


def test_strata_picture(terrain, tmp_path):
    image = pytest.importorskip("PIL.Image")
    terrain.save(tmp_path)
    picture = np.asarray(image.open(tmp_path / "strata.png"))[::-1].astype(float)
    shade = np.asarray(image.open(tmp_path / "hillshade.png"))[::-1] / 255
    color = terrain["strata_color"]
    for k, shift in enumerate((16, 8, 0)):
        own = (color >> shift & 255) * (0.35 + 0.85 * shade)
        assert picture[..., k] == pytest.approx(np.minimum(own, 255), abs=1.5)


def test_generate_writes_rocks(collision_file, tmp_path):
    out = tmp_path / "out"
    result = run(
        "generate", collision_file, "-o", out, "--resolution", 32, "--format", "ply",
        "--section", 0, 20e3, 100e3, 20e3,
    )  # fmt: skip
    assert result.returncode == 0, result.stderr
    wanted = {"section.svg", "section.png", "section.ply", "block.ply", "horizon_0.ply"}
    assert wanted | {"strata.png", "range.npz"} <= set(os.listdir(out))
    grounds = re.findall(r"<polyline", (out / "section.svg").read_text())
    assert len(grounds) == 1


@pytest.mark.parametrize("suffix", rock_files.SECTION_SUFFIXES)
def test_section_command(collision_file, tmp_path, suffix):
    file = tmp_path / "out" / f"cut{suffix}"
    result = run("section", collision_file, "-o", file, "--resolution", 32)
    assert result.returncode == 0, result.stderr
    assert os.listdir(tmp_path / "out") == [file.name]
    starts = {".svg": b"<svg", ".png": b"\x89PNG", ".ply": b"ply\n"}
    assert file.read_bytes().startswith(starts[suffix])


@pytest.mark.parametrize(
    "arguments, says",
    [
        (["section", "RECIPE", "-o", "out/a.jpg"], "--output: '.jpg'"),
        (["section", "RECIPE", "-o", "out/a.svg", "--line", "0", "0", "0", "0"], "same place"),
        (["section", "RECIPE", "-o", "out/a.svg", "--line", "-9", "0", "9", "9"], "(-9, 0) lies"),
        (["section", "corsica", "-o", "out/a.svg"], "no column"),
        (["section", "nowhere", "-o", "out/a.svg"], "nowhere"),
        (["generate", "corsica", "-o", "out", "--format", "section"], "no column"),
        (["generate", "corsica", "-o", "out", "--format", "ply"], "no column"),
        (["generate", "RECIPE", "-o", "out", "--section", "0", "0", "2e5", "0"], "(200000, 0)"),
    ],
)
def test_bad_commands(collision_file, tmp_path, monkeypatch, arguments, says):
    monkeypatch.chdir(tmp_path)
    result = run(*(collision_file if a == "RECIPE" else a for a in arguments))
    assert result.returncode == 2
    assert len(result.stderr.splitlines()) == 1 and says in result.stderr
    assert not (tmp_path / "out").exists()


def test_info_and_schema_know_plates(collision_file):
    info = json.loads(run("info", collision_file).stdout)
    schema = json.loads(run("schema").stdout)
    assert [s["stage"] for s in info["stages"]] == schema["collision_stages"]
    assert info["inputs"] == {"phases": 1, "plates": [2], "layers": 4}
    inputs = {name for stage in schema["stages"] for name in stage["inputs"]}
    rasters = {f"rasters.{raster['name']}" for raster in schema["rasters"]}
    own = {"map", "phases", "column", "rain", "fold_edits", "features", "river_sources", "plants"}
    assert inputs == own | rasters
    assert {"alps", "jura"} <= set(schema["columns"])


@pytest.mark.parametrize("deposition", [0.0, 1.0])
def test_the_mesh_that_mountains_grew_on(collision, tmp_path, deposition):
    collision["extent"]["origin"] = [5e3, -2e3]
    parameters = {"deposition_coefficient": deposition, "steps": 10, "coarse_levels": 1}
    collision["stages"] = [
        {"stage": name, "parameters": parameters if name == "mountain_growth" else {}}
        for name in orogen.schema()["collision_stages"]
    ]
    terrain = orogen.generate(collision)
    tin = terrain.tin
    assert isinstance(tin, orogen.erosion.GrownTin) and isinstance(tin, orogen.erosion.Tin)
    assert tin.elevation.shape == (len(tin),)
    grid = terrain.grid
    on_grid = tin.sample_to_grid(tin.elevation, grid)
    assert np.corrcoef(on_grid.ravel(), terrain["elevation"].ravel())[0, 1] > 0.99
    assert len(tin.sediment_thickness) == (len(tin) if deposition else 0)
    with pytest.raises(ValueError, match="read-only"):
        tin.elevation[0] = 1
    terrain.save(tmp_path, formats=["tin"], pictures=False)
    points, faces, comments = read_ply(tmp_path / "tin.ply")
    assert "metres from 5000.0 -2000.0" in comments[0]
    assert points[:, :2] == pytest.approx(tin.points - grid.origin, abs=0.01)
    assert points[:, 2] == pytest.approx(tin.elevation, abs=1e-3)
    assert (np.stack([f[0] for f in faces]) == tin.triangles).all()
    header = (tmp_path / "tin.ply").read_bytes().split(b"end_header")[0]
    assert (b"sediment_thickness" in header) == bool(deposition)


def test_a_terrain_that_did_not_grow_has_no_mesh(recipe, tmp_path):
    terrain = orogen.generate(recipe, resolution=16)
    assert terrain.tin is None
    with pytest.raises(orogen.InputError, match="stage 'mountain_growth'"):
        terrain.save(tmp_path / "out", formats=["tin"])
    assert not (tmp_path / "out").exists()
