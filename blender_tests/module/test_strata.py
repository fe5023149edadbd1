"""orogen.strata: columns, and rocks seen from the side."""

import json

import numpy as np
import orogen
import pytest

COLUMN = {
    "basement": {"name": "old", "thickness": 500, "sub_layers": [{"lithology": "gneiss"}]},
    "layers": [
        {
            "name": "lower",
            "thickness": 300,
            "sub_layers": [
                {"lithology": "marl", "share": 2},
                {"lithology": "limestone", "share": 1},
            ],
        },
        {"name": "upper", "thickness": 200, "sub_layers": [{"lithology": "sandstone"}]},
    ],
}
CELL = 100.0


def heights():
    """Folded horizons, from the basement's top up, and a ground that cuts them."""
    y, x = np.mgrid[0:40, 0:60] * CELL
    deep = -400 + 150 * np.sin(x / 700) * np.cos(y / 1100)
    lower = deep + 300 + 50 * np.cos(x / 900)
    upper = lower + 200
    ground = 0.5 * (lower + upper) + 200 * np.sin(y / 500)
    return [h.astype(np.float32) for h in (deep, lower, upper)], ground.astype(np.float32)


@pytest.fixture
def rocks():
    return orogen.strata.Rocks.from_arrays(COLUMN, *heights(), CELL)


def bilinear(array, x, y):
    c, r = (np.clip(v / CELL - 0.5, 0, n - 1) for v, n in ((x, 60), (y, 40)))
    i, j = min(int(r), 38), min(int(c), 58)
    u, v = r - i, c - j
    low = (1 - v) * array[i, j] + v * array[i, j + 1]
    high = (1 - v) * array[i + 1, j] + v * array[i + 1, j + 1]
    return (1 - u) * low + u * high


def rock_of(horizons, x, y, z):
    """Layer and sub-layer, by the definition."""
    h = [bilinear(a, x, y) for a in horizons]
    layer = sum(z > top for top in h)
    share = (z - h[0]) / (h[1] - h[0])
    return layer, int(layer == 1 and share > 2 / 3)


def test_rock_at_is_the_definition(rocks):
    horizons, _ = heights()
    random = np.random.default_rng(1)
    seen = set()
    for x, y, z in zip(*random.uniform((0, 0, -900), (6000, 4000, 400), (400, 3)).T, strict=True):
        rock = rocks.rock_at(x, y, z)
        assert (rock["layer"], rock["sub_layer"]) == rock_of(horizons, x, y, z)
        seen.add(rock["lithology"])
        if rock["layer"] in (1, 2):
            top = bilinear(horizons[rock["layer"]], x, y)
            assert rock["depth_in_layer"] == pytest.approx(top - z, abs=0.01)
    assert seen == {"gneiss", "marl", "limestone", "sandstone", "sediment"}
    assert all((a == b).all() for a, b in zip(rocks.horizons, horizons, strict=True))
    assert not rocks.horizons[0].flags.writeable
    assert [layer["name"] for layer in rocks.column["layers"]] == ["lower", "upper"]


def test_a_section_is_filled_with_the_rocks_that_lie_there(rocks):
    horizons, ground = heights()
    line = [(300.0, 200.0), (4000.0, 3500.0), (5500.0, 3500.0)]
    section = rocks.section(line, spacing=50, base=-1200)
    assert section.base == -1200
    length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
    assert section.distance[-1] == pytest.approx(length)
    steps = np.linalg.norm(np.diff(section.points, axis=0), axis=1)
    assert steps == pytest.approx(np.diff(section.distance), rel=1e-9) and steps.max() <= 50.001
    assert any((p == line[1]).all() for p in section.points)
    low = np.full(len(section.points), -1200.0)
    for band in section.bands:
        assert band["bottom"] == pytest.approx(low)
        low = band["top"]
        for i in np.flatnonzero(band["top"] - band["bottom"] > 1)[::7]:
            x, y = section.points[i]
            z = 0.5 * (float(band["bottom"][i]) + float(band["top"][i]))
            assert (band["layer"], band["sub_layer"]) == rock_of(horizons, x, y, z)
    assert low == pytest.approx(section.surface)
    expected = [bilinear(ground, x, y) for x, y in section.points]
    assert section.surface == pytest.approx(expected, abs=1e-2)


