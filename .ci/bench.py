"""Benchmarks as JSON lines: Google Benchmark's cases from standard input, then others.

    orogen_bench --benchmark_format=json | python .ci/bench.py

Of repeated runs the fastest counts. `goal_seconds` is what the project holds itself to, on two
cores. Lines with a `peer` time it on the same work in the same run; `ratio` is its time over ours.
fastscapelib's vertices are numbered at random: in our order its mesh takes a time that grows with
the square of their number. That costs it some half of a step's speed at a million vertices.
The stages are those of the default recipe for Corsica, about 1024 x 1024 cells (the longer side is
chosen so that the number of cells is that); the mountain is the recipe folded_range with a vertex a
cell and 100 steps on the finest mesh.
"""

import importlib.metadata
import json
import math
import sys
import time

import numpy as np
import orogen

CELLS = 1024 * 1024
RUNS = 3
SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
RECIPE_GOAL, MOUNTAIN_GOAL = 4.0, 40.0
GOALS = {
    "compression/1024": 0.030,
    "fold_skeleton/7000": 0.002,
    "fold_skeleton/3000": 0.008,
    "fold_skeleton/1000": 0.080,
    "fold_heights/1024/7000": 0.030,
    "fold_heights/1024/3000": 0.030,
    "fold_heights/1024/1000": 0.030,
    "tin_stream_power/vertices:10000/threads:2/exponent_x10:10": 0.001,
    "tin_stream_power/vertices:100000/threads:2/exponent_x10:10": 0.010,
    "tin_stream_power/vertices:1000000/threads:2/exponent_x10:10": 0.180,
}


def write(**line):
    print(json.dumps(line), flush=True)


def goal(seconds):
    return {} if seconds is None else {"goal_seconds": seconds}


def google_benchmarks(document):
    fastest = {}
    for run in document["benchmarks"]:
        if run.get("run_type") == "aggregate" or "real_time" not in run:
            continue
        seconds = run["real_time"] * SECONDS[run["time_unit"]]
        best = fastest.get(run["run_name"])
        if best is None or seconds < best[0]:
            fastest[run["run_name"]] = seconds, run
    known = {"items_per_second", "bytes_per_second"}
    for name, (seconds, run) in fastest.items():
        counters = {key: run[key] for key in known & run.keys()}
        write(case=name, seconds=seconds, **goal(GOALS.get(plain_name(name))), **counters)


def plain_name(name):
    return name.removesuffix("/real_time")


def stages():
    recipe = orogen.Recipe.load("corsica")
    grid = recipe.grid(1024)
    resolution = round(1024 * math.sqrt(CELLS / (grid.nx * grid.ny)))
    runs = []
    for _ in range(RUNS):
        terrain = orogen.generate(recipe, resolution=resolution, cache=None)
        runs.append(terrain.report["seconds"])
    shape = terrain.grid.shape
    for stage in runs[0]:
        seconds = min(run[stage] for run in runs)
        write(stage=stage, seconds=seconds, cells=list(shape))
    seconds = min(sum(run.values()) for run in runs)
    write(stage="all", seconds=seconds, **goal(RECIPE_GOAL), cells=list(shape))


def mountain():
    document = orogen.Recipe.load("folded_range").to_dict()
    for stage in document["stages"]:
        if stage["stage"] == "mountain_growth":
            stage["parameters"] |= {"vertices_per_cell": 1.0, "steps": 100}
    recipe = orogen.Recipe.from_dict(document)
    grid = recipe.grid(1024)
    resolution = round(1024 * math.sqrt(CELLS / (grid.nx * grid.ny)))
    terrain = orogen.generate(recipe, resolution=resolution, cache=None)
    report = terrain.report
    write(
        case="mountain/1000000 vertices/100 steps",
        seconds=sum(report["seconds"].values()),
        **goal(MOUNTAIN_GOAL),
        stages=report["seconds"],
        cells=list(terrain.grid.shape),
        peak_memory_bytes=report["peak_memory_bytes"],
    )


class TinRun:
    """Ground near its steady state on a mesh of some `count` vertices 100 m apart, four open
    sides."""

    WARM, UPLIFT, ROCK, YEARS = 5, 1e-3, 2e-5, 1e4

    def __init__(self, count):
        side = 100.0 * math.sqrt(count)
        self.steps = max(5, min(100, 2_000_000 // count))
        self.tin = orogen.erosion.Tin.jittered((side, side), 100.0 * math.sqrt(1.155), seed=1)
        self.base = self.tin.sides > 0
        noise = np.random.default_rng(42).random(len(self.tin))
        self.z = self.ours(np.where(self.base, 0.0, noise), self.WARM, 0)

    def ours(self, z, steps, threads):
        return orogen.erosion.erode_stream_power_tin(
            self.tin, z, self.base, self.YEARS, steps, uplift_rate=self.UPLIFT,
            erodibility=self.ROCK, threads=threads,
        )[0]  # fmt: skip

    def our_seconds(self, threads):
        """A step, with its share of what the call itself takes."""
        times = []
        for _ in range(RUNS):
            start = time.perf_counter()
            self.ours(self.z, self.steps, threads)
            times.append((time.perf_counter() - start) / self.steps)
        return min(times)

    def their_seconds(self, peer, order):
        """A step on the same mesh, its vertices numbered in `order`, mesh and graph made before."""
        rank = np.empty_like(order)
        rank[order] = np.arange(len(order))
        status = np.where(self.base, peer.NodeStatus.FIXED_VALUE, peer.NodeStatus.CORE)
        mesh = peer.TriMesh(
            self.tin.points[order],
            rank[self.tin.triangles].astype(np.uint64),
            status[order].astype(np.uint8),
        )
        graph = peer.FlowGraph(mesh, [peer.SingleFlowRouter(), peer.MSTSinkResolver()])
        rivers = peer.SPLEroder(graph, self.ROCK, 0.5, 1.0, 1e-5)
        z, lift = self.z[order], np.where(self.base, 0.0, self.UPLIFT * self.YEARS)[order]
        times = []
        for _ in range(max(RUNS, 200_000 // len(order))):
            start = time.perf_counter()
            lifted = z + lift
            graph.update_routes(lifted)
            area = graph.accumulate(1.0)
            z = lifted - rivers.erode(lifted, area, self.YEARS)
            times.append(time.perf_counter() - start)
        return min(times)


def peers():
    try:
        import fastscapelib
    except ImportError:
        write(peer="fastscapelib", skipped="not installed; pip install fastscapelib")
        return
    version = importlib.metadata.version("fastscapelib")
    for count in (10_000, 100_000, 1_000_000):
        run = TinRun(count)
        order = np.random.default_rng(1).permutation(len(run.tin))
        theirs = run.their_seconds(fastscapelib, order)
        for threads in (1, 2):
            ours = run.our_seconds(threads)
            write(
                case=f"tin_step/{count}", threads=threads, seconds=ours,
                peer=f"fastscapelib {version}", peer_seconds=theirs, peer_threads=1,
                ratio=theirs / ours,
            )  # fmt: skip


if __name__ == "__main__":
    google_benchmarks(json.load(sys.stdin))
    stages()
    mountain()
    peers()
