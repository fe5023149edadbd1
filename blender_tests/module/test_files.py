"""Files a terrain is saved to, read back with other libraries than they were written with."""

import hashlib
import json
import os
import shutil
import subprocess
import sys

import numpy as np
import orogen
import pytest
from orogen import files


@pytest.fixture
def terrain(recipe):
    return orogen.generate(recipe)


def test_npz_reads_back_to_the_byte(terrain, tmp_path):
    report = terrain.save(tmp_path)
    with np.load(tmp_path / "island.npz", allow_pickle=False) as archive:
        for name, digest in report["sha256"].items():
            assert hashlib.sha256(archive[name].tobytes()).hexdigest() == digest


def test_tif_is_a_geotiff(terrain, tmp_path):
    tifffile = pytest.importorskip("tifffile")
    terrain.save(tmp_path, formats=["tif"])
    with tifffile.TiffFile(tmp_path / "elevation.tif") as file:
        page = file.pages[0]
        pixels = _decoded(page, tmp_path / "elevation.tif")
        assert (pixels[::-1] == terrain["elevation"]).all()
        grid = terrain.grid
        scale = page.tags["ModelPixelScaleTag"].value
        assert scale[:2] == (grid.cell_size, grid.cell_size)
        tie = page.tags["ModelTiepointTag"].value
        assert tie[3:5] == (grid.origin[0], grid.origin[1] + grid.ny * grid.cell_size)
        keys = page.geotiff_tags
    assert keys["ProjCenterLatGeoKey"] == 42 and keys["ProjCenterLongGeoKey"] == 9
    assert keys["GTRasterTypeGeoKey"] == 1


def _decoded(page, path):
    """Pixels, by tifffile if it has the codecs, else by Pillow."""
    try:
        return page.asarray()
    except (ValueError, ImportError):
        image = pytest.importorskip("PIL.Image")
        return np.asarray(image.open(path))


