"""Elevation models from files, against the programs that wrote them."""

import numpy as np
import orogen
import pytest

rasterio = pytest.importorskip("rasterio")


def heights(rows=40, columns=60):
    y, x = np.mgrid[0:rows, 0:columns]
    return (300 + 20 * y + 5 * x + 100 * np.sin(x / 7) * np.cos(y / 9)).astype(np.float32)


def write_tiff(path, values, crs, transform, **more):
    profile = {"driver": "GTiff", "count": 1, "dtype": values.dtype, "crs": crs, **more}
    rows, columns = values.shape
    with rasterio.open(
        path, "w", height=rows, width=columns, transform=transform, **profile
    ) as file:
        file.write(values[::-1], 1)  # pictures begin in the north
    return path


@pytest.mark.parametrize("compress", [None, "deflate", "packbits"])
@pytest.mark.parametrize("dtype", ["float32", "int16"])
def test_geotiff_in_metres(tmp_path, compress, dtype):
    values = heights().astype(dtype)
    place = rasterio.transform.from_origin(500_000, 4_700_000, 25, 25)
    file = write_tiff(tmp_path / "a.tif", values, "EPSG:32632", place, compress=compress)
    read = orogen.read_elevation(str(file))
    assert (read.values == values).all()
    assert read.size == (1500, 1000) and read.origin == (500_000, 4_699_000)


def test_geotiff_in_degrees_and_its_gaps(tmp_path):
    values = heights()
    values[10:20, 5:9] = -9999
    place = rasterio.transform.from_origin(9, 43, 0.001, 0.001)
    file = write_tiff(tmp_path / "a.tif", values, "EPSG:4326", place, nodata=-9999)
    read = orogen.read_elevation(str(file))
    assert read.size[0] == pytest.approx(60 * 111.2 * np.cos(np.radians(42.98)), rel=1e-3)
    assert read.size[1] == pytest.approx(40 * 111.2, rel=1e-3)
    gap = np.zeros(values.shape, bool)
    gap[10:20, 5:9] = True
    assert (read.values[~gap] == values[~gap]).all()
    assert (read.values[10:20, 5:7] == values[10:20, 4:5]).all()
    assert (read.values[10:20, 7:9] == values[10:20, 9:10]).all()


def test_srtm_tiles(tmp_path):
    values = heights(31, 31).astype(np.int16)
    values[3, 3] = -32768
    (tmp_path / "N42E009.hgt").write_bytes(values[::-1].astype(">i2").tobytes())
    read = orogen.read_elevation(str(tmp_path / "N42E009.hgt"))
    assert read.values[3, 3] == values[3, 2] and (read.values[4:] == values[4:]).all()
    assert read.size[1] == pytest.approx(111_195 * 31 / 30)
    assert read.size[0] == pytest.approx(read.size[1] * np.cos(np.radians(42.5)))


def test_an_elevation_model_is_a_recipe(tmp_path):
    np.save(tmp_path / "hill.npy", heights(64, 64))
    recipe = orogen.Recipe.load(tmp_path / "hill.npy")
    assert recipe.name == "hill" and recipe.resolution == 64
    terrain = orogen.generate(recipe)
    assert terrain.grid.cell_size == 30
    assert np.corrcoef(terrain["elevation"].ravel(), heights(64, 64).ravel())[0, 1] > 0.9


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("a.hgt", b"123456", "no square"),
        ("a.tif", b"no picture", "a.tif"),
        ("a.hgt", b"\x80\x00" * 16, "holds no heights"),
        ("a.xyz", b"", "is no elevation"),
    ],
)
def test_bad_files_are_refused(tmp_path, name, content, message):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(orogen.InputError, match=message):
        orogen.read_elevation(str(tmp_path / name))


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(orogen.InputError, match="No such file"):
        orogen.read_elevation(str(tmp_path / "a.tif"))
