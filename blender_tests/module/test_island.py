"""orogen.island: polygon maps, islands and their height maps."""

import numpy as np
import orogen
import pytest

GRID = orogen.Grid(96, 96, 500.0)


def test_a_polygon_map_is_a_graph():
    made = orogen.island.make_island(GRID, seed=3, cells=800)
    graph = made.map
    assert graph.centers.shape == (800, 2) and graph.edge_centers.shape[1] == 2
    assert len(graph.corners) - len(graph.edge_centers) + len(graph.centers) == 1
    first, items = graph.center_corners
    ring = graph.corners[items[first[5] : first[6]]]
    x, y = ring.T
    area = 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)
    assert area > 0
    assert not graph.centers.flags.writeable
    with pytest.raises(ValueError):
        graph.centers[0] = 0.0


def test_an_island_has_water_rivers_and_biomes():
    made = orogen.island.make_island(GRID, seed=3, cells=800)
    names = [biome["name"] for biome in orogen.island.biomes()]
    ocean, lake = names.index("ocean"), names.index("lake")
    assert ((made.biomes == ocean) == (made.center_ocean == 1)).all()
    assert ((made.biomes == lake) == ((made.center_water == 1) & (made.center_ocean == 0))).all()
    assert made.center_elevation.max() <= 1 and made.corner_elevation.min() == -1
    mouths = made.corner_river[(made.corner_river > 0) & (made.downstream < 0)]
    assert len(mouths) and (made.edge_river.max() <= mouths.max())


def test_relief_is_that_of_the_recipe():
    made = orogen.island.make_island(GRID, seed=3, cells=800)
    relief = orogen.island.island_relief(made, GRID, seed=1, peak_height=900.0)
    assert relief.elevation.shape == (96, 96) and 800 < relief.elevation.max() <= 900
    assert set(np.unique(relief.biome)) <= set(range(16))
    assert ((relief.elevation + relief.water_depth > 0) == (relief.land == 1)).all()


def test_bad_input_is_refused():
    with pytest.raises(orogen.InputError, match="cells"):
        orogen.island.make_island(GRID, cells=3)
    with pytest.raises(orogen.InputError, match="no land"):
        orogen.island.make_island(GRID, offset=4.0)


def test_a_recipes_island_is_at_hand():
    recipe = {
        "orogen": 1,
        "resolution": 48,
        "extent": {"origin": [0.0, 0.0], "size": [9e3, 9e3]},
        "stages": [{"stage": "island", "parameters": {"cells": 300}}],
    }
    terrain = orogen.generate(recipe)
    assert len(terrain.island.biomes) == 300
    assert terrain.island.map.corners.max() <= 9e3
    assert orogen.generate("folded_range", resolution=16).island is None
    assert [b["name"] for b in orogen.schema()["biomes"]][-1] == "ocean"


def test_the_schema_says_what_springs_are_made_of():
    (discharge,) = orogen.schema()["river_source"]
    assert discharge["name"] == "discharge" and discharge["unit"] == "m3/s"

    def read(value):
        source = {"name": "Spring", "position": [1e3, 2e3], "discharge": value}
        extent = {"origin": [0.0, 0.0], "size": [9e3, 9e3]}
        return orogen.Recipe.from_dict({"orogen": 1, "extent": extent, "river_sources": [source]})

    for value in (discharge["min"], discharge["max"], 7):
        (source,) = read(value).to_dict()["river_sources"]
        assert source == {"name": "Spring", "position": [1e3, 2e3], "discharge": value}
    for value in (discharge["min"] - 1, 1.001 * discharge["max"], "7", True, None):
        with pytest.raises(orogen.InputError, match=r"^river_sources\[0\].discharge: "):
            read(value)
