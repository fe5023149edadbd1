"""What hard and soft rock make of the land (paper C, figure 20), each by measured profiles.

Without the stage `rock_detail`: what is measured is the work of rivers, uplift and landslides.
"""

import numpy as np
import orogen
import pytest

RESOLUTION = 512
CLIFF = np.tan(np.radians(40.0))  # between the talus slopes of soft and hard rock


def document(name, resistance=None):
    """A shipped recipe as it is, or with one resistance for all its rock."""
    recipe = orogen.Recipe.load(name).to_dict()
    recipe["stages"] = [s for s in recipe["stages"] if s["stage"] != "rock_detail"]
    if resistance is not None:
        for layer in recipe["column"]["layers"]:
            for bed in layer["sub_layers"]:
                bed["resistance"] = resistance
    return recipe


def walk(z, cell, start, sign):
    """From `start` up (sign 1) or down (-1) the steepest way, while it is as steep as a cliff."""
    row, column = start
    while True:
        best, to = CLIFF, None
        for i in range(max(row - 1, 0), min(row + 2, z.shape[0])):
            for j in range(max(column - 1, 0), min(column + 2, z.shape[1])):
                way = cell * np.hypot(i - row, j - column)
                if way > 0 and sign * (z[i, j] - z[row, column]) / way > best:
                    best, to = sign * (z[i, j] - z[row, column]) / way, (i, j)
        if to is None:
            return row, column
        row, column = to


def neighbours(mask):
    """True beside a cell of the mask."""
    wide = np.pad(mask, 1)
    return wide[2:, 1:-1] | wide[:-2, 1:-1] | wide[1:-1, 2:] | wide[1:-1, :-2]


def capped(thickness, lithology="quartzite"):
    """Uplift of a flat bed over soft shale: the recipe `hard_cap` with two layers, and smaller."""
    recipe = document("hard_cap")
    recipe["extent"]["size"] = [18e3, 12e3]
    north = recipe["phases"][0]["plates"][1]
    north["points"] = [[x, y - 8e3] for x, y in north["points"]]
    parameters = {item["stage"]: item.get("parameters", {}) for item in recipe["stages"]}
    parameters["collision"]["crust_smoothing"] = 1000
    parameters["mountain_growth"].update(soft_erodibility=8e-6, hard_erodibility=5e-7)
    soft = {"name": "soft", "thickness": 2000, "fold_share": 0}
    hard = {"name": "cap", "thickness": thickness, "fold_share": 0}
    recipe["column"] = {
        "basement": {"thickness": 5000, "fold_share": 0, "sub_layers": [{"lithology": "shale"}]},
        "layers": [
            {**soft, "sub_layers": [{"lithology": "shale"}]},
            {**hard, "sub_layers": [{"lithology": lithology}]},
        ],
    }
    return recipe


def cliffs(terrain):
    """Heights of the cliffs along the lower edge of the cap, and whether they end in soft rock."""
    z, layer = terrain["elevation"].astype(float), terrain["rock_layer"]
    edge = np.argwhere((layer == 2) & neighbours(layer < 2))
    heights, in_soft = [], []
    for start in edge[:: max(1, len(edge) // 600)]:
        top = walk(z, terrain.grid.cell_size, start, 1)
        foot = walk(z, terrain.grid.cell_size, start, -1)
        heights.append(z[top] - z[foot])
        in_soft.append(layer[foot] < 2)
    return np.array(heights), np.mean(in_soft)


def test_a_hard_bed_over_a_soft_one_makes_a_cliff_as_high_as_the_bed():
    thickness, height = [80.0, 160.0, 240.0], []
    for bed in thickness:
        heights, in_soft = cliffs(orogen.generate(capped(bed), resolution=RESOLUTION))
        assert heights.size > 200 and in_soft > 0.97
        height.append(np.median(heights))
    slope, offset = np.polyfit(thickness, height, 1)
    assert 0.85 < slope < 1.15
    assert 0 < offset < 2 * 18e3 / RESOLUTION  # the cells at both ends
    assert np.corrcoef(thickness, height)[0, 1] > 0.99

    plain = orogen.generate(capped(160, "shale"), resolution=RESOLUTION)
    gy, gx = np.gradient(plain["elevation"], plain.grid.cell_size)
    assert (np.hypot(gx, gy) > CLIFF).mean() < 0.002


def summits(z, prominence):
    """Indices of the summits that stand that far above the saddle to higher ground."""
    flat, columns = z.ravel(), z.shape[1]
    parent, found = np.full(z.size, -1), []  # of the islands over a sinking sea, by their summit

    def island(cell):
        while parent[cell] != cell:
            parent[cell] = parent[parent[cell]]
            cell = parent[cell]
        return cell

    for cell in np.argsort(-flat, kind="stable"):
        row, column = divmod(int(cell), columns)
        beside = {
            island(i * columns + j)
            for i in range(max(row - 1, 0), min(row + 2, z.shape[0]))
            for j in range(max(column - 1, 0), min(column + 2, columns))
            if parent[i * columns + j] >= 0
        }
        highest = max(beside, key=lambda summit: flat[summit], default=int(cell))
        parent[cell] = highest
        for summit in beside - {highest}:
            parent[summit] = highest
            if flat[summit] - flat[cell] >= prominence:
                found.append(summit)
    return np.array([*found, np.argmax(flat)])


def summits_and_rock(resistance=None):
    """Number of summits 30 m and more over their saddles, and the share that is hard rock."""
    terrain = orogen.generate(document("alternating_beds", resistance), resolution=500)
    hard = (terrain["rock_layer"] > 0) & (terrain["rock_sublayer"] % 2 == 1)
    found = summits(terrain["elevation"].astype(float), 30.0)
    return found.size, hard.ravel()[found].mean(), hard.mean()


def test_alternating_beds_make_small_summits():
    number, on_hard, area = summits_and_rock()
    assert on_hard > 0.8 and on_hard > 1.2 * area
    for same in (0.4, 0.8):  # as hard as the two on average, as the limestone
        fewer, on_the_beds, _ = summits_and_rock(same)
        assert number > 1.25 * fewer
        assert on_the_beds < 0.65


HARD = (2, 4, 6)  # layers of limestone in `cirque`
CENTRE = 12e3


def radial(terrain, field, reach=10e3, azimuths=72):
    """A field along rays from the middle of the basin: distance, and a row for each ray."""
    cell = terrain.grid.cell_size
    r = np.arange(0.5 * cell, reach, cell)
    a = np.arange(azimuths)[:, None] * 2 * np.pi / azimuths
    rows = ((CENTRE + r * np.sin(a)) / cell).astype(int)
    columns = ((CENTRE + r * np.cos(a)) / cell).astype(int)
    return r, terrain[field][rows, columns]


class Rings:
    """Where the beds of a basin crop out around its middle."""

    def __init__(self, terrain):
        self.r, self.z = radial(terrain, "elevation")
        self.layer = radial(terrain, "rock_layer")[1]
        self.centre = self.z[:, self.r < 1500].mean()
        self.window = int(300 / terrain.grid.cell_size)

    def crests(self, bed):
        """Of each ray that meets the bed: height over the middle, fall outward and inward."""
        rows = []
        for z, layer in zip(self.z, self.layer, strict=True):
            here = np.flatnonzero(layer == bed)
            if not here.size:
                continue
            first = max(here[-1] - self.window, 0)
            crest = first + z[first : here[-1] + self.window].argmax()
            out = z[min(crest + 2 * self.window, z.size - 1)]
            within = z[max(crest - 2 * self.window, 0)]
            rows.append((z[crest] - self.centre, z[crest] - out, z[crest] - within))
        return np.array(rows).T

    def highest_is_hard(self):
        """Share of rays whose highest place is on a hard bed, and that of all places."""
        ring = self.r > 2500
        at = self.z[:, ring].argmax(axis=1)
        layer = self.layer[:, ring]
        top = layer[np.arange(len(layer)), at]
        return np.isin(top, HARD).mean(), np.isin(layer, HARD).mean()


def test_a_stack_that_dips_inward_makes_a_cirque():
    rings = Rings(orogen.generate(document("cirque"), resolution=400))
    for bed in HARD:
        above, out, within = rings.crests(bed)
        assert above.size >= 68  # of 72: a ring all round
        assert (above > 0).mean() > 0.9 and np.median(above) > 120
    above, out, within = rings.crests(HARD[0])  # the outermost, a cuesta: steep outward
    assert (out > within).mean() > 0.8 and np.median(out) > 2.5 * np.median(within)
    highest, area = rings.highest_is_hard()
    assert highest > 0.8 and area < 0.4

    same = Rings(orogen.generate(document("cirque", 0.3), resolution=400))
    assert same.highest_is_hard()[0] < 0.4
    assert np.median(same.crests(HARD[0])[0]) < 0.4 * np.median(rings.crests(HARD[0])[0])


@pytest.fixture(scope="module")
def ranges():
    """Figure 17: the same uplift, different folds."""
    names = ("viscous_only", "one_fold_layer", "two_fold_layers_10_5", "two_fold_layers_15_3")
    return {name: orogen.generate(document(name), resolution=500) for name in names}


def core(terrain):
    """The rows of the range where the crust rises most."""
    rate = terrain["crust_uplift_rate"].mean(axis=1)
    rows = np.flatnonzero(rate > 0.7 * rate.max())
    return slice(rows[0], rows[-1])


def test_the_mean_uplift_of_the_four_is_one(ranges):
    mean = {
        name: (t["crust_uplift_rate"] + t["fold_uplift_rate"])[core(t)].mean()
        for name, t in ranges.items()
    }
    for name in mean:
        assert mean[name] == pytest.approx(mean["viscous_only"], rel=0.03)
    for t in ranges.values():
        assert t["crust_uplift_rate"].std(axis=1).max() < 1e-3 * t["crust_uplift_rate"].max()
    assert ranges["viscous_only"]["fold_uplift_rate"].max() == 0


def spectrum(z):
    """Mean power at each of 1,024 wave numbers down the columns."""
    window = np.hanning(len(z))[:, None]
    power = np.abs(np.fft.rfft(z * window, n=1024, axis=0)) ** 2
    return power.mean(axis=1) / (window**2).sum()


def across_over_along(terrain):
    """Wavelengths (m), and the power of heights across the range over that along it."""
    z = terrain["elevation"].astype(float)[core(terrain)]
    y = np.arange(len(z))
    across = spectrum(z - np.polyval(np.polyfit(y, z.mean(axis=1), 2), y)[:, None])
    along = spectrum((z - z.mean(axis=1, keepdims=True)).T)
    wavelength = 1.0 / np.maximum(np.fft.rfftfreq(1024, terrain.grid.cell_size), 1e-9)
    some = (wavelength > 2000) & (wavelength < 20000)
    gain = np.convolve(across / along, np.ones(3) / 3, "same")
    return wavelength[some], gain[some]


@pytest.mark.parametrize(
    "name, shortest, longest",
    [
        ("one_fold_layer", 7000, 7000),
        ("two_fold_layers_10_5", 5000, 10000),
        ("two_fold_layers_15_3", 15000, 15000),
    ],
)
def test_ridges_stand_as_far_apart_as_folds(ranges, name, shortest, longest):
    wavelength, gain = across_over_along(ranges[name])
    plain = across_over_along(ranges["viscous_only"])[1]
    best = gain.argmax()
    assert 0.8 * shortest < wavelength[best] < 1.2 * longest
    assert gain[best] > 3.0 and gain[best] > 2.5 * plain[best]


def strike(terrain):
    """-1: slopes face along the range (spurs across it); 1: across it (ridges along it)."""
    gy, gx = np.gradient(terrain["elevation"].astype(float), terrain.grid.cell_size)
    gy, gx = gy[core(terrain)], gx[core(terrain)]
    return ((gy**2).sum() - (gx**2).sum()) / ((gx**2).sum() + (gy**2).sum())


def test_without_folds_valleys_run_across_the_range(ranges):
    plain = strike(ranges["viscous_only"])
    assert plain < -0.02
    for name, terrain in ranges.items():
        if name != "viscous_only":
            assert strike(terrain) > plain + 0.02


def valley_trend(terrain, reach=5000.0):
    """-1: rivers of more than 10 km² run along the range; 1: across it."""
    area = terrain["drainage_area"].astype(float)
    rows, columns = area.shape
    wide, number = np.pad(area, 1, constant_values=-1.0), np.arange(area.size).reshape(area.shape)
    numbers, most, to = np.pad(number, 1), area, number
    for i in range(3):
        for j in range(3):
            beside = wide[i : i + rows, j : j + columns]
            to = np.where(beside > most, numbers[i : i + rows, j : j + columns], to)
            most = np.maximum(most, beside)
    inside = np.zeros(area.shape, bool)
    inside[core(terrain)] = True
    start = np.flatnonzero(inside & (area > 1e7) & (area < 1e9))
    end = start
    for _ in range(int(reach / terrain.grid.cell_size)):
        end = to.ravel()[end]
    dy, dx = end // columns - start // columns, end % columns - start % columns
    return ((dy**2).sum() - (dx**2).sum()) / ((dx**2).sum() + (dy**2).sum())


def test_rivers_turn_along_the_folds(ranges):
    trend = {name: valley_trend(terrain) for name, terrain in ranges.items()}
    assert trend.pop("viscous_only") > 0.04
    assert max(trend.values()) < -0.03
