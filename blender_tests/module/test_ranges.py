"""Ranges between two plates: what paper C's figures show of them, measured."""

import numpy as np
import orogen
import pytest

FAR = 60e3
WIDE, DEEP = 60e3, 60e3


def box(south, north):
    return [[-FAR, south], [WIDE + FAR, south], [WIDE + FAR, north], [-FAR, north]]


def recipe(column="alps", **parameters):
    """A range along the middle of a square of 60 km; the southern plate comes north."""
    plates = [
        {"points": box(-FAR, 4e3), "arrows": [[0, 8e3]] * 4},
        {"points": box(50e3, DEEP + FAR), "arrows": [[0, 0]] * 4, "stable": True},
    ]
    names = ("collision", "fold_layers", "mountain_growth", "rock_detail", "outcrop")
    growth = {"west_side": "closed", "east_side": "closed", "steps": 40}
    parameters["mountain_growth"] = {**growth, **parameters.get("mountain_growth", {})}
    return {
        "orogen": 1,
        "extent": {"origin": [0, 0], "size": [WIDE, DEEP]},
        "resolution": 240,
        "phases": [{"years": 4e6, "plates": plates}],
        "column": {"preset": column},
        "stages": [{"stage": n, "parameters": parameters.get(n, {})} for n in names],
    }


@pytest.fixture(scope="module")
def faulted():
    return orogen.generate(recipe())


def mean_slope(terrain, rows):
    z, cell = terrain["elevation"], terrain.grid.cell_size
    gy, gx = np.gradient(z, cell)
    return float(np.hypot(gx, gy)[rows].mean())


def test_compression_alone_lifts_the_middle_evenly():
    """Figure 15."""
    terrain = orogen.generate(recipe(collision={"fault": False, "crust_smoothing": 3000}))
    rate = terrain["crust_uplift_rate"].mean(axis=1)
    middle = rate[rate.size * 35 // 100 : rate.size * 65 // 100]
    assert middle.std() < 0.05 * middle.mean()
    assert rate[3] < 0.02 * middle.mean() and rate[-3] < 0.02 * middle.mean()


def test_the_side_of_the_fault_is_steeper(faulted):
    profile = faulted["elevation"].mean(axis=1)
    inside = np.flatnonzero(profile > 0.1 * profile.max())
    first, last, crest = inside[0], inside[-1], int(profile.argmax())
    width = min(crest - first, last - crest)
    assert width > 10
    rise_south = profile[crest] / (crest - first)
    rise_north = profile[crest] / (last - crest)
    assert rise_north > 1.3 * rise_south
    fault = faulted["fault"].mean(axis=1)
    assert abs(int(np.abs(fault).argmin()) - last) < 12  # the range ends at the fault


def test_ridges_run_along_the_folds(faulted):
    """Sub-ranges lie along fold lines: heights are alike along the suture, not across it."""
    z = faulted["elevation"]
    core = z[70:170]
    along = np.abs(core[:, 12:] - core[:, :-12]).mean()
    across = np.abs(core[12:] - core[:-12]).mean()
    assert across > 1.1 * along


def test_layers_come_to_light(faulted):
    assert set(np.unique(faulted["rock_layer"])) >= {2, 3}
    deepest = faulted["exhumation"].max()
    assert 500 < deepest < 6000


def test_hard_beds_stand_steeper_than_weak_ones():
    terrain = orogen.generate("digne", resolution=400)
    column = terrain.rocks.column
    gy, gx = np.gradient(terrain["elevation"], terrain.grid.cell_size)
    slope = np.hypot(gx, gy)
    slopes = {}
    for k, layer in enumerate([column["basement"], *column["layers"]]):
        for j, bed in enumerate(layer["sub_layers"]):
            here = (terrain["rock_layer"] == k) & (terrain["rock_sublayer"] == j)
            slopes.setdefault(bed["lithology"], []).append(slope[here])
    hard, weak = (np.concatenate(slopes[name]) for name in ("limestone", "marl"))
    assert min(hard.size, weak.size) > 5000
    assert hard.mean() > 1.06 * weak.mean()


def test_frames_end_where_the_terrain_does():
    document = recipe(mountain_growth={"frames": 4, "steps": 8})
    document["stages"] = [s for s in document["stages"] if s["stage"] != "rock_detail"]
    terrain = orogen.generate(document, resolution=80)
    years = [frame["years"] for frame in terrain.frames]
    assert np.allclose(years, [1e6, 2e6, 3e6, 4e6])
    assert (terrain.frames[-1]["elevation"] == terrain["elevation"]).all()
    assert (terrain.frames[-1]["strata_color"] == terrain["strata_color"]).mean() > 0.99
