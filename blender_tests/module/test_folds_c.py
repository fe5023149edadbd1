"""orogen.folding of paper C: folds against their definitions, computed the slow way."""

import gc
import json

import numpy as np
import orogen
import pytest

WAVELENGTH = 3000.0
GRID = orogen.Grid(60, 50, 500.0, (1000.0, -2000.0))


@pytest.fixture
def field():
    """Compression along x, growing to the north."""
    strength = np.tile(np.linspace(0.1, 0.3, GRID.ny)[:, None], (1, GRID.nx))
    return orogen.tectonics.CompressionField.from_arrays(strength, 0 * strength, GRID)


def fold(field, edits=(), seed=1, **keywords):
    layer = {"fold_wavelength": WAVELENGTH, "speed_share": 0.2, "edits": list(edits)}
    return orogen.folding.fold_layers(field, [layer], seed, uplift_rate=1e-3, **keywords)[0]


def segments(lines):
    pieces = []
    for line in lines:
        points = np.vstack([line.points, line.points[:1]]) if line.closed else line.points
        pieces.append(np.hstack([points[:-1], points[1:]]))
    return np.vstack(pieces)


def distance_to(pieces, points):
    a, e = pieces[:, :2], pieces[:, 2:] - pieces[:, :2]
    least = np.full(len(points), np.inf)
    for start, way in zip(a, e, strict=True):
        t = np.clip(((points - start) @ way) / (way @ way), 0, 1)
        least = np.minimum(least, np.linalg.norm(points - start - t[:, None] * way, axis=1))
    return least


def centers():
    x = GRID.origin[0] + GRID.cell_size * (np.arange(GRID.nx) + 0.5)
    y = GRID.origin[1] + GRID.cell_size * (np.arange(GRID.ny) + 0.5)
    return np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)


def test_speed_is_that_between_crest_and_trough_lines(field):
    layer = fold(field)
    crest = distance_to(segments(layer.skeleton.top), centers())
    trough = distance_to(segments(layer.skeleton.bottom), centers())
    shape = (1 + np.cos(np.pi * crest / (crest + trough))) / 2
    expected = 0.2e-3 * field.compression_x * shape.reshape(GRID.shape)
    assert layer.speed == pytest.approx(expected, abs=1e-4 * 0.2e-3)
    assert layer.edits_without_effect == []


def test_crest_lines_are_the_chosen_edges(field):
    skeleton = fold(field).skeleton
    a, b, left, right = skeleton.edges.T
    assert (a < b).all() and (np.maximum(left, right) >= 0).all()
    chosen = skeleton.choice == 1
    assert set(skeleton.choice) == {0, 1}
    length = np.linalg.norm(skeleton.points[a] - skeleton.points[b], axis=1)
    middle = (skeleton.points[a] + skeleton.points[b]) / 2
    inside = ((middle >= centers().min(0)) & (middle <= centers().max(0))).all(1)
    assert length[inside].mean() == pytest.approx(WAVELENGTH, rel=0.05)
    pieces = segments(skeleton.top)
    assert len(pieces) == chosen.sum()
    drawn = np.linalg.norm(pieces[:, 2:] - pieces[:, :2], axis=1).sum()
    assert drawn == pytest.approx(length[chosen].sum(), rel=1e-12)
    ids = [line.id for line in skeleton.top]
    assert len(set(ids)) == len(ids)
    assert [line.id for line in fold(field).skeleton.top] == ids


def test_statistics_count_what_is_there(field):
    skeleton = fold(field).skeleton
    measures = orogen.folding.fold_statistics(field, skeleton, WAVELENGTH)
    a, b = skeleton.edges[skeleton.choice > 0, :2].T
    degree = np.bincount(np.concatenate([a, b]), minlength=len(skeleton.points))
    low = np.array(GRID.origin)
    high = low + GRID.cell_size * np.array([GRID.nx, GRID.ny])
    inside = ((skeleton.points >= low) & (skeleton.points <= high)).all(1)
    assert measures.nodes == (inside & (degree > 0)).sum() > 50
    assert measures.ends == (inside & (degree == 1)).sum()
    assert measures.joints == (inside & (degree > 2)).sum()
    middle = (skeleton.points[a] + skeleton.points[b]) / 2
    way = (skeleton.points[a] - skeleton.points[b])[((middle >= low) & (middle <= high)).all(1)]
    angle = np.degrees(np.arctan2(np.abs(way[:, 0]), np.abs(way[:, 1])))
    shares = np.histogram(angle, 18, (0, 90))[0] / len(angle)
    assert measures.angle == pytest.approx(shares, abs=1e-12)
    assert sum(measures.wavelength) == pytest.approx(1)
    mean = np.dot(measures.wavelength, (np.arange(30) + 0.5) / 10)
    assert measures.mean_wavelength == pytest.approx(mean, abs=0.05)
    whole = np.linalg.norm(way, axis=1).sum() / WAVELENGTH
    ends = degree[inside & (degree != 2)].sum()
    assert measures.mean_length == pytest.approx(2 * whole / ends, rel=1e-9)
    same = orogen.folding.fold_statistics(field, skeleton, np.full(GRID.shape, WAVELENGTH))
    assert same.mean_wavelength == pytest.approx(measures.mean_wavelength, rel=1e-6)


