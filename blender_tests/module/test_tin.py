"""orogen.erosion.Tin and stream power on it, against SciPy and a slow loop."""

import gc

import numpy as np
import orogen
import pytest

Tin = orogen.erosion.Tin
erode = orogen.erosion.erode_stream_power_tin


@pytest.fixture
def tin():
    return Tin.jittered((12e3, 9e3), 300.0, seed=4, origin=(500.0, -100.0))


@pytest.mark.parametrize("make", [Tin.jittered, Tin.poisson])
def test_meshes_cover_their_rectangle(make):
    mesh = make((12e3, 9e3), 300.0, seed=4, origin=(500.0, -100.0))
    assert len(mesh) == len(mesh.points) == pytest.approx(1.155 * 108e6 / 300**2, rel=0.1)
    assert mesh.cell_areas.sum() == pytest.approx(108e6, rel=1e-12)
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    d, e = b - a, c - a
    area = 0.5 * (d[:, 0] * e[:, 1] - d[:, 1] * e[:, 0])
    assert (area > 0).all() and area.sum() == pytest.approx(108e6, rel=1e-12)
    thirds = np.bincount(mesh.triangles.ravel(), np.repeat(area / 3, 3), len(mesh))
    assert mesh.cell_areas == pytest.approx(thirds, rel=1e-9)
    x, y = mesh.points.T
    sides = 1 * (x == 500) + 2 * (x == 12500) + 4 * (y == -100) + 8 * (y == 8900)
    assert (mesh.sides == sides).all() and (sides > 0).sum() > 100


def test_triangles_are_delaunays():
    spatial = pytest.importorskip("scipy.spatial")
    points = np.random.default_rng(3).uniform(0, 1000, (200, 2))
    points = np.vstack([points, [[0, 0], [1000, 0], [0, 1000], [1000, 1000]]])
    mesh = Tin.from_points(points, (1000.0, 1000.0))
    assert {tuple(p) for p in mesh.points} == {tuple(p) for p in points}
    theirs = spatial.Delaunay(mesh.points).simplices
    assert {tuple(sorted(t)) for t in mesh.triangles} == {tuple(sorted(t)) for t in theirs}
    start = np.repeat(np.arange(len(mesh)), np.diff(mesh.first_edge))
    pairs = {tuple(sorted(p)) for t in theirs for p in (t[:2], t[1:], t[::2])}
    assert {tuple(sorted(p)) for p in zip(start, mesh.neighbors, strict=True)} == pairs
    length = np.linalg.norm(mesh.points[start] - mesh.points[mesh.neighbors], axis=1)
    assert mesh.edge_lengths == pytest.approx(length, rel=1e-6)


def test_bad_meshes():
    for arguments, says in [
        (((0, 5), 1.0), "domain"),
        (((5, float("nan")), 1.0), "domain"),
        (((5, 5), 0.0), "spacing"),
        (((5e6, 5e6), 1.0), "spacing"),
    ]:
        with pytest.raises(orogen.InputError, match=says):
            Tin.jittered(*arguments)
    for points, says in [([[0, 0]], "corner"), ([[0, 2]], "outside"), ([1], "shape")]:
        with pytest.raises(orogen.InputError, match=f"points: .*{says}"):
            Tin.from_points(points, (1.0, 1.0))


def test_arrays_are_views_that_keep_the_mesh():
    mesh = Tin.poisson((1e4, 1e4), 500.0)
    assert np.shares_memory(mesh.points, mesh.points) and not mesh.points.flags.writeable
    points = mesh.points
    kept = points.copy()
    del mesh
    gc.collect()
    Tin.poisson((1e4, 1e4), 500.0, seed=1)
    assert (points == kept).all()


def test_planes_are_sampled_exactly(tin):
    def plane(x, y):
        return 3.0 + 0.01 * x - 0.02 * y

    field = plane(*tin.points.T)
    grid = orogen.Grid(24, 18, 500.0, (500.0, -100.0))
    x, y = (o + 500.0 * (np.arange(n) + 0.5) for o, n in ((500, 24), (-100, 18)))
    assert tin.sample_to_grid(field, grid) == pytest.approx(plane(*np.meshgrid(x, y)), rel=1e-5)
    places = np.random.default_rng(0).uniform((500, -100), (12500, 8900), (100, 2))
    assert tin.sample_at(field, places) == pytest.approx(plane(*places.T), rel=1e-12)
    with pytest.raises(orogen.InputError, match="field: shape"):
        tin.sample_at(field[1:], places)
    with pytest.raises(orogen.InputError, match=r"field\[2\]: a finite"):
        tin.sample_to_grid(np.where(np.arange(len(tin)) == 2, np.nan, field), grid)


def hill(tin):
    """Without closed hollows: it falls to the west."""
    x, y = tin.points.T
    return 0.05 * (x - 500) + 0.01 * (x - 500) * np.cos(y / 900)


def slow_step(tin, z, base, dt, u, k, m, n, rain):
    """One step of Braun and Willett, vertex by vertex."""
    receiver, length = np.arange(len(z)), np.zeros(len(z))
    for v in np.flatnonzero(~base):
        edges = np.s_[tin.first_edge[v] : tin.first_edge[v + 1]]
        slope = (z[v] - z[tin.neighbors[edges]]) / tin.edge_lengths[edges]
        assert slope.max() > 0
        receiver[v] = tin.neighbors[edges][slope.argmax()]
        length[v] = tin.edge_lengths[edges][slope.argmax()]
    order = np.argsort(z, kind="stable")
    area = np.where(base, 0, tin.cell_areas * rain)
    for v in order[::-1]:
        if receiver[v] != v:
            area[receiver[v]] += area[v]
    new = z.copy()
    for v in order:
        if receiver[v] == v:
            continue
        below, rate = new[receiver[v]], k[v] * area[v] ** m / length[v] ** n
        low, high = below, max(z[v] + u * dt, below)
        for _ in range(200):  # bisection
            middle = 0.5 * (low + high)
            if middle + dt * rate * (middle - below) ** n < z[v] + u * dt:
                low = middle
            else:
                high = middle
        new[v] = low
    return new, area, receiver


