"""orogen.tectonics of paper C, against slow NumPy and SciPy versions of its equations."""

import gc

import numpy as np
import orogen
import pytest

tectonics = orogen.tectonics


@pytest.fixture
def turned():
    """Plates of any form that turn and move, as recipes have them."""
    random = np.random.default_rng(5)
    plates = []
    for center, turn, shift in (((2e4, 3e4), 0.2, (3e3, 1e3)), ((7e4, 6e4), -0.1, (-4e3, 500))):
        points = center + random.normal(0, 5e3, (12, 2))
        cosine, sine = np.cos(turn), np.sin(turn)
        way = (points - center) @ np.array([[cosine, sine], [-sine, cosine]]) + center + shift
        arrows = way - points + random.normal(0, 100, points.shape)
        plates.append({"points": points, "arrows": arrows})
    return plates


def test_rigid_motion_is_the_least_squares_fit(turned):
    for plate, given in zip(tectonics.rigid_plates(turned), turned, strict=True):
        points, ends = given["points"], given["points"] + given["arrows"]
        a, b = points - points.mean(0), ends - ends.mean(0)
        u, _, vt = np.linalg.svd(a.T @ b)  # Kabsch
        rotation = (u @ vt).T
        translation = ends.mean(0) - rotation @ points.mean(0)
        assert plate.angle == pytest.approx(np.arctan2(rotation[1, 0], rotation[0, 0]), abs=1e-12)
        assert plate.translation == pytest.approx(translation, abs=1e-6)
        moved = points @ rotation.T + translation
        assert plate.arrows == pytest.approx(moved - points, abs=1e-6)
        assert plate.residual_m == pytest.approx(
            np.sqrt(((ends - moved) ** 2).sum(1).mean()), rel=1e-9
        )
        assert plate.displacement == pytest.approx(
            np.sqrt((plate.arrows**2).sum(1).mean()), rel=1e-12
        )
        assert plate.moved_hull == pytest.approx(plate.hull @ rotation.T + translation, abs=1e-6)


