"""Maps from Shapefile and GeoPackage, written by GDAL."""

import orogen
import pytest

fiona = pytest.importorskip("fiona")

LON, LAT = 9.0, 42.0
SHAPES = {
    "land": ("MultiPolygon", [[[[(0.0, 0.0), (0.4, 0.0), (0.4, 0.3), (0.0, 0.3), (0.0, 0.0)]]]]),
    "streams": ("LineString", [[(0.2, 0.15), (0.1, 0.1), (0.0, 0.08)]]),
    "tops": ("3D Point", [(0.2, 0.2, 7.0), (0.3, 0.15, 7.0)]),
}


def moved(part):
    if isinstance(part, tuple) and isinstance(part[0], float):
        return (part[0] + LON, part[1] + LAT, *part[2:])
    return [moved(item) for item in part]


def write(file, driver, layers, crs="EPSG:4326"):
    from fiona.transform import transform_geom

    for layer in layers:
        kind, shapes = SHAPES[layer]
        schema = {"geometry": kind, "properties": {"NAME": "str", "ele": "float"}}
        more = {"layer": layer} if driver == "GPKG" else {}
        with fiona.open(file, "w", driver=driver, schema=schema, crs=crs, **more) as target:
            for i, shape in enumerate(shapes):
                geometry = {"type": kind.removeprefix("3D "), "coordinates": moved(shape)}
                target.write(
                    {
                        "geometry": transform_geom("EPSG:4326", crs, geometry),
                        "properties": {"NAME": f"{layer} {i}", "ele": 900.0 + i},
                    }
                )


@pytest.mark.parametrize("crs", ["EPSG:4326", "EPSG:32632"])
def test_geopackage_of_three_layers(tmp_path, crs):
    file = str(tmp_path / "isle.gpkg")
    write(file, "GPKG", SHAPES, crs)
    recipe = orogen.Recipe.load(file)
    map_ = recipe.to_dict()["map"]
    kinds = [feature["properties"]["kind"] for feature in map_["features"]]
    assert sorted(kinds) == ["coast", "peak", "peak", "river"] and recipe.name == "isle"
    peaks = [f for f in map_["features"] if f["properties"]["kind"] == "peak"]
    assert [peak["properties"]["height_m"] for peak in peaks] == [900, 901]
    assert peaks[0]["properties"]["name"] == "tops 0"
    assert peaks[0]["geometry"]["coordinates"] == pytest.approx([LON + 0.2, LAT + 0.2], abs=1e-6)
    terrain = orogen.generate(recipe, resolution=64)
    assert 0.2 < (terrain["land"] == 1).mean() < 0.99
    assert terrain["elevation"].max() == pytest.approx(901, abs=30)


def test_shapefile(tmp_path):
    file = str(tmp_path / "coast.shp")
    write(file, "ESRI Shapefile", ["land"])
    (feature,) = orogen.Recipe.load(file).to_dict()["map"]["features"]
    assert feature["properties"]["kind"] == "coast"
    assert feature["geometry"]["type"] == "Polygon"


def test_bad_files_are_refused(tmp_path):
    (tmp_path / "a.gpkg").write_bytes(b"no database")
    for name in ("a.gpkg", "missing.shp"):
        with pytest.raises(orogen.InputError, match=name):
            orogen.Recipe.load(str(tmp_path / name))
