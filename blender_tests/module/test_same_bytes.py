"""Whole recipes give the same bytes for any number of threads: every one that ships, and one from
given heights."""

import hashlib
from pathlib import Path

import numpy as np
import orogen
import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = "core/python/orogen/recipes", "python_addon/extension/recipes"


def from_heights():
    x, y = np.meshgrid(np.linspace(0, 9, 90), np.linspace(0, 6, 60))
    heights = 600 * np.sin(x) * np.cos(y) + 150 * x
    rasters = {"elevation": heights, "kept": x > 8, "kept_elevation": heights}
    names = ("given_elevation", "even_rates", "river_erosion", "fitted_growth", "keep_region")
    return {
        "orogen": 1,
        "extent": {"origin": [0, 0], "size": [45e3, 30e3]},
        "rasters": {name: orogen.pack_raster(values) for name, values in rasters.items()},
        "stages": [{"stage": name, "parameters": {}} for name in names],
    }


DOCUMENTS = {
    file.name.partition(".")[0]: orogen.Recipe.load(file).to_dict()
    for folder in FOLDERS
    for file in sorted((ROOT / folder).glob("*.orogen.json"))
}
DOCUMENTS["from_heights"] = from_heights()


def lightened(document):
    """All stages, with fewer steps of the one that takes longest; coarser, but of enough cells for
    several chunks of every loop."""
    steps = {"mountain_growth": {"steps": 20}}
    stages = [
        {**item, "parameters": {**item["parameters"], **steps.get(item["stage"], {})}}
        for item in document["stages"]
    ]
    return {**document, "resolution": 384, "stages": stages}


def digests(document, threads):
    """Of every field; of trees, and of the ground cover in the middle."""
    terrain = orogen.generate(document, threads=threads, cache=None)
    arrays = {name: terrain[name] for name in terrain}
    if terrain.plant_tables:
        middle = 0.5 * terrain.grid.cell_size * np.array(terrain.grid.shape[::-1])
        clouds = {
            "trees": terrain.plants("trees", most_plants=300_000, threads=threads),
            "ground_cover": terrain.plants("ground_cover", (middle, middle + 300), threads=threads),
        }
        for layer, cloud in clouds.items():
            assert len(cloud) > 1000
            for name in ("positions", "kinds", "scales", "rotations"):
                arrays[f"{layer}.{name}"] = getattr(cloud, name)
    return {name: hashlib.sha256(array.data).hexdigest() for name, array in arrays.items()}


@pytest.mark.parametrize("name", DOCUMENTS)
def test_threads_do_not_change_a_byte(name):
    document = lightened(DOCUMENTS[name])
    one = digests(document, threads=1)
    assert "elevation" in one
    for threads in (2, 4):
        assert digests(document, threads) == one
