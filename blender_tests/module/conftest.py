import json

import pytest

ISLAND = {
    "type": "FeatureCollection",
    "name": "island",
    "units": "km",
    "frame": {
        "proj4": "+proj=aeqd +lat_0=42 +lon_0=9 +datum=WGS84 +units=m +no_defs",
        "origin_m": [-20000, -15000],
        "size_km": [40, 30],
    },
    "features": [
        {
            "type": "Feature",
            "properties": {"kind": kind, **more},
            "geometry": {"type": shape, "coordinates": coordinates},
        }
        for kind, more, shape, coordinates in [
            (
                "coast",
                {},
                "Polygon",
                [[[5, 4], [33, 3], [36, 17], [28, 27], [9, 26], [3, 15], [5, 4]]],
            ),
            ("river", {"name": "A"}, "LineString", [[19, 16], [15, 12], [10, 9], [4.5, 8]]),
            ("peak", {"height_m": 1500, "name": "P"}, "Point", [21, 18]),
            ("peak", {"height_m": 1100}, "Point", [27, 15]),
            ("peak", {"height_m": 900}, "Point", [14, 19]),
            ("peak", {"height_m": 700}, "Point", [20, 9]),
        ]
    ],
}


@pytest.fixture
def island():
    """A small vector map, as a dictionary."""
    return json.loads(json.dumps(ISLAND))


@pytest.fixture
def recipe(island):
    import orogen

    return orogen.Recipe.from_dict({"orogen": 1, "name": "island", "resolution": 96, "map": island})


@pytest.fixture
def recipe_file(recipe, tmp_path):
    path = tmp_path / "island.orogen.json"
    recipe.save(path)
    return path
