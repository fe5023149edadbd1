"""A map's plates fold strata, and the map stays law."""

import json

import numpy as np
import orogen
import pytest


@pytest.fixture(scope="module")
def pair():
    return [orogen.generate(n, resolution=512) for n in ("corsica", "corsica_folded_strata")]


def test_the_map_is_still_law(pair):
    plain, folded = pair
    assert (plain["land"] == folded["land"]).all()
    river = plain["river"] > 0
    assert (river == (folded["river"] > 0)).all()
    map_ = orogen.inputs.VectorMap.read(json.dumps(folded.recipe.to_dict()["map"]))
    for peak in map_.peaks:
        if peak["height_m"] is None:
            continue
        grid = folded.grid
        column = int((peak["position"][0] - grid.origin[0]) / grid.cell_size)
        row = int((peak["position"][1] - grid.origin[1]) / grid.cell_size)
        near = folded["elevation"][max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2]
        assert near.max() == pytest.approx(peak["height_m"], rel=0.02)


def test_ridges_follow_the_folds(pair):
    """Ground high above its surroundings lies where folds rise, more than without them."""

    def residual(field, cells):
        kernel = np.ones(2 * cells + 1) / (2 * cells + 1)
        blur = np.apply_along_axis(lambda v: np.convolve(v, kernel, "same"), 0, field)
        blur = np.apply_along_axis(lambda v: np.convolve(v, kernel, "same"), 1, blur)
        return field - blur

    plain, folded = pair
    folds = residual(folded["fold_uplift_rate"].astype(float), 12)
    land = (plain["land"] > 0) & (np.abs(folds) > 1e-9)
    likeness = [
        np.corrcoef(folds[land], residual(t["elevation"].astype(float), 12)[land])[0, 1]
        for t in pair
    ]
    assert likeness[1] > likeness[0] + 0.1
    assert likeness[1] > 0.2


def test_strata_crop_out_old_in_ranges_and_young_in_plains(pair):
    folded = pair[1]
    land = folded["land"] > 0
    z, layer = folded["elevation"][land], folded["rock_layer"][land]
    assert len(np.unique(layer)) >= 4
    assert layer[z > 1500].mean() < layer[z < 200].mean() - 0.5
    assert folded.rocks.section([(0, 0), (10e3, 10e3)], base=-5000).bands