def test_edits(field):
    line = {"from": [6000, 10000], "to": [26000, 10000]}
    drawn = fold(field, [{"edit": "add", **line}])
    assert (drawn.skeleton.choice == 2).sum() >= 5 and drawn.edits_without_effect == []
    by_hand = drawn.skeleton.edges[drawn.skeleton.choice == 2, :2]
    y = drawn.skeleton.points[by_hand][..., 1]
    assert np.abs(y - 10000).max() < WAVELENGTH
    edits = [{"edit": "add", **line}, {"edit": "set", **line, "value": 700}]
    high = fold(field, edits, folding_time=1e6)
    on_line = np.abs(centers()[:, 1].reshape(GRID.shape) - 10000) < WAVELENGTH / 2
    assert (high.speed * 1e6)[on_line].max() == pytest.approx(700, rel=0.03)
    nothing = fold(field, [{"edit": "remove", "from": [-9e5, 0], "to": [-9e5, 5000]}])
    assert nothing.edits_without_effect == [0]
    assert (nothing.speed == fold(field).speed).all()


def test_layers_of_many_kinds(field):
    layers = [
        {},
        {"fold_wavelength": 2000},
        {"wavelength_map": np.full(GRID.shape, 4000.0), "speed_share": 0.1},
    ]
    made = orogen.folding.fold_layers(field, layers, shortest_wavelength=3000)
    assert [bool(layer.speed.any()) for layer in made] == [True, False, True]
    assert made[1].skeleton.top == [] and len(made[1].skeleton.points) == 0
    length = [np.linalg.norm(np.diff(line.points, axis=0), axis=1) for line in made[2].skeleton.top]
    assert np.concatenate(length).mean() == pytest.approx(4000, rel=0.1)
    assert not made[0].speed.flags.writeable
    assert orogen.folding.fold_layers(field, []) == []


@pytest.mark.parametrize(
    "layer, says",
    [
        (5, "layers[0]: a dictionary"),
        ({"fold_wavelength": 1}, "layers[0].fold_wavelength: 1"),
        ({"wave": 1}, "layers[0].wave"),
        ({"speed_share": "much"}, "layers[0].speed_share"),
        ({"wavelength_map": np.ones((2, 2))}, "layers[0].wavelength_map: shape (2, 2)"),
        ({"edits": [{"edit": "bend", "from": [0, 0], "to": [1, 1]}]}, "layers[0].edits[0].edit"),
        ({"edits": [{"edit": "add", "from": [0, 0]}]}, "layers[0].edits[0]: member 'to'"),
        ({"edits": [{"edit": "add", "layer": 1}]}, "layers[0].edits[0]: there is no"),
        (
            {"edits": [{"edit": "set", "from": [0, 0], "to": [1, 1], "value": -3}]},
            "layers[0].edits[0].value: -3",
        ),
    ],
)
def test_bad_layers(field, layer, says):
    with pytest.raises(orogen.InputError) as caught:
        orogen.folding.fold_layers(field, [layer])
    assert str(caught.value).startswith(says)


def test_bad_wavelength(field):
    with pytest.raises(orogen.InputError, match="wavelength"):
        orogen.folding.fold_statistics(field, fold(field).skeleton, -1.0)


