"""Stream power against `fastscapelib`, another solver of the same equation (n = 1, one receiver a
cell, backward in time), over many steps from the same ground without pits.

So that both solve the same thing, water is routed over the ground before it rises, and cells at
base level do not rise. On a raster no more is needed. On triangles the wheel counts Voronoi's
cells; here a vertex has a third of its triangles, and the wheel is given those areas.
"""

import numpy as np
import orogen
import pytest

fastscapelib = pytest.importorskip("fastscapelib")

UPLIFT, ROCK, YEARS, STEPS = 1e-3, 2e-5, 1e4, 20  # m/yr, m^(1-2m)/yr, yr


class Peer:
    """Its ground, as an array of the grid's own shape."""

    def __init__(self, grid, z, base, m):
        routing = [fastscapelib.SingleFlowRouter(), fastscapelib.MSTSinkResolver()]
        self.grid = grid  # which its graph does not keep alive
        self.graph = fastscapelib.FlowGraph(grid, routing)
        self.rivers = fastscapelib.SPLEroder(self.graph, ROCK, m, 1.0, 1e-12)
        self.z, self.lift = z.astype(float), np.where(base, 0.0, UPLIFT * YEARS)

    def step(self, weight=1.0):
        """Returns the drainage area in m2."""
        self.graph.update_routes(self.z)
        area = self.graph.accumulate(weight)
        lifted = self.z + self.lift
        self.z = lifted - self.rivers.erode(lifted, area, YEARS)
        return area


@pytest.mark.parametrize("m", [0.4, 0.45, 0.5])
@pytest.mark.parametrize("shape", [(64, 80), (37, 41)])
def test_steps_on_a_raster_are_the_peers(m, shape):
    cell = 200.0
    row, column = np.mgrid[: shape[0], : shape[1]]
    rim = np.minimum.reduce([row, column, shape[0] - 1 - row, shape[1] - 1 - column])
    noise = np.random.default_rng(1).random(shape)
    ours = np.where(rim > 0, 5.0 * rim + 4.0 * noise, 0.0).astype(np.float32)
    base = rim == 0
    fixed = fastscapelib.NodeStatus.FIXED_VALUE
    peer = Peer(fastscapelib.RasterGrid(list(shape), [cell, cell], fixed), ours, base, m)
    start = ours.copy()
    for _ in range(STEPS):
        flow = orogen.hydrology.route_flow(ours, base, cell)
        assert flow.pit_count == 0
        area = orogen.hydrology.drainage_area(flow)
        ours = orogen.erosion.erode_stream_power(
            ours, base, cell, uplift_rate=np.where(base, 0, UPLIFT).astype(np.float32),
            erodibility=ROCK, area_exponent=m, step_years=YEARS, steps=1,
        )[0]  # fmt: skip
        theirs = peer.step()
        assert np.abs(area[~base] / theirs[~base] - 1.0).max() < 1e-6
    relief = np.ptp(peer.z)
    assert np.abs(peer.z - start).max() > 0.1 * relief  # much has happened
    assert np.abs(ours - peer.z).max() < 1e-6 * relief


def lies_above_a_neighbour(tin, z):
    start = np.repeat(np.arange(len(tin)), np.diff(tin.first_edge))
    lowest = np.full(len(tin), np.inf)
    np.minimum.at(lowest, start, z[tin.neighbors])
    return z > lowest


@pytest.mark.parametrize("m", [0.4, 0.5])
def test_steps_on_triangles_are_the_peers(m):
    width, height = 20e3, 16e3
    tin = orogen.erosion.Tin.jittered((width, height), 300.0, seed=3)
    x, y = tin.points.T
    inside = np.minimum.reduce([x, width - x, y, height - y])
    base, random = tin.sides > 0, np.random.default_rng(5)
    ours = np.where(base, 0.0, 0.02 * inside + random.random(len(tin)))
    start = ours.copy()
    status = np.where(base, fastscapelib.NodeStatus.FIXED_VALUE, fastscapelib.NodeStatus.CORE)
    # Its mesh wants numbers that say nothing of places: else it takes minutes to make.
    order = random.permutation(len(tin))
    rank = np.argsort(order)
    mesh = fastscapelib.TriMesh(
        tin.points[order], rank[tin.triangles].astype(np.uint64), status[order].astype(np.uint8)
    )
    inner = ~base[order]
    weight = np.where(inner, tin.cell_areas[order] / np.where(inner, mesh.nodes_areas(), 1.0), 0.0)
    peer = Peer(mesh, ours[order], base[order], m)
    for _ in range(STEPS):
        assert (lies_above_a_neighbour(tin, ours) | base).all()
        ours, area, _, _ = orogen.erosion.erode_stream_power_tin(
            tin, ours, base, YEARS, uplift_rate=UPLIFT, erodibility=ROCK, area_exponent=m
        )
        theirs = peer.step(weight)
        assert np.abs(area[order][inner] / theirs[inner] - 1.0).max() < 1e-12
    relief = np.ptp(peer.z)
    assert np.abs(peer.z - start[order]).max() > 0.1 * relief
    # Lengths of edges are float32 here.
    assert np.abs(ours[order] - peer.z).max() < 1e-7 * relief
