"""The report of a run: what was made, from what, how long it took."""

import hashlib
import re
from pathlib import Path

from . import _core


def peak_memory_bytes():
    """Most memory that this process has held; None where the system does not say."""
    try:
        # What getrusage says on Linux counts the program that started this one, too.
        status = Path("/proc/self/status").read_text()
        return int(re.search(r"^VmHWM:\s*(\d+) kB", status, re.MULTILINE)[1]) * 1024
    except OSError:
        pass
    try:
        import resource
    except ImportError:  # Windows
        return None
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # bytes on macOS


def describe_grid(grid):
    return {
        "nx": grid.nx,
        "ny": grid.ny,
        "cell_size": grid.cell_size,
        "origin": list(grid.origin),
    }


def make_report(terrain):
    recipe = terrain.recipe
    stages = terrain._core.stages
    return {
        "name": terrain.name,
        "version": _core.__version__,
        "recipe_sha256": recipe.hash,
        "seed": terrain.seed,
        "projection": recipe.projection,
        "grid": describe_grid(terrain.grid),
        "seconds": {stage: round(seconds, 6) for stage, seconds, _ in stages},
        "from_cache": [stage for stage, _, cached in stages if cached],
        "estimated_memory_bytes": terrain._core.estimated_bytes,
        "peak_memory_bytes": peak_memory_bytes(),
        "sha256": {name: hashlib.sha256(terrain[name].data).hexdigest() for name in terrain},
        "warnings": terrain.warnings,
    }
