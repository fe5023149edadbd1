"""Climate, biomes and plants in Python: orogen.climate, orogen.vegetation and terrains."""

import numpy as np
import orogen
import pytest

NAMES = [biome["name"] for biome in orogen.island.biomes()]
STAGES = ("lakes", "climate", "biomes", "vegetation")


def recipe(**more):
    heights = np.full((40, 40), 300.0)
    heights[:, :8] = -50.0
    heights[:, 30:] = 2900.0
    return {
        "orogen": 1,
        "resolution": 40,
        "extent": {"origin": [0, 0], "size": [8000, 8000]},
        "rasters": {"elevation": orogen.pack_raster(heights), **more.pop("rasters", {})},
        "stages": [
            {"stage": "given_elevation", "parameters": {"roughness": 0}},
            *({"stage": name} for name in STAGES),
        ],
        **more,
    }


def test_wind_brings_rain_to_one_side():
    x = np.linspace(-60, 60, 120)
    ridge = np.tile(2000 * np.exp(-((x / 15) ** 2)), (60, 1))
    rain = orogen.climate.orographic_rain(ridge, 1000.0, wind_from_deg=270.0)
    assert rain.shape == ridge.shape
    assert rain[30, 50] > 1.5 * rain[30, 85]
    with pytest.raises(orogen.InputError, match="wind_speed"):
        orogen.climate.orographic_rain(ridge, 1000.0, wind_speed=-1.0)


def test_classifications_know_their_biomes():
    def of(by, warmth, water):
        made = orogen.climate.classify_biomes(np.array([[warmth]]), np.array([[water]]), by)
        return NAMES[made[0, 0]]

    assert of("paper", 0.5, 0.6) == "deciduous_forest"
    assert of("whittaker", 26.0, 3.0) == "tropical_rain_forest"
    assert of("holdridge", 4.2, 0.35) == "taiga"
    with pytest.raises(orogen.InputError, match="classification"):
        of("koppen", 0.0, 0.0)


def test_a_terrain_has_its_climate_and_biomes():
    terrain = orogen.generate(recipe())
    names = np.array(NAMES)[terrain["biome"]]
    assert (names[:, :7] == "ocean").all() and (names[5:35, 32:] == "snow").all()
    assert np.allclose(terrain["air_temperature"][:, 15], 15 - 6.5 * 0.3, atol=0.01)
    assert set(terrain.fields) >= {"rainfall", "snow_cover", "biotemperature", "tree_density"}


def test_painted_biomes_stay():
    paint = np.full((10, 10), -1.0)
    paint[3:6, 3:6] = NAMES.index("scorched")
    document = recipe(rasters={"biome": orogen.pack_raster(paint)})
    kept = orogen.Recipe.from_dict(document).to_dict()
    assert kept["rasters"]["biome"] == document["rasters"]["biome"]
    for resolution in (40, 60):
        terrain = orogen.generate(orogen.Recipe.from_dict(kept), resolution=resolution)
        scorched = terrain["biome"] == NAMES.index("scorched")
        inside = np.zeros(scorched.shape, bool)
        third = resolution // 10
        inside[3 * third : 6 * third, 3 * third : 6 * third] = True
        assert (scorched == inside).all()
    document["rasters"]["biome"] = orogen.pack_raster(np.full((2, 2), 14.0))
    with pytest.raises(orogen.InputError, match=r"rasters\.biome"):
        orogen.Recipe.from_dict(document)


def test_plants_stand_where_they_may():
    terrain = orogen.generate(recipe())
    trees = terrain.plants()
    assert len(trees) == len(trees.positions) == len(trees.kinds) > 1000
    assert trees.positions.dtype == np.float32 and not trees.positions.flags.writeable
    assert trees.density_share == 1.0
    x, y, z = trees.positions.T
    assert x.min() >= 0 and x.max() <= 8000 and y.min() >= 0 and y.max() <= 8000
    column = (x / 200).astype(int)
    assert (column >= 8).all() and (column < 32).all()
    flat = (column > 9) & (column < 28)
    assert np.allclose(z[flat], 300.0, atol=0.1)
    per_hectare = terrain["tree_density"].sum() * 4.0
    assert abs(len(trees) / per_hectare - 1.0) < 0.05
    kinds = terrain.plant_tables["trees"]["kinds"]
    assert trees.kinds.max() < len(kinds)
    part = terrain.plants("ground_cover", region=((4000, 4000), (4060, 4060)))
    assert len(part) > 100 and (part.positions[:, :2] >= 4000).all()
    few = terrain.plants(most_plants=500)
    assert few.density_share < 1 and 350 < len(few) < 650


def test_tables_are_changed_by_recipes_and_arguments():
    oaks = {"density": {name: 0.0 for name in NAMES}, "kinds": []}
    oaks["density"]["deciduous_forest"] = oaks["density"]["grassland"] = 30.0
    oaks["kinds"].append(
        {"name": "oak", "spacing": 9.0, "biomes": {"deciduous_forest": 1, "grassland": 1}}
    )
    biome = np.full((20, 20), NAMES.index("grassland"), np.int32)
    cloud = orogen.vegetation.place_plants(np.zeros((20, 20)), biome, 25.0, oaks, seed=3)
    assert abs(len(cloud) - 750) < 110 and (cloud.kinds == 0).all()
    apart = np.linalg.norm(cloud.positions[:, None, :2] - cloud.positions[None, :, :2], axis=2)
    assert apart[~np.eye(len(cloud), dtype=bool)].min() >= 9.0 - 1e-3
    plants = {"trees": {"density": {"deciduous_forest": 7.0}}}
    terrain = orogen.generate(recipe(plants=plants))
    assert terrain.plant_tables["trees"]["density"]["deciduous_forest"] == 7.0
    assert orogen.vegetation.tree_table()["density"]["deciduous_forest"] == 400.0


def test_plants_that_are_not_settled_are_refused():
    document = recipe()
    document["stages"].pop()
    terrain = orogen.generate(document)
    assert terrain.plant_tables is None
    with pytest.raises(orogen.InputError, match="vegetation"):
        terrain.plants()
    with pytest.raises(orogen.InputError, match="region"):
        orogen.generate(recipe()).plants(region=((0, 0),))
    with pytest.raises(orogen.InputError, match="layer"):
        orogen.generate(recipe()).plants("mushrooms")
