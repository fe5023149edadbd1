"""Vector maps from Shapefile and GeoPackage, where the package fiona is installed.

Areas become coasts, lines rivers and points peaks, unless an attribute `kind` says otherwise.
Heights of peaks come from the first attribute of HEIGHTS, names from `name`. Features of every
layer are read, and projected to longitude and latitude.
"""

import os

from . import _core

SUFFIXES = (".shp", ".gpkg")
HEIGHTS = ("height_m", "elevation", "elev", "ele", "height", "z")
_KINDS = {"Polygon": "coast", "LineString": "river", "Point": "peak"}
_OWN = ("kind", "name", "height_m", "level_m", "clipped", "ends", "end_height_m", "rank")


def read_map(file):
    """The map in a file as a GeoJSON collection, a dictionary.

    Raises
    ------
    InputError
        The file cannot be read, or fiona is not installed.
    """
    try:
        import fiona
    except ImportError:
        raise _core.InputError(f"{file}: needs the package fiona: pip install fiona") from None
    try:
        features = [f for layer in fiona.listlayers(file) for f in _features(fiona, file, layer)]
    except fiona.errors.FionaError as error:
        raise _core.InputError(f"{file}: {error}") from None
    name = os.path.basename(file).split(".")[0]
    return {"type": "FeatureCollection", "name": name, "features": features}


def _features(fiona, file, layer):
    from fiona.transform import transform_geom

    with fiona.open(file, layer=layer) as source:
        crs = source.crs or "EPSG:4326"
        for feature in source:
            if feature.geometry is None:
                continue
            geometry = transform_geom(crs, "EPSG:4326", feature.geometry)
            for kind, coordinates in _parts(geometry["type"], geometry["coordinates"]):
                if kind in _KINDS:
                    yield {
                        "type": "Feature",
                        "properties": _properties(feature.properties, kind),
                        "geometry": {"type": kind, "coordinates": _flat(coordinates)},
                    }


def _parts(kind, coordinates):
    if not kind.startswith("Multi"):
        return [(kind, coordinates)]
    return [(kind.removeprefix("Multi"), part) for part in coordinates]


def _flat(coordinates):
    """Without heights of points."""
    if isinstance(coordinates[0], int | float):
        return list(coordinates[:2])
    return [_flat(part) for part in coordinates]


def _properties(given, geometry):
    given = {key.lower(): value for key, value in given.items() if value not in (None, "")}
    found = {key: given[key] for key in _OWN if key in given}
    found.setdefault("kind", _KINDS[geometry])
    height = next((given[key] for key in HEIGHTS if key in given), None)
    if found["kind"] == "peak" and height is not None:
        try:
            found["height_m"] = float(height)
        except ValueError:
            pass  # a note, not a number
    return found