def test_tif_names_the_place_on_earth(terrain, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    pyproj = pytest.importorskip("pyproj")
    terrain.save(tmp_path, formats=["tif"])
    with rasterio.open(tmp_path / "elevation.tif") as file:
        crs = pyproj.CRS.from_wkt(file.crs.to_wkt())
        x, y = file.xy(0, 0)  # the north-western cell's centre
    to_lonlat = pyproj.Transformer.from_crs(crs, "EPSG:4326", always_xy=True)
    truth = pyproj.Transformer.from_crs(terrain.recipe.projection, "EPSG:4326", always_xy=True)
    grid = terrain.grid
    corner = (
        grid.origin[0] + 0.5 * grid.cell_size,
        grid.origin[1] + (grid.ny - 0.5) * grid.cell_size,
    )
    assert (x, y) == pytest.approx(corner)
    assert to_lonlat.transform(x, y) == pytest.approx(truth.transform(*corner), abs=1e-9)


def test_exr_keeps_32_bit_floats(terrain, tmp_path):
    oiio = pytest.importorskip("OpenImageIO")
    terrain.save(tmp_path, formats=["exr"], pictures=False)
    image = oiio.ImageInput.open(str(tmp_path / "elevation.exr"))
    assert str(image.spec().format) == "float"
    pixels = image.read_image("float")
    image.close()
    assert (np.squeeze(pixels)[::-1] == terrain["elevation"]).all()


def test_png16_gives_heights_within_half_a_step(terrain, tmp_path):
    oiio = pytest.importorskip("OpenImageIO")
    files.save_terrain(terrain, tmp_path, ["png16"], fields=["elevation", "plate"])
    scale = json.loads((tmp_path / "elevation.png.json").read_text())
    image = oiio.ImageInput.open(str(tmp_path / "elevation.png"))
    assert str(image.spec().format) == "uint16"
    pixels = np.squeeze(image.read_image("uint16"))[::-1].astype(float)
    image.close()
    assert pixels.min() == 0 and pixels.max() == 65535
    heights = pixels * scale["metres_per_unit"] + scale["offset"]
    error = np.abs(heights - terrain["elevation"]).max()
    assert error <= 0.5001 * scale["metres_per_unit"] + 1e-3
    scale = json.loads((tmp_path / "plate.png.json").read_text())
    image = oiio.ImageInput.open(str(tmp_path / "plate.png"))
    plates = (
        np.squeeze(image.read_image("uint16"))[::-1] * scale["value_per_unit"] + scale["offset"]
    )
    image.close()
    assert (plates == terrain["plate"]).all()


def test_vdb_is_a_level_set(terrain, tmp_path):
    terrain.save(tmp_path, formats=["vdb"], pictures=False)
    data = (tmp_path / "ground.vdb").read_bytes()
    assert data[:8] == b" BDV\0\0\0\0"
    reader = shutil.which("python3", path="/usr/bin")
    code = (
        "import pyopenvdb as v, sys; g = v.read(sys.argv[1], 'ground'); a = g.getConstAccessor();"
        "print(g.gridClass, g.transform.voxelSize()[0], *[a.getValue((x, y, z)) for x, y, z in"
        " eval(sys.argv[2])], sep='|')"
    )
    grid = terrain.grid
    column, row = grid.nx // 2, grid.ny // 2
    level = terrain["elevation"][row, column] / grid.cell_size
    places = [(column, row, int(np.floor(level)) - 2), (column, row, int(np.ceil(level)) + 2)]
    result = subprocess.run(
        [reader or sys.executable, "-I", "-c", code, tmp_path / "ground.vdb", str(places)],
        capture_output=True,
        text=True,
    )
    if "No module named" in result.stderr:
        pytest.skip("no other reader of VDB here (python3-openvdb)")
    kind, size, below, above = result.stdout.strip().split("|")
    assert kind == "level set"
    assert float(size) == pytest.approx(grid.cell_size)
    assert float(below) < 0 < float(above)


def test_pictures(terrain, tmp_path):
    image = pytest.importorskip("PIL.Image")
    terrain.save(tmp_path)
    shade = np.asarray(image.open(tmp_path / "hillshade.png"))
    preview = np.asarray(image.open(tmp_path / "preview.png"))
    assert shade.shape == terrain.grid.shape and preview.shape == (*terrain.grid.shape, 3)
    sea = (terrain["land"] == 0)[::-1]
    blue, red = preview[..., 2].astype(int), preview[..., 0].astype(int)
    assert (blue[sea] > red[sea]).mean() > 0.99
    assert np.ptp(shade) > 60


def test_hillshade_lights_slopes_that_face_north_west():
    from orogen.pictures import hillshade

    y, x = np.mgrid[0:40, 0:40].astype(np.float32)
    towards = hillshade(30 * (x - y), 100.0)[20, 20]  # rises to the south-east
    away = hillshade(30 * (y - x), 100.0)[20, 20]
    flat = hillshade(np.zeros((40, 40), np.float32), 100.0)[20, 20]
    assert towards > flat > away


@pytest.mark.parametrize("shape", [(1, 1), (1, 7), (2, 2), (2300, 3)])
def test_pictures_of_odd_sizes(shape):
    from orogen.pictures import _block_means, _blurred, hillshade

    z = np.arange(shape[0] * shape[1], dtype=np.float32).reshape(shape)
    assert hillshade(z, 10.0).shape == shape
    assert _blurred(z, 3).shape == shape
    assert _blurred(np.full(shape, 5.0), 3) == pytest.approx(5.0)
    assert _block_means(np.full(shape, 5.0), 2) == pytest.approx(5.0)


def test_refused_before_anything_is_written(terrain, tmp_path):
    with pytest.raises(orogen.InputError, match="there is no 'bmp'"):
        terrain.save(tmp_path / "out", formats=["npz", "bmp"])
    with pytest.raises(orogen.InputError, match="altitude"):
        files.save_terrain(terrain, tmp_path / "out", ["npz"], fields=["altitude"])
    assert not (tmp_path / "out").exists()


PROJECTIONS = (
    "+proj=aeqd +lat_0=42.18 +lon_0=9.06 +datum=WGS84",
    "+proj=utm +zone=32 +datum=WGS84",
    "+proj=utm +zone=59 +south +ellps=GRS80",
    "+proj=tmerc +lat_0=10 +lon_0=9 +k_0=0.9999 +x_0=100 +y_0=200 +a=6377397.155 +rf=299.1528128",
    "+proj=lcc +lat_1=46 +lat_2=49 +lat_0=47.5 +lon_0=13 +x_0=400000 +y_0=300000 +datum=WGS84",
    "+proj=lcc +lat_1=46 +lat_2=49 +lon_0=3 +datum=WGS84",
    "+proj=lcc +lat_1=46 +lat_0=46 +lon_0=3 +k_0=0.999 +datum=WGS84",
    "+proj=lcc +lat_1=46 +lat_0=46.5 +lon_0=3 +datum=WGS84",
    "+proj=merc +lon_0=9 +k=0.9 +datum=WGS84",
    "+proj=merc +lat_ts=40 +lon_0=9 +datum=WGS84",
    "+proj=aea +lat_1=46 +lat_2=49 +lat_0=47.5 +lon_0=13 +datum=NAD83",
    "+proj=laea +lat_0=52 +lon_0=10 +x_0=4321000 +y_0=3210000 +ellps=GRS80",
    "+proj=laea +lat_0=52 +lon_0=10 +R=6371000",
    "+proj=stere +lat_0=90 +lat_ts=70 +lon_0=-45 +datum=WGS84",
    "+proj=stere +lat_0=-90 +lon_0=0 +k=0.994 +x_0=2000000 +y_0=2000000 +datum=WGS84",
    "+proj=stere +lat_0=-90 +lat_ts=-71 +lon_0=0 +datum=WGS84",
)


@pytest.mark.parametrize("projection", PROJECTIONS)
def test_geotiff_keys_say_the_projection(projection, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    from orogen.geotiff import write_geotiff
    from rasterio.warp import transform

    write_geotiff(tmp_path / "a.tif", np.zeros((2, 3), np.float32), 30.0, 1.0, 2.0, projection)
    with rasterio.open(tmp_path / "a.tif") as file:
        found = file.crs
    lon, lat = transform(projection, "EPSG:4326", [2.1e5, 3.1e5], [2.4e5, 9e4])
    read = transform(found, "EPSG:4326", [2.1e5, 3.1e5], [2.4e5, 9e4])
    assert read == (pytest.approx(lon, abs=1e-9), pytest.approx(lat, abs=1e-9))


@pytest.mark.parametrize("shape", [(1, 1), (5, 3), (37, 53), (300, 1000)])
@pytest.mark.parametrize("dtype", ["float32", "int32"])
def test_pictures_of_any_size_read_back(shape, dtype, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    oiio = pytest.importorskip("OpenImageIO")
    from orogen.geotiff import write_geotiff
    from orogen.image_files import write_exr, write_png

    rng = np.random.default_rng(shape[0])
    field = (1000 * rng.normal(size=shape).cumsum(axis=1)).astype(dtype)
    write_geotiff(tmp_path / "a.tif", field, 30.0, 1000.0, 5000.0, name="elevation", unit="m")
    with rasterio.open(tmp_path / "a.tif") as file:
        assert (file.read(1) == field).all() and file.dtypes == (dtype,)
        assert file.transform == rasterio.Affine(30, 0, 1000, 0, -30, 5000)
        assert (file.descriptions, file.units) == (("elevation",), ("m",))
    write_exr(tmp_path / "a.exr", field)
    image = oiio.ImageInput.open(str(tmp_path / "a.exr"))
    assert (image.read_image("float").reshape(shape) == field.astype(np.float32)).all()
    image.close()
    rgba = rng.integers(0, 256, (*shape, 4)).astype(np.uint8)
    rgba[..., 3] = 255  # the reader multiplies colours by it
    for pixels in (rng.integers(0, 65536, shape).astype(np.uint16), rgba):
        write_png(tmp_path / "a.png", pixels)
        image = oiio.ImageInput.open(str(tmp_path / "a.png"))
        back = image.read_image(pixels.dtype.name)
        image.close()
        assert (np.reshape(back, pixels.shape) == pixels).all()


def test_a_failing_writer_leaves_what_was_there(terrain, tmp_path, monkeypatch):
    terrain.save(tmp_path / "out", formats=["npz"], pictures=False)
    before = {p.name: p.read_bytes() for p in (tmp_path / "out").iterdir()}

    def fail(terrain, folder, fields):
        with open(os.path.join(folder, "half.tif"), "w"):
            raise RuntimeError("disk is full")

    monkeypatch.setitem(files._WRITERS, "vdb", fail)
    with pytest.raises(RuntimeError):
        terrain.save(tmp_path / "out", formats=["npz", "vdb"])
    assert {p.name: p.read_bytes() for p in (tmp_path / "out").iterdir()} == before
    assert os.listdir(tmp_path) == ["out"]


def test_names_are_safe_on_disk(island, tmp_path):
    recipe = orogen.Recipe.from_dict({"orogen": 1, "name": "../a b/ü", "map": island})
    orogen.generate(recipe, resolution=16).save(tmp_path, pictures=False)
    assert "_a_b_ü.npz" in os.listdir(tmp_path)
