"""The rooms' functions on NumPy arrays."""

import gc
import inspect
import json
import re

import numpy as np
import orogen
import pytest

ROOMS = (
    "inputs",
    "tectonics",
    "folding",
    "strata",
    "hydrology",
    "sculpting",
    "erosion",
    "vegetation",
)
FUNCTIONS = [
    getattr(getattr(orogen, room), name)
    for room in ROOMS
    for name in getattr(orogen, room).__all__
    if not inspect.isclass(getattr(getattr(orogen, room), name))
]


@pytest.fixture
def vector_map(island):
    return orogen.inputs.VectorMap.read(json.dumps(island))


@pytest.fixture
def hill():
    y, x = np.mgrid[0:41, 0:50].astype(np.float32)
    return 400 - 0.3 * ((x - 25) ** 2 + (y - 20) ** 2) + 10 * np.sin(x) * np.cos(0.7 * y)


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: f.__name__)
def test_docstrings_say_everything(function):
    doc = inspect.getdoc(function)
    signature = inspect.signature(function)
    for section in ("Parameters\n----------", "Returns\n-------", "Raises\n------"):
        assert section in doc
    for name, parameter in signature.parameters.items():
        line = re.search(rf"^{name} : .+$", doc, re.M)
        assert line, name
        if parameter.default is not parameter.empty:
            assert ", optional" in line[0] or ", default" in line[0]
    assert function.__module__.startswith("orogen")


def test_paper_a_step_by_step_is_what_the_pipeline_does(vector_map, island):
    grid = vector_map.grid(96)
    assert grid.shape == (72, 96)
    land = orogen.inputs.land_mask(vector_map, grid)
    plates = orogen.tectonics.infer_plates(vector_map, grid, seed=4, boundary_roughness=500)
    boundaries = orogen.tectonics.plate_boundaries(plates, fade_length=5000)
    velocity = orogen.tectonics.velocity_map(plates)
    folds = orogen.folding.warped_folds(vector_map, plates, boundaries, velocity, seed=4)
    beds = orogen.hydrology.lay_river_beds(vector_map, grid, land, seed=4)
    watershed = orogen.hydrology.watershed_map(vector_map, beds, land, plates.peak_distance)
    combined = orogen.sculpting.combine_relief(folds, watershed, land)
    growth = orogen.erosion.grow_relief(vector_map, combined, land, beds, seed=4, coarse_steps=5)
    law, area = orogen.sculpting.enforce_map(growth.elevation, vector_map, land, beds)
    ground = orogen.sculpting.lay_sea_floor(law, land, grid.cell_size, seed=4)
    for array in (folds, combined, growth.uplift_rate, growth.erodibility, area, ground):
        assert array.shape == grid.shape and array.dtype == np.float32
        assert np.isfinite(array).all()
    terrain = orogen.generate(island, resolution=96)
    assert (terrain["land"] == land).all()
    assert (ground[land == 0] < 0).all()
    assert len(plates.plates) == plates.plate.max() + 1
    assert (beds.river > 0).sum() > 10


def test_vector_map(vector_map):
    assert [peak["height_m"] for peak in vector_map.peaks] == [1500, 1100, 900, 700]
    assert vector_map.rivers[0]["end"] == "sea"
    assert len(vector_map.coasts[0]["outer"]) == 6
    assert vector_map.size == (40000, 30000)
    again = orogen.inputs.VectorMap.read(vector_map.to_geojson())
    assert again.peaks == vector_map.peaks and again.coasts == vector_map.coasts
    with pytest.raises(orogen.InputError):
        orogen.inputs.VectorMap.read("{}")


def test_flow(hill):
    base = np.zeros(hill.shape, bool)
    base[[0, -1]] = base[:, [0, -1]] = True
    flow = orogen.hydrology.route_flow(hill, base, 30.0)
    receivers = flow.receivers()
    assert (receivers[base] == np.flatnonzero(base)).all()
    area = orogen.hydrology.drainage_area(flow)
    assert area[~base].min() >= 900 * 0.999
    assert area[base].sum() == pytest.approx((~base).sum() * 900, rel=1e-5)
    order = orogen.hydrology.strahler_order(flow, area, 9000)
    assert order.max() >= 2
    labels = orogen.hydrology.watershed_labels(flow)
    assert labels.max() > 0
    filled = orogen.hydrology.fill_depressions(hill, base, 30.0)
    carved = orogen.hydrology.carve_to_drain(hill, base, 30.0)
    assert (filled >= hill - 1e-4).all() and (carved <= hill + 1e-4).all()
    assert (filled > hill).any() and (carved < hill).any()


