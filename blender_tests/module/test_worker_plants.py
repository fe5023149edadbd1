"""What the worker makes when it is asked for plants."""

import numpy as np
import orogen
import pytest
from orogen.worker_plants import STAGES, make_plants, with_plants


def planted(name, **more):
    document = orogen.Recipe.load(name).to_dict()
    stages = orogen.schema()["stages"]
    return with_plants({**document, "resolution": 96, **more}, stages)


def names(document):
    return [stage["stage"] for stage in document["stages"]]


def test_a_map_gets_the_stages_that_plants_need():
    document = planted("corsica")
    assert names(document)[-4:] == list(STAGES)
    assert with_plants(document, orogen.schema()["stages"]) == document


def test_what_a_recipe_has_it_keeps():
    for name in ("island", "corsica_biomes", "forested_folds"):
        before = names(orogen.Recipe.load(name).to_dict())
        after = names(planted(name))
        assert after[: len(before)] == before and len(after) == len(set(after))


def test_plants_and_meshes_of_the_kinds_that_stand():
    terrain = orogen.generate(planted("corsica"))
    corner = 0.45 * np.array(terrain["elevation"].shape[::-1]) * terrain.grid.cell_size
    region = [corner.tolist(), (corner + 1500.0).tolist()]
    told = []
    request = {
        "layers": {"trees": {"region": region, "most_plants": 5000}},
        "variants": 2,
        "quality": 0.02,
    }
    arrays, plants = make_plants(terrain, request, lambda *at: told.append(at))
    cloud = terrain.plants("trees", region, 5000)
    assert len(cloud) > 1000 and np.array_equal(arrays["trees/positions"], cloud.positions)
    assert [plant["kind"] for plant in plants] == np.unique(cloud.kinds).tolist()
    kinds = terrain.plant_tables["trees"]["kinds"]
    for plant in plants:
        assert plant["name"] == kinds[plant["kind"]]["name"] and len(plant["variants"]) == 2
        first, second = (arrays[f"{variant}/positions"] for variant in plant["variants"])
        assert first.shape != second.shape or (first != second).any(), "variants differ"
    assert len(told) == len(plants)
    again = make_plants(terrain, {**request, "quality": 0.03}, lambda *_: None)[1]
    assert all(a["fingerprint"] != b["fingerprint"] for a, b in zip(plants, again, strict=True))


def test_a_job_may_end_between_two_species():
    terrain = orogen.generate(planted("corsica"))

    def stop(*_):
        raise orogen.Cancelled("cancelled")

    request = {"layers": {"trees": {"most_plants": 5000}}, "variants": 1, "quality": 0.02}
    with pytest.raises(orogen.Cancelled):
        make_plants(terrain, request, stop)