def test_hulls_are_convex_hulls(turned):
    spatial = pytest.importorskip("scipy.spatial")
    for plate, given in zip(tectonics.rigid_plates(turned), turned, strict=True):
        hull = given["points"][spatial.ConvexHull(given["points"]).vertices]
        assert {tuple(p) for p in plate.hull} == {tuple(p) for p in hull}
        x, y = plate.hull.T
        assert (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() > 0  # anticlockwise


def test_plates_keep_names_and_crust_and_own_their_arrays(squares):
    squares[1]["crust"] = "oceanic"
    plates = tectonics.rigid_plates(squares)
    assert [(p.name, p.crust) for p in plates] == [("south", "continental"), ("north", "oceanic")]
    hull = plates[0].hull
    assert not hull.flags.writeable
    kept = hull.copy()
    del plates
    gc.collect()
    assert (hull == kept).all()


@pytest.mark.parametrize(
    "change, says",
    [
        ({"arrows": [[0, 0]]}, "plates[0].arrows: 1 arrows for 4 points"),
        ({"arrows": [[0, float("nan")]] * 4}, "plates[0].arrows[0][1]: nan"),
        ({"arrows": {1, 2}}, "plates[0].arrows: a set"),
        ({"crust": "thin"}, "plates[0].crust"),
        ({"colour": "red"}, "plates[0]: there is no member 'colour'"),
        ({"arrows": [[0, 60e3]] * 4}, "plates"),  # onto the other plate
    ],
)
def test_bad_plates(squares, change, says):
    squares[0].update(change)
    with pytest.raises(orogen.InputError) as caught:
        tectonics.rigid_plates(squares)
    assert str(caught.value).startswith(says)


def nearest_on_hull(hull, p):
    """The slow way: the nearest point of every side."""
    a, e = hull, np.roll(hull, -1, 0) - hull
    if (e[:, 0] * (p - a)[:, 1] - e[:, 1] * (p - a)[:, 0] >= 0).all():
        return p
    t = np.clip(((p - a) * e).sum(1) / (e * e).sum(1), 0, 1)[:, None]
    feet = a + t * e
    return feet[((feet - p) ** 2).sum(1).argmin()]


def inverse(plates, p, exponent):
    """Equations 1 and 2."""
    shift, weights = np.zeros(2), 0.0
    for plate in plates:
        cosine, sine = np.cos(plate.angle), np.sin(plate.angle)
        foot = nearest_on_hull(plate.moved_hull, p)
        back = np.array([[cosine, sine], [-sine, cosine]]) @ (foot - plate.translation)
        distance = np.hypot(*(p - foot))
        if distance == 0:
            return back
        shift += (back - foot) * distance**-exponent
        weights += distance**-exponent
    return p + shift / weights


@pytest.mark.parametrize("exponent", [0.9, 2.0])
def test_transport_is_equations_1_and_2(turned, exponent):
    plates = tectonics.rigid_plates(turned)
    points = np.random.default_rng(1).uniform(0, 1e5, (300, 2))
    points = np.vstack([points, [plate.moved_hull.mean(0) for plate in plates]])
    result = tectonics.transport_inverse(plates, points, falloff_exponent=exponent)
    expected = [inverse(plates, p, exponent) for p in points]
    assert result == pytest.approx(np.array(expected), abs=1e-4)
    assert (tectonics.transport_inverse([], points) == points).all()
    with pytest.raises(orogen.InputError, match=r"points: shape \(3,\)"):
        tectonics.transport_inverse(plates, [1, 2, 3])
    with pytest.raises(orogen.InputError, match=r"points\[1\]"):
        tectonics.transport_inverse(plates, [[1, 2], [3, np.inf]])


def test_compression_is_that_of_the_transport(turned):
    plates = tectonics.rigid_plates(turned)
    grid = orogen.Grid(50, 40, 2000.0, (500.0, -700.0))
    field = tectonics.compression_field(plates, grid)
    x, y = (grid.origin[k] + 2000.0 * np.arange(n + 1) for k, n in ((0, 50), (1, 40)))
    corners = np.stack(np.meshgrid(x, y), -1)
    q = tectonics.transport_inverse(plates, corners.reshape(-1, 2)).reshape(corners.shape)
    sw, se, nw, ne = q[:-1, :-1], q[:-1, 1:], q[1:, :-1], q[1:, 1:]
    d, e = ne - sw, nw - se
    area = 0.5 * (d[..., 0] * e[..., 1] - d[..., 1] * e[..., 0])
    assert field.crust == pytest.approx(area / 2000.0**2, rel=1e-4)
    assert field.source_area_m2 == pytest.approx(area.sum(), rel=1e-9)
    gradient = np.stack([(se + ne - sw - nw) / 4000.0, (nw + ne - sw - se) / 4000.0], -1)
    deformation = np.linalg.inv(gradient)
    _, stretch, vt = np.linalg.svd(deformation)  # columns of U = sqrt(FtF), the smaller last
    strength = np.maximum(1 - stretch[..., 1], 0)
    size = np.hypot(field.compression_x, field.compression_y)
    assert size == pytest.approx(strength, abs=2e-5)
    along = np.abs(field.compression_x * vt[..., 1, 0] + field.compression_y * vt[..., 1, 1])
    assert along == pytest.approx(strength, abs=1e-4)
    assert size.max() > 0.02
    center = np.stack(np.meshgrid(x[:-1] + 1000, y[:-1] + 1000), -1).reshape(-1, 2)
    near = [
        np.argmin([np.hypot(*(p - nearest_on_hull(k.moved_hull, p))) for k in plates])
        for p in center
    ]
    assert (field.influence.ravel() == near).mean() > 0.999
    assert field.grid.shape == (40, 50)


def test_smoothing_is_a_gaussian_of_the_tensor():
    ndimage = pytest.importorskip("scipy.ndimage")
    random = np.random.default_rng(2)
    c = ndimage.gaussian_filter(random.normal(0, 1, (2, 80, 80)), (0, 3, 3))
    grid = orogen.Grid(80, 80, 100.0)
    field = tectonics.CompressionField.from_arrays(*c, grid)
    assert (field.crust == 1).all() and (field.influence == -1).all()
    smooth = tectonics.smoothed_compression(field, 400.0)
    size = np.hypot(*c)
    parts = [ndimage.gaussian_filter(c[i] * c[j] / size, 4) for i, j in ((0, 0), (0, 1), (1, 1))]
    values, vectors = np.linalg.eigh(np.moveaxis(np.array([parts[:2], parts[1:]]), (0, 1), (2, 3)))
    inner = np.s_[20:-20, 20:-20]
    result = np.stack([smooth.compression_x, smooth.compression_y], -1)
    strength = values[..., 1] - values[..., 0]
    assert np.linalg.norm(result, axis=-1)[inner] == pytest.approx(
        strength[inner], abs=0.02 * size.max()
    )
    along = np.abs((result * vectors[..., :, 1]).sum(-1))
    assert along[inner] == pytest.approx(strength[inner], abs=0.02 * size.max())
    same = tectonics.smoothed_compression(field, 0.0)
    assert (same.compression_x == field.compression_x).all()
    with pytest.raises(orogen.InputError, match="-1"):
        tectonics.smoothed_compression(field, -1.0)


def test_uplift_has_its_mean_and_ends_at_the_fault(squares):
    plates = tectonics.rigid_plates(squares)
    grid = orogen.Grid(100, 100, 1000.0)
    field = tectonics.compression_field(plates, grid)
    uplift = tectonics.collision_uplift(plates, field, target_uplift_rate=1e-3)
    rate = uplift.uplift_rate
    assert rate[rate > 0.01 * rate.max()].mean() == pytest.approx(1e-3, rel=1e-3)
    assert uplift.stable_plate == 1  # which rests
    assert (rate[uplift.fault < 0] == 0).all() and (uplift.fault < 0).any()
    assert all(line.shape[1] == 2 for line in uplift.fault_lines)
    free = tectonics.collision_uplift(plates, field, fault=False)
    assert (free.fault == 200e3).all() and free.fault_lines == []
    assert (free.uplift_rate > 0).sum() > (rate > 0).sum()
    with pytest.raises(orogen.InputError, match="stable_plate: 2"):
        tectonics.collision_uplift(plates, field, stable_plate=2)
    for others in (plates[:1], []):
        with pytest.raises(orogen.InputError, match="field: lies in the influence of plate"):
            tectonics.collision_uplift(others, field)
        with pytest.raises(orogen.InputError, match="field: lies in the influence of plate"):
            tectonics.plate_margins(others, field)


def test_margins(squares):
    grid = orogen.Grid(100, 100, 1000.0)
    squares[0]["crust"] = "oceanic"
    plates = tectonics.rigid_plates(squares)
    field = tectonics.compression_field(plates, grid)
    margins = tectonics.plate_margins(
        plates, field, trench_depth=3000, growth_time=1e6, arc_distance=20e3, seed=3
    )
    assert margins.uplift_rate.min() == pytest.approx(-3000 / 1e6, rel=0.05)
    assert margins.volcanoes.shape[1] == 2 and len(margins.volcanoes) > 1
    for x, y in margins.volcanoes:
        row, column = int(y // 1000), int(x // 1000)
        assert field.influence[row, column] == 1  # the upper plate
    for plate in squares:
        plate["crust"] = "continental"
    squares[0]["arrows"] = [[0, -5000]] * 4
    plates = tectonics.rigid_plates(squares)
    rift = tectonics.plate_margins(
        plates, tectonics.compression_field(plates, grid), rift_depth=1000, growth_time=1e6
    )
    assert rift.uplift_rate.min() == pytest.approx(-1000 / 1e6, rel=0.05)
    assert len(rift.volcanoes) == 0


def test_motion_above_a_straight_fault():
    distance = np.tile(1000.0 * np.arange(-10, 50), (20, 1)) + 500  # the fault lies in the west
    uplift = np.where(distance > 0, 1e-3, 0)
    motion = tectonics.fault_motion(uplift, distance, 1000.0, dip_deg=40, dip_reach=20e3)
    s = np.clip(distance / 20e3, 0, 1)
    expected = -1e-3 / np.tan(np.radians(40)) * (1 - s) ** 2 * (1 + 2 * s) * (distance > 0)
    assert motion.velocity_x == pytest.approx(expected, abs=2e-5)
    assert motion.velocity_y == pytest.approx(0, abs=1e-9)


def test_floating_crust():
    keywords = {"crust_density": 2700.0, "mantle_density": 3200.0}
    assert tectonics.airy_uplift_share(**keywords) == pytest.approx(1 - 2700 / 3200)
    assert tectonics.airy_root_share(**keywords) == pytest.approx(2700 / 500)
    load = np.random.default_rng(0).uniform(0, 1000, (20, 30))
    sunk = tectonics.flexural_deflection(load, 1000.0, elastic_thickness=0, **keywords)
    assert sunk == pytest.approx(load * 2700 / 500, rel=1e-4)
    with pytest.raises(orogen.InputError, match="mantle_density"):
        tectonics.flexural_deflection(load, 1000.0, crust_density=3300, mantle_density=3300)


def test_a_line_load_bends_the_plate_as_the_textbook_says():
    alpha = tectonics.flexural_parameter(elastic_thickness=20e3)
    rigidity = 7e10 * 20e3**3 / (12 * (1 - 0.25**2))
    assert alpha == pytest.approx((4 * rigidity / (500 * 9.81)) ** 0.25)
    cell = 4000.0
    load = np.zeros((601, 201), np.float32)
    load[:, 100] = 1000.0
    sunk = tectonics.flexural_deflection(load, cell, elastic_thickness=20e3)[300]
    x = np.abs(np.arange(201) - 100) * cell / alpha
    deepest = 2800 * 1000.0 * cell / (2 * alpha * 500)  # ρ_c h Δx / (2 α Δρ)
    expected = deepest * np.exp(-x) * (np.cos(x) + np.sin(x))
    assert sunk == pytest.approx(expected, abs=0.005 * deepest)