def test_erosion(hill):
    result = orogen.erosion.erode_virtual_pipes(hill, 30.0, duration=600, seed=1)
    assert result.sediment_balance.relative_residual < 1e-5
    assert result.water_balance.relative_residual < 1e-5
    assert not np.array_equal(result.elevation, hill)
    slid = orogen.erosion.slip_sediment(hill, np.full_like(hill, 5), 30.0)
    assert slid.sediment_thickness.sum() == pytest.approx(5 * hill.size, rel=1e-4)
    base = np.zeros(hill.shape, bool)
    base[[0, -1]] = base[:, [0, -1]] = True
    z, area, balance = orogen.erosion.erode_stream_power(
        hill, base, 30.0, uplift_rate=1e-3, erodibility=np.full_like(hill, 1e-6), steps=3
    )
    assert z.shape == area.shape == hill.shape
    assert balance.relative_residual < 1e-9
    soft, balance = orogen.erosion.creep(hill, base, 30.0, 1e4, diffusivity=0.1)
    inner = np.s_[8:-8, 8:-8]
    assert np.diff(soft[inner]).std() < 0.99 * np.diff(hill[inner]).std()
    slid, balance = orogen.erosion.landslide(hill, base, 30.0, 15.0, float("inf"), rounds=5000)
    assert np.abs(np.diff(slid[1:-1, 1:-1])).max() < 30.0 * np.tan(np.radians(15.0)) * 1.05
    assert balance.eroded_m3 > 0
    with pytest.raises(orogen.InputError, match="talus_angle_deg: 90"):
        orogen.erosion.landslide(hill, base, 30.0, 90, 1.0)
    spring = orogen.erosion.erode_virtual_pipes(
        hill,
        30.0,
        sources=[(600.0, 450.0, 2.0)],
        rain_rate_mm_per_h=0.0,
        duration=60.0,
        water_depth=np.full_like(hill, 0.01),
    )
    assert spring.water_balance.supplied_m3 == pytest.approx(120.0, rel=1e-5)
    with pytest.raises(orogen.InputError, match=r"sources\[0\]"):
        orogen.erosion.erode_virtual_pipes(hill, 30.0, sources=[(-1.0, 0.0, 2.0)])
    setting = orogen.erosion.paper_b_setting(30.0, 500.0, units=2.0)
    assert setting["capacity_law"] == "velocity"
    assert orogen.erosion.erode_virtual_pipes(hill, 30.0, **setting).steps == 200
    with pytest.raises(orogen.Cancelled):
        orogen.erosion.erode_virtual_pipes(hill, 30.0, progress=lambda stage, fraction: False)


def test_results_are_views_that_keep_their_owner(hill):
    result = orogen.erosion.erode_virtual_pipes(hill, 30.0, duration=60)
    view = result.elevation
    assert np.shares_memory(view, result.elevation) and not view.flags.writeable
    copy = view.copy()
    del result
    gc.collect()
    orogen.erosion.erode_virtual_pipes(hill, 30.0, duration=60, seed=9)
    assert (view == copy).all()
    own = orogen.hydrology.fill_depressions(hill, hill < 100, 30.0)
    own[0, 0] = 7  # a result that nothing else holds may be written to
    assert own[0, 0] == 7


@pytest.mark.parametrize("dtype", ["float64", "int16", "uint8", ">f4"])
def test_arrays_of_other_types_and_orders_are_converted(hill, dtype):
    base = hill < 100
    given = np.clip(hill, 0, 255).astype(dtype)
    expected = orogen.hydrology.fill_depressions(given.astype(np.float32), base, 30.0)
    for array in (given, np.asfortranarray(given), given[::-1][::-1], given.tolist()):
        assert (orogen.hydrology.fill_depressions(array, base, 30.0) == expected).all()


@pytest.mark.parametrize(
    "arguments, keywords, says",
    [
        ((np.zeros(5), np.ones(5), 1.0), {}, "elevation: shape (5,)"),
        ((np.zeros((0, 5)), np.ones((0, 5)), 1.0), {}, "elevation: shape (0, 5)"),
        ((np.zeros((3, 3)), np.ones((3, 4)), 1.0), {}, "base_level: shape (3, 4)"),
        ((np.full((3, 3), np.nan), np.ones((3, 3)), 1.0), {}, "elevation[0, 0]: nan"),
        ((np.zeros((3, 3), complex), np.ones((3, 3)), 1.0), {}, "elevation: type complex128"),
        (([["a"]], [[1]], 1.0), {}, "elevation: type"),
        ((np.zeros((3, 3)), np.ones((3, 3)), 0.0), {}, "cell_size: 0"),
        ((np.zeros((3, 3)), np.ones((3, 3)), 1.0), {"threads": -1}, "threads: -1"),
    ],
)
def test_refusals(arguments, keywords, says):
    with pytest.raises(orogen.InputError) as caught:
        orogen.hydrology.fill_depressions(
            *(np.asarray(a, np.uint8) if a is arguments[1] else a for a in arguments), **keywords
        )
    assert says in str(caught.value)


def test_keywords_are_checked_by_the_declarations(hill):
    erode = orogen.erosion.erode_virtual_pipes
    for keywords, says in [
        ({"rain": 1}, "rain: no such parameter"),
        ({"duration": -1}, "duration: -1"),
        ({"duration": "long"}, "duration: 'long'"),
        ({"transport": "magic"}, "transport: 'magic'"),
        ({"random_rain": 1}, "random_rain: 1"),
        ({"duration": None}, "duration: a NoneType"),
        ({"slippage_interval": 1.5}, "slippage_interval: 1.5"),
    ]:
        with pytest.raises(orogen.InputError) as caught:
            erode(hill, 30.0, **keywords)
        assert str(caught.value).startswith(says)
    erode(
        hill, 30.0, duration=np.float32(8), slippage_interval=np.int64(2), transport="conservative"
    )


def test_grid():
    grid = orogen.Grid(4, 3, 10.0, (5.0, -5.0))
    assert (grid.nx, grid.ny, grid.shape, grid.origin) == (4, 3, (3, 4), (5.0, -5.0))
    for arguments in [(0, 3, 1.0), (3, -1, 1.0), (3, 3, float("nan")), (3, 3, 1.0, (1e400, 0))]:
        with pytest.raises(orogen.InputError):
            orogen.Grid(*arguments)


def test_stubs_are_up_to_date():
    import pathlib
    import subprocess
    import sys

    script = pathlib.Path(__file__).parents[2] / "core/python/bindings/make_stubs.py"
    if not script.exists():
        pytest.skip("the stubs' script lies in the repository only")
    result = subprocess.run([sys.executable, script, "--check"], capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr
