"""What is given as fields: heights to start from, painted factors, ground that stays."""

import numpy as np
import orogen
import pytest


def grow(document, **more):
    return orogen.generate(orogen.Recipe.from_dict(document), **more)


def heights(n=96):
    """A dome by the sea, in metres, rows from the south."""
    y, x = np.mgrid[0:n, 0:n] / (n - 1)
    return (1800 * np.exp(-((x - 0.6) ** 2 + (y - 0.5) ** 2) / 0.06) - 80).astype(np.float32)


def start_from(values, **rasters):
    packed = {name: orogen.pack_raster(raster) for name, raster in rasters.items()}
    return {
        "orogen": 1,
        "resolution": 96,
        "extent": {"origin": [0, 0], "size": [30e3, 30e3]},
        "rasters": {"elevation": orogen.pack_raster(values), **packed},
    }


def test_given_heights_are_the_ground_to_the_bit():
    stages = [{"stage": "given_elevation", "parameters": {"roughness": 0}}]
    document = {**start_from(heights()), "stages": stages}
    assert (grow(document)["elevation"] == heights()).all()


def test_rivers_cut_valleys_into_given_heights():
    terrain = grow(start_from(heights()))
    z, before = terrain["elevation"], heights()
    land = terrain["land"] == 1
    assert (z[land] <= before[land] + 240).all() and (z[~land] == before[~land]).all()
    around = np.hypot(*(np.mgrid[0:96, 0:96] - np.array([48, 57]).reshape(2, 1, 1)))
    ring = land & (around > 14) & (around < 18)
    assert np.std(before[ring]) < 150 and np.std(z[ring]) > 1.3 * np.std(before[ring])


def test_sea_level_and_vertical_scale():
    parameters = {"sea_level": 500, "vertical_scale": 2, "roughness": 0}
    stages = [{"stage": "given_elevation", "parameters": parameters}]
    terrain = grow({**start_from(heights()), "stages": stages})
    assert terrain["elevation"] == pytest.approx(2 * (heights() - 500), abs=1e-3)
    assert (terrain["land"] == (heights() > 500)).all()


def towards(document, **parameters):
    stages = [{"stage": "given_elevation"}, {"stage": "even_rates"}]
    fit = {"fit_radius": 2000, **parameters}
    return {**document, "stages": [*stages, {"stage": "fitted_growth", "parameters": fit}]}


def blurred(values, cells=8):
    """The mean over a square around each cell, away from the sides."""
    sums = np.cumsum(np.cumsum(np.pad(values.astype(float), ((1, 0), (1, 0))), 0), 1)
    n = 2 * cells + 1
    return (sums[n:, n:] - sums[:-n, n:] - sums[n:, :-n] + sums[:-n, :-n]) / n**2


def test_mountains_grow_towards_given_heights():
    terrain = grow(towards(start_from(heights())))
    aim, grown = blurred(heights()), blurred(terrain["elevation"])
    assert np.corrcoef(aim.ravel(), grown.ravel())[0, 1] > 0.99
    assert abs(grown - aim).mean() < 0.05 * aim.max()
    sea = terrain["land"] == 0
    assert (terrain["elevation"][sea] == heights()[sea]).all()
    assert terrain["uplift_rate"][48, 57] > 3 * terrain["uplift_rate"][10, 20] > 0
    plain = grow(towards(start_from(heights()), coarse_steps=1, middle_steps=1, finest_steps=1))
    assert abs(blurred(plain["elevation"]) - aim).mean() > 2 * abs(grown - aim).mean()


def test_painted_uplift_raises_the_aim():
    factor = np.ones((32, 32), np.float32)
    factor[:, 16:] = 1.4
    plain = grow(towards(start_from(heights())))
    raised = grow(towards(start_from(heights(), uplift_factor=factor)))
    east = np.s_[:, 64:]
    assert raised["elevation"][east].mean() > 1.15 * plain["elevation"][east].mean()


def kept(terrain, seed):
    """The terrain's recipe with another seed, its south-western quarter kept."""
    mask = np.zeros(terrain.grid.shape, np.float32)
    mask[: mask.shape[0] // 2, : mask.shape[1] // 2] = 1
    document = terrain.recipe.to_dict()
    rasters = {"kept": mask, "kept_elevation": terrain["elevation"]}
    return mask > 0, {
        **document,
        "seed": seed,
        "rasters": {name: orogen.pack_raster(values) for name, values in rasters.items()},
        "stages": [
            *document["stages"],
            {"stage": "keep_region", "parameters": {"margin": 5000}},
        ],
    }


def test_a_frozen_region_stays_while_the_rest_grows_anew(recipe, collision):
    for source in (recipe, orogen.Recipe.from_dict(collision)):
        terrain = orogen.generate(source)
        inside, document = kept(terrain, seed=11)
        again = grow(document)["elevation"]
        assert (again[inside] == terrain["elevation"][inside]).all()
        far = np.zeros_like(inside)
        far[-len(far) // 4 :] = True
        fresh = grow({**document, "stages": document["stages"][:-1]})["elevation"]
        assert (again[far] == fresh[far]).all()
        assert (again[far] != terrain["elevation"][far]).mean() > 0.2


def test_the_same_bytes_for_any_number_of_threads(collision):
    paint = np.linspace(0.5, 2, 12).reshape(3, 4)
    document = {
        **collision,
        "rasters": {
            "uplift_factor": orogen.pack_raster(paint),
            "erodibility_factor": orogen.pack_raster(1 / paint),
        },
    }
    one, two = (grow(document, threads=n) for n in (1, 2))
    assert all((one[name] == two[name]).all() for name in one)


def test_the_schema_declares_rasters():
    declared = {item["name"]: item for item in orogen.schema()["rasters"]}
    assert declared["uplift_factor"]["otherwise"] == 1 and declared["kept"]["otherwise"] is None
    for name, item in declared.items():
        beyond = orogen.pack_raster([[2 * item["max"] + 1]])
        document = {**start_from(heights()), "rasters": {name: beyond}}
        with pytest.raises(orogen.InputError, match=f"rasters.{name}: row 0, column 0"):
            orogen.Recipe.from_dict(document)


def test_only_two_dimensions_make_a_raster():
    with pytest.raises(orogen.InputError, match="rows and columns"):
        orogen.pack_raster([1, 2, 3])