def test_a_sections_picture_shows_them(rocks):
    section = rocks.section([(500.0, 1000.0), (5500.0, 1000.0)], base=-1000)
    colors = {(b["layer"], b["sub_layer"]): b["color"] for b in section.bands}
    top = 300.0
    picture = section.picture(200, 130, top)
    assert picture.shape == (130, 200, 4) and picture.dtype == np.uint8
    wrong = 0
    for row in range(0, 130, 5):
        z = top - (row + 0.5) * 10
        for column in range(0, 200, 7):
            x = 500 + (column + 0.5) * 25
            rock = rocks.rock_at(x, 1000.0, z)
            pixel = picture[row, column]
            if pixel[3]:
                wrong += tuple(pixel[:3]) != colors[rock["layer"], rock["sub_layer"]]
            else:
                assert z > np.interp(x - 500, section.distance, section.surface) - 1
    assert wrong == 0
    svg = section.svg(2.0)
    assert svg.startswith("<svg") and "upper" in svg
    assert svg.count("<polygon") == len(section.bands)
    with pytest.raises(orogen.InputError, match="exaggeration: 0"):
        section.svg(0.0)
    with pytest.raises(orogen.InputError, match="top"):
        section.picture(10, 10, -2000.0)


@pytest.mark.parametrize(
    "line, keywords, says",
    [
        ([(0, 0)], {}, "line: at least 2"),
        ([(0, 0), (1000, 0)], {"spacing": 0}, "spacing: 0"),
        ([(0, 0), (1000, 0)], {"spacing": 1e-4}, "spacing: 1e-04"),
    ],
)
def test_bad_sections(rocks, line, keywords, says):
    with pytest.raises(orogen.InputError, match=says):
        rocks.section(line, **keywords)


def corners(faces):
    """Corners of faces, those that are named twice left out."""
    return [list(dict.fromkeys(face)) for face in faces.tolist()]


def test_the_block_is_closed_and_coloured(rocks):
    block = rocks.block_diagram(base=-1500)
    assert set(block) == {"vertices", "faces", "layer", "sub_layer", "color"}
    assert block["color"].shape == (len(block["faces"]), 3)
    volume, area = 0.0, np.zeros(3)  # of a closed surface the area vectors sum up to 0
    for face in corners(block["faces"]):
        points = block["vertices"][face].astype(float)
        for k in range(1, len(face) - 1):
            volume += np.linalg.det(points[[0, k, k + 1]]) / 6
            area += np.cross(points[k] - points[0], points[k + 1] - points[0]) / 2
    assert area == pytest.approx(0, abs=1e-5 * 6000 * 4000)
    _, ground = heights()
    weights = np.ones(ground.shape)
    weights[[0, -1]] *= 0.5
    weights[:, [0, -1]] *= 0.5
    expected = (weights * (ground.astype(float) + 1500)).sum() * CELL**2
    assert volume == pytest.approx(expected, rel=0.002)
    assert set(np.unique(block["layer"])) == {0, 1, 2, 3}
    with pytest.raises(orogen.InputError, match="base"):
        rocks.block_diagram(base=1000.0)


