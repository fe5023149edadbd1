"""Benchmarks as JSON lines: Google Benchmark's cases from standard input, then the stages' times.

    orogen_bench --benchmark_format=json | python .ci/bench.py

Of repeated runs the fastest counts. The stages are those of the default recipe for Corsica, about
1024 x 1024 cells (the longer side is chosen so that the number of cells is that).
"""

import json
import math
import sys

import orogen

CELLS = 1024 * 1024
RUNS = 3
SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def write(**line):
    print(json.dumps(line), flush=True)


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
        write(case=name, seconds=seconds, **counters)


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
        write(stage=stage, seconds=min(run[stage] for run in runs), cells=list(shape))
    write(stage="all", seconds=min(sum(run.values()) for run in runs), cells=list(shape))


if __name__ == "__main__":
    google_benchmarks(json.load(sys.stdin))
    stages()