def test_recipes_hold_edits(collision):
    plain = orogen.generate(collision)
    edit = {"edit": "set", "layer": 2, "from": [20e3, 54e3], "to": [80e3, 54e3], "value": 3000}
    collision["fold_edits"] = [edit | {"edit": "add", "value": 1}, edit]
    edited = orogen.Recipe.from_dict(collision)
    assert edited.to_dict()["fold_edits"] == collision["fold_edits"]
    assert orogen.Recipe.from_dict(edited.to_dict()).hash == edited.hash != plain.recipe.hash
    terrain = orogen.generate(edited)
    rate = terrain["fold_uplift_rate"]
    assert terrain.warnings == []
    assert rate.max() > plain["fold_uplift_rate"].max()
    for member, number, says in [("layer", 9, "1 to 4"), ("phase", 2, "1 to 1")]:
        wrong = collision | {"fold_edits": [edit, edit | {member: number}]}
        with pytest.raises(orogen.InputError, match=rf"fold_edits\[1\].{member}: {number}.*{says}"):
            orogen.Recipe.from_dict(wrong)
    collision["fold_edits"][0]["layer"] = 0
    with pytest.raises(orogen.InputError, match=r"fold_edits\[0\].layer: 0"):
        orogen.generate(collision)


def test_edits_without_effect_are_warnings(collision):
    collision["column"] = {"preset": "jura"}
    line = {"from": [20e3, 54e3], "to": [80e3, 54e3]}
    speck = {"from": [50e3, 54e3], "to": [50e3, 54.001e3]}
    collision["fold_edits"] = [
        {"edit": "remove", "layer": 1, **line},  # salt
        {"edit": "add", "layer": 2, **line},
        {"edit": "scale", "layer": 3, "value": 2, "from": [1e3, 1e3], "to": [1e3, 2e3]},
        {"edit": "add", "layer": 2, **speck},
    ]
    terrain = orogen.generate(collision)
    assert terrain.warnings == [
        "fold_edits[0]: changes nothing; layer 1 (Keuper evaporites) does not fold",
        "fold_edits[2]: changes nothing; layer 3 (Malm) has no crest along the line",
        "fold_edits[3]: changes nothing; layer 2 (Lias and Dogger) has folds too wide for so "
        "short a line",
    ]
    assert terrain.report["warnings"] == terrain.warnings
    assert orogen.generate(collision).warnings == terrain.warnings  # from the cache, too


def test_edits_of_a_recipe_outlive_other_parameters(collision):
    """A fold of given height by hand stays through other seeds, uplift, wavelengths and motions."""
    line = {"layer": 2, "from": [30e3, 54e3], "to": [70e3, 54e3]}
    collision |= {"resolution": 256, "stages": [{"stage": "collision"}, {"stage": "fold_layers"}]}
    collision["fold_edits"] = [{"edit": "add", **line}, {"edit": "set", **line, "value": 2500}]
    changes = [
        lambda r: r.update(seed=99),
        lambda r: r["stages"][0].setdefault("parameters", {}).update(target_uplift_rate=8e-4),
        lambda r: r["column"].update(layers=thicker(r["column"]["layers"], 2)),
        lambda r: r["phases"][0]["plates"][0].update(arrows=[[500, 7e3]] * 4),
    ]
    collision["column"] = orogen.strata.preset_column("jura")
    collision["column"]["layers"][2]["fold_share"] = 0.0  # the edited layer alone folds
    collision["column"]["layers"][3]["fold_share"] = 0.0
    for change in [lambda r: None, *changes]:
        change(collision)
        terrain = orogen.generate(collision)
        assert terrain.warnings == []
        years = collision["phases"][0].get("years", 5e6)
        height = years * terrain["fold_uplift_rate"]
        rows, columns = (int(v / terrain.grid.cell_size) for v in (54e3, 50e3))
        near = int(2500 / terrain.grid.cell_size)
        middle = height[rows - near : rows + near, columns - 3 * near : columns + 3 * near]
        ridge = middle.max(axis=0)
        assert np.median(ridge) == pytest.approx(2500, rel=0.04)
        assert ridge.min() > 0.8 * 2500 and ridge.max() < 1.02 * 2500  # bends are rounded


