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


SQUARES = [
    {
        "name": "south",
        "points": [[10e3, 8e3], [90e3, 8e3], [90e3, 28e3], [10e3, 28e3]],
        "arrows": [[0, 9000]] * 4,
    },
    {
        "name": "north",
        "points": [[10e3, 78e3], [90e3, 78e3], [90e3, 92e3], [10e3, 92e3]],
        "arrows": [[0, 0]] * 4,
    },
]


@pytest.fixture
def squares():
    """Two plates, 100 km apart at most, that collide head on; as recipes have them."""
    return json.loads(json.dumps(SQUARES))


@pytest.fixture
def collision(squares):
    """The recipe of a small mountain range between them, as a dictionary."""
    return {
        "orogen": 1,
        "name": "range",
        "resolution": 48,
        "extent": {"origin": [0, 0], "size": [100e3, 100e3]},
        "phases": [{"years": 5e6, "plates": squares}],
        "column": {"preset": "alps"},
    }