@pytest.mark.parametrize("m, n", [(0.5, 1.0), (0.4, 1.5), (0.3, 0.7)])
def test_a_step_is_the_slow_one(tin, m, n):
    random = np.random.default_rng(9)
    z, base = hill(tin), (tin.sides & 1) > 0
    rock = random.uniform(1e-6, 3e-6, len(tin)).astype(np.float32)
    rain = random.uniform(0.5, 1.5, len(tin)).astype(np.float32)
    expected = slow_step(tin, z, base, 2e4, 1e-3, rock.astype(float), m, n, rain.astype(float))
    made, area, receivers, balance = erode(
        tin, z, base, 2e4, uplift_rate=1e-3, erodibility=rock, rain_weight=rain,
        area_exponent=m, slope_exponent=n,
    )  # fmt: skip
    assert (receivers == expected[2]).all()
    assert area[~base] == pytest.approx(expected[1][~base], rel=1e-9)
    assert made == pytest.approx(expected[0], abs=1e-6)
    lifted = 1e-3 * 2e4 * tin.cell_areas[~base].sum()
    assert balance.supplied_m3 == pytest.approx(lifted, rel=1e-12)
    change = ((made - z) * tin.cell_areas).sum()
    assert balance.exported_m3 == pytest.approx(lifted - change, rel=1e-9)
    assert balance.relative_residual < 1e-12


def test_steps_add_up_and_threads_do_not_count(tin):
    z, base = hill(tin), tin.sides > 0
    three = erode(tin, z, base, 1e5, 3, threads=1)
    one = (z,)
    for _ in range(3):
        one = erode(tin, one[0], base, 1e5, threads=2)
    for a, b in zip(three[:3], one[:3], strict=True):
        assert (a == b).all()
    assert three[3].supplied_m3 == pytest.approx(3 * one[3].supplied_m3)


def test_talus_holds_slopes(tin):
    z, base = hill(tin), tin.sides > 0
    steep, gentle = (
        erode(tin, z, base, 1e6, 5, uplift_rate=5e-3, talus_slope=t) for t in (None, 0.2)
    )

    def slopes(made):
        length = np.linalg.norm(tin.points - tin.points[made[2]], axis=1)
        return ((made[0] - made[0][made[2]]) / np.where(length > 0, length, 1)).max()

    assert slopes(steep) > 0.25 and slopes(gentle) <= 0.2 * (1 + 1e-6)


@pytest.mark.parametrize(
    "change, says",
    [
        ({"elevation": np.zeros(3)}, "elevation: shape (3,)"),
        ({"base_level": 0}, "base_level: shape ()"),
        ({"dt_years": -1.0}, "dt_years"),
        ({"steps": 0}, "steps: 0"),
        ({"erodibility": -1e-6}, "erodibility: -1e-06"),
        ({"erodibility": np.zeros(2)}, "erodibility: shape (2,)"),
        ({"talus_slope": -1.0}, "talus_slope: -1"),
        ({"uplift_rate": float("inf")}, "uplift_rate: a finite"),
        ({"slope_exponent": 9}, "slope_exponent: 9"),
    ],
)
def test_bad_arguments(tin, change, says):
    arguments = {"elevation": hill(tin), "base_level": tin.sides > 0, "dt_years": 1.0, **change}
    with pytest.raises(orogen.InputError) as caught:
        erode(tin, **arguments)
    assert str(caught.value).startswith(says)


def test_water_must_leave(tin):
    with pytest.raises(orogen.InputError, match="base_level: no vertex"):
        erode(tin, hill(tin), np.zeros(len(tin), bool), 1.0)


def test_the_mesh_of_a_grid():
    mesh = Tin.grid((3, 4), 50.0, origin=(10.0, 20.0))
    assert len(mesh) == 12 and (mesh.cell_areas == 2500).all()
    assert mesh.points[0] == pytest.approx([35, 45])
    assert mesh.points[-1] == pytest.approx([185, 145])
    beside = mesh.neighbors[mesh.first_edge[5] : mesh.first_edge[6]]
    assert list(beside) == [0, 1, 2, 4, 6, 8, 9, 10]
    with pytest.raises(orogen.InputError, match="columns, rows"):
        Tin.grid((1, 4), 50.0)


def test_rivers_lay_down_sediment(tin):
    base = (tin.sides > 0).astype(np.uint8)
    base &= tin.points[:, 1] < 0
    z = np.where(base, 0.0, 1.0 + tin.points[:, 0] % 7)
    uplift = np.where(tin.points[:, 1] > 4000, 1e-3, 0).astype(np.float32)
    common = dict(dt_years=2e4, steps=60, uplift_rate=uplift, erodibility=4e-6)
    bare = erode(tin, z, base, **common)
    filled = erode(tin, z, base, **common, deposition_coefficient=1.0)
    assert bare[3].relative_residual < 1e-12 and filled[3].relative_residual < 1e-12
    assert filled[3].exported_m3 < bare[3].exported_m3
    foreland = (tin.points[:, 1] > 2000) & (tin.points[:, 1] < 3500)
    assert filled[0][foreland].mean() > bare[0][foreland].mean() + 10