def test_a_terrain_hands_out_its_folds(collision, tmp_path):
    collision |= {"resolution": 96, "stages": [{"stage": "collision"}, {"stage": "fold_layers"}]}
    collision["phases"] *= 2
    terrain = orogen.generate(collision)
    shares = [layer["fold_share"] for layer in orogen.strata.preset_column("alps")["layers"]]
    folding = [k + 1 for k, share in enumerate(shares) if share > 0]
    folds = terrain.folds
    assert [(f["phase"], f["layer"]) for f in folds] == [(p, k) for p in (1, 2) for k in folding]
    terrain.save(tmp_path, formats=["folds"], pictures=False)
    document = json.loads((tmp_path / "folds.geojson").read_text())
    skeletons = [fold["skeleton"] for fold in folds]
    years = sum(phase.get("years", 5e6) for phase in collision["phases"])
    total = sum(fold["speed"] * fold["years"] for fold in folds)
    assert total == pytest.approx(years * terrain["fold_uplift_rate"], rel=1e-4, abs=0.01)
    del terrain, folds
    gc.collect()
    lines = [line for s in skeletons for line in [*s.top, *s.bottom]]
    assert len(lines) == len(document["features"]) > 100
    for line, feature in zip(lines, document["features"], strict=True):
        points = np.array(feature["geometry"]["coordinates"])
        assert points[: len(line.points)] == pytest.approx(line.points, abs=0.006)
        assert int(feature["properties"]["id"], 16) == line.id
    assert {f["properties"]["kind"] for f in document["features"]} == {"crest", "trough"}


def test_crests_as_a_network(collision):
    """As the worker hands them to be edited: the edges on the map, as high as their layer folds."""
    from orogen.worker_lines import fold_edges

    collision |= {"resolution": 96, "stages": [{"stage": "collision"}, {"stage": "fold_layers"}]}
    terrain = orogen.generate(collision)
    networks = fold_edges(terrain, {})
    assert list(networks) == [f"layer {f['layer']}, phase {f['phase']}" for f in terrain.folds]
    grid = terrain.grid
    for fold, network in zip(terrain.folds, networks.values(), strict=True):
        points, edges = network["points"], network["edges"]
        skeleton = fold["skeleton"]
        middles = skeleton.points[skeleton.edges[skeleton.choice > 0, :2]].mean(axis=1)
        local = (middles - grid.origin) / grid.cell_size
        inside = ((local >= 0) & (local <= [grid.nx, grid.ny])).all(axis=1)
        assert len(edges) == inside.sum() > 10
        found = points[edges].mean(axis=1)[:, :2] + grid.origin
        assert found == pytest.approx(middles[inside], abs=0.1)
        height = fold["speed"] * fold["years"]
        assert 0.5 * height.max() < points[:, 2].max() <= height.max()
        c, r = ((points[:, :2] / grid.cell_size).astype(int)).T
        on = (c > 1) & (r > 1) & (c < grid.nx - 2) & (r < grid.ny - 2)
        around = [height[r[on] + i, c[on] + j] for i in (-1, 0, 1) for j in (-1, 0, 1)]
        assert (points[on, 2] <= np.max(around, axis=0) + 0.01).all()
    with pytest.raises(orogen.InputError, match="no layers fold"):
        fold_edges(orogen.generate("corsica", resolution=32), {})


def test_folds_need_layers_that_fold(recipe, tmp_path):
    terrain = orogen.generate(recipe)
    assert terrain.folds == []
    with pytest.raises(orogen.InputError, match="folds: the recipe lacks"):
        terrain.save(tmp_path / "out", formats=["folds"])
    assert not (tmp_path / "out").exists()


def thicker(layers, number):
    return [
        layer | {"thickness": 1.5 * layer["thickness"]} if k + 1 == number else layer
        for k, layer in enumerate(layers)
    ]


def crests_between(terrain, columns):
    """Mean distance (m) from crest to crest along the columns of a map."""
    rate = terrain["fold_uplift_rate"][:, columns]
    inner = rate[1:-1]
    crest = (inner > rate[:-2]) & (inner >= rate[2:]) & (inner > 0.3 * rate.max())
    gaps = [np.diff(np.flatnonzero(column)) for column in crest.T]
    return np.concatenate(gaps).mean() * terrain.grid.cell_size


def test_folds_are_wider_where_the_folded_layer_is_thicker(collision):
    collision |= {"resolution": 512, "stages": [{"stage": "collision"}, {"stage": "fold_layers"}]}
    column = orogen.strata.preset_column("jura")
    for k, layer in enumerate(column["layers"]):
        layer["fold_share"] = 0.5 if k == 1 else 0.0
    thin = column["layers"][1]["thickness"]
    column["layers"][1]["thickness_map"] = [[thin, thin, 4 * thin, 4 * thin]] * 2
    collision["column"] = column
    terrain = orogen.generate(collision)
    nx = terrain.grid.nx
    west = crests_between(terrain, slice(nx // 12, nx // 4))
    east = crests_between(terrain, slice(3 * nx // 4, 11 * nx // 12))
    assert east / west == pytest.approx(2.0, rel=0.2)  # the root of the thickness