def test_horizons_as_meshes(rocks):
    horizons, ground = heights()
    whole = rocks.horizon_mesh(1, only_below_ground=False)
    assert len(whole["faces"]) == 39 * 59
    assert np.sort(whole["vertices"][:, 2]) == pytest.approx(np.sort(horizons[1].ravel()))
    cut = rocks.horizon_mesh(1)
    above = horizons[1] > ground
    covered = above[:-1, :-1] & above[1:, :-1] & above[:-1, 1:] & above[1:, 1:]
    assert len(cut["faces"]) == 39 * 59 - covered.sum() < 39 * 59
    with pytest.raises(orogen.InputError, match="horizon"):
        rocks.horizon_mesh(3)


def test_from_arrays_refuses():
    horizons, ground = heights()
    for arguments, keywords, says in [
        ((COLUMN, horizons[:2], ground, CELL), {}, "horizons: 2 are given"),
        ((COLUMN, horizons[::-1], ground, CELL), {}, r"horizons\[1\]: lies below"),
        ((COLUMN, [h[1:] for h in horizons], ground, CELL), {}, r"horizons\[0\]: shape"),
        ((COLUMN, horizons, ground * np.nan, CELL), {}, r"elevation\[0, 0\]: nan"),
        ((COLUMN, horizons, ground, -1), {}, "cell_size: -1"),
        (({"preset": "mars"}, horizons, ground, CELL), {}, "column"),
        (({"layers": {3}}, horizons, ground, CELL), {}, r"column.layers: a set"),
        ((COLUMN, horizons, ground, CELL), {"palette": "pink"}, "palette: 'pink'"),
        ((COLUMN, horizons, ground, CELL), {"colour": "map"}, "colour"),
    ]:
        with pytest.raises(orogen.InputError, match=says):
            orogen.strata.Rocks.from_arrays(*arguments, **keywords)
    other = orogen.strata.Rocks.from_arrays(COLUMN, horizons, ground, CELL, palette="map")
    first = orogen.strata.Rocks.from_arrays(COLUMN, horizons, ground, CELL)
    assert (other.block_diagram()["color"] != first.block_diagram()["color"]).any()


def test_wavelengths_are_those_of_buckling():
    column = orogen.strata.preset_column("jura")
    layers = [column["basement"], *column["layers"]]
    for layer in layers:
        layer["fold_wavelength"] = 0
    wavelengths = orogen.strata.fold_wavelengths(column)
    for below, layer, wavelength in zip(layers[:-1], layers[1:], wavelengths, strict=True):
        expected = (
            2 * np.pi * np.sqrt(layer["thickness"] * below["thickness"])
            * (layer["viscosity"] / (6 * below["viscosity"])) ** (1 / 6)
        )  # fmt: skip
        assert wavelength == pytest.approx(expected, rel=1e-9)
    for name in orogen.schema()["columns"]:
        assert orogen.strata.preset_column(name)["layers"]
    with pytest.raises(orogen.InputError, match="mars"):
        orogen.strata.preset_column("mars")


def test_the_schema_says_what_columns_are_made_of():
    schema = orogen.schema()
    layer = {item["name"]: item for item in schema["layer"]}
    assert list(layer) == ["thickness", "viscosity", "fold_wavelength", "fold_share"]
    names = [rock["name"] for rock in schema["lithologies"]]
    assert len(names) > 20 and all(0 <= rock["resistance"] <= 1 for rock in schema["lithologies"])
    for name, column in schema["columns"].items():
        assert column == orogen.strata.preset_column(name)
        for part in [column["basement"], *column["layers"]]:
            assert {bed["lithology"] for bed in part["sub_layers"]} <= set(names)
            assert all(layer[k]["min"] <= part[k] <= layer[k]["max"] for k in layer)
    column = orogen.strata.preset_column("jura")
    for name, item in layer.items():
        column["layers"][1][name] = 1.001 * item["max"]
        with pytest.raises(orogen.InputError, match=rf"layers\[1\].{name}"):
            orogen.strata.fold_wavelengths(column)
        column["layers"][1][name] = item["max"]
    assert orogen.strata.fold_wavelengths(column)


