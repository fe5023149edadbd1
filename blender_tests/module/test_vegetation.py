"""orogen.vegetation: trees and ground cover as meshes."""

import gc

import numpy as np
import orogen
import pytest
from orogen import vegetation


def sound(mesh):
    faces = len(mesh.materials)
    assert mesh.positions.dtype == mesh.uvs.dtype == np.float32
    assert mesh.positions.shape[1] == 3 and mesh.uvs.shape == (len(mesh.corners), 2)
    assert len(mesh.levels) == faces and len(mesh.face_starts) == faces + 1
    assert (np.diff(mesh.face_starts) >= 3).all() and mesh.face_starts[-1] == len(mesh.corners)
    assert mesh.corners.min() == 0 and mesh.corners.max() == len(mesh.positions) - 1
    assert np.isfinite(mesh.positions).all()


@pytest.mark.parametrize("name", [species["name"] for species in vegetation.tree_species()])
def test_each_species_stands_as_high_as_it_says(name):
    species = next(s for s in vegetation.tree_species() if s["name"] == name)
    mesh = vegetation.make_tree(name, seed=3, quality=0.2)
    sound(mesh)
    measures = vegetation.tree_statistics(name, seed=3)
    p = species["parameters"]
    assert measures["height"] < 1.4 * (p["scale"] + p["scale_variation"])
    assert measures["height"] > 0.5 * (p["scale"] - p["scale_variation"])
    leaves = np.count_nonzero(mesh.materials == 1)
    assert leaves == pytest.approx(0.2 * measures["leaves"], rel=0.1)
    assert set(np.unique(mesh.levels)) == set(range(p["levels"] + (p["leaves"] > 0)))
    for color in ("bark_color", "leaf_color", "other_leaf_color"):
        assert 0 <= species[color] <= 0xFFFFFF


def test_published_numbers():
    aspen = vegetation.tree_statistics("quaking_aspen", seed=11)
    assert [level["stems"] for level in aspen["levels"]] == [1, 50, 1200, 0]
    assert 10 <= aspen["levels"][0]["mean"] <= 16
    longest = 0.3 * aspen["levels"][0]["mean"]
    assert 0.9 * longest < aspen["levels"][1]["longest"] <= longest


def test_parameters_of_ones_own():
    oak = next(s for s in vegetation.tree_species() if s["name"] == "black_oak")["parameters"]
    same = vegetation.make_tree(oak, seed=2, quality=0.1)
    named = vegetation.make_tree("black_oak", seed=2, quality=0.1)
    assert (same.positions == named.positions).all() and (same.corners == named.corners).all()
    bare = vegetation.make_tree({**oak, "leaves": 0}, seed=2)
    assert (bare.materials == 0).all()
    schema = vegetation.plant_parameters()
    assert {p["name"] for p in schema["tree"]} == set(oak) - {"stems"}
    assert [p["name"] for p in schema["stem"]] == list(oak["stems"][0])
    cover = vegetation.ground_cover()[0]["parameters"]
    assert [p["name"] for p in schema["ground_cover"]] == list(cover)


@pytest.mark.parametrize("name", [species["name"] for species in vegetation.ground_cover()])
def test_ground_cover(name):
    tuft = vegetation.make_ground_cover(name, seed=1)
    sound(tuft)
    assert (vegetation.make_ground_cover(name, 1).positions == tuft.positions).all()
    quads = vegetation.make_ground_cover(name, seed=1, crossed_quads=True)
    sound(quads)
    assert len(quads.materials) == 2 and quads.positions[:, 2].min() == 0


def test_arrays_are_views_that_keep_their_owner():
    mesh = vegetation.make_tree("dwarf_juniper")
    view = mesh.positions
    assert np.shares_memory(view, mesh.positions) and not view.flags.writeable
    copy = view.copy()
    del mesh
    gc.collect()
    vegetation.make_tree("dwarf_juniper", seed=1)
    assert (view == copy).all()


@pytest.mark.parametrize(
    "species, keywords, says",
    [
        ("oak", {}, "species: 'oak' is not known; one of quaking_aspen"),
        (7, {}, "species: a name or a dictionary"),
        ({"scale": -1}, {}, "species.scale: -1"),
        ({"girth": 1}, {}, "species.girth: no such parameter"),
        ({"stems": [{}, {"taper": 9}]}, {}, r"species.stems\[1\].taper: 9"),
        ({"stems": [{}] * 5}, {}, "species.stems: up to 4"),
        ({"stems": [3]}, {}, r"species.stems\[0\]: a dictionary"),
        ({"scale": 3, "scale_variation": 3}, {}, "scale_variation: 3"),
        ("black_oak", {"quality": 0}, "quality: 0"),
    ],
)
def test_refusals(species, keywords, says):
    with pytest.raises(orogen.InputError, match=says):
        vegetation.make_tree(species, **keywords)
    with pytest.raises(orogen.InputError, match="is not known; one of meadow_grass"):
        vegetation.make_ground_cover("lawn")