def test_the_rocks_of_a_terrain(collision):
    terrain = orogen.generate(collision)
    rocks = terrain.rocks
    horizons = np.array(rocks.horizons)
    assert horizons.shape == (5, *terrain.grid.shape) and (np.diff(horizons, axis=0) >= 0).all()
    assert json.dumps(rocks.column) == json.dumps(orogen.strata.preset_column("alps"))
    size = terrain.grid.cell_size
    for row, column in [(5, 7), (24, 24), (30, 40)]:
        place = ((column + 0.5) * size, (row + 0.5) * size)
        rock = rocks.rock_at(*place, float(terrain["elevation"][row, column]))
        assert rock["layer"] == terrain["rock_layer"][row, column]
        assert rock["sub_layer"] == terrain["rock_sublayer"][row, column]


def test_a_terrain_without_a_column_has_no_rocks(recipe):
    assert orogen.generate(recipe, resolution=16).rocks is None


def test_volume(rocks, tmp_path):
    rocks.write_volume(tmp_path / "rock.vdb", base=-1000, voxel_height=50)
    assert (tmp_path / "rock.vdb").read_bytes()[:8] == b" BDV\0\0\0\0"
    with pytest.raises(orogen.InputError):
        rocks.write_volume(tmp_path / "no" / "rock.vdb")


def test_traces_lie_on_the_ground_and_on_their_horizon(rocks):
    horizons, ground = heights()
    for k, horizon in enumerate(horizons):
        for trace in rocks.horizon_traces(k):
            assert trace.dtype == np.float32 and trace.shape[1] == 3
            for x, y, z in trace:
                assert z == pytest.approx(bilinear(ground, x, y), abs=0.05)
                assert z == pytest.approx(bilinear(horizon, x, y), abs=0.3)
    assert sum(len(trace) for trace in rocks.horizon_traces(1)) > 50
    with pytest.raises(orogen.InputError, match="horizon: 3"):
        rocks.horizon_traces(3)


def test_sediment_lies_on_the_rock():
    horizons, ground = heights()
    depth = np.maximum(0, -150 - ground)
    rocks = orogen.strata.Rocks.from_arrays(COLUMN, horizons, ground, CELL, depth)
    for row, column in [(0, 0), (10, 30), (25, 12), (35, 55), (30, 5), (33, 40)]:
        x, y = (column + 0.5) * CELL, (row + 0.5) * CELL
        top, z = float(ground[row, column] - depth[row, column]), float(ground[row, column])
        assert rocks.rock_at(x, y, top - 1)["layer"] == rock_of(horizons, x, y, top - 1)[0]
        if z > top + 0.2:
            assert rocks.rock_at(x, y, 0.5 * (top + z))["layer"] == 3
    with pytest.raises(orogen.InputError, match="sediment_thickness: at least 0"):
        orogen.strata.Rocks.from_arrays(COLUMN, horizons, ground, CELL, -1 - depth)


def test_rocks_of_a_terrain_agree_with_its_outcrop_under_sediment():
    recipe = orogen.Recipe.load("folded_range").to_dict()
    growth = next(s for s in recipe["stages"] if s["stage"] == "mountain_growth")
    growth["parameters"] = {
        **dict.fromkeys(("north_side", "east_side", "south_side"), "closed"),
        "deposition_coefficient": 1,
        "sediment_erodibility_factor": 0.5,
        "soft_erodibility": 1e-5,
    }
    terrain = orogen.generate(recipe, resolution=128)
    layers, cell = terrain["rock_layer"], terrain.grid.cell_size
    loose = len(terrain.rocks.column["layers"]) + 1
    assert (layers == loose).sum() > 50
    for row in range(0, layers.shape[0], 3):
        for column in range(0, layers.shape[1], 3):
            place = (column + 0.5) * cell, (row + 0.5) * cell
            rock = terrain.rocks.rock_at(*place, float(terrain["elevation"][row, column]))
            assert rock["layer"] == layers[row, column]
