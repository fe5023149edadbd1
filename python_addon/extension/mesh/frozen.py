"""The ground that is frozen: that of the mesh; under live previews, which are coarse, the one
before them, which is a property of the mesh meanwhile."""

from dataclasses import dataclass

import numpy as np

from . import attributes

KEPT = "orogen_frozen"


@dataclass
class Ground:
    heights: np.ndarray  # rows from the south, m
    lower: list  # corner from the object's origin, m
    size: list  # m


def read(mesh):
    """None where nothing is grown."""
    if kept := mesh.get(KEPT):
        heights = np.frombuffer(kept["values"], np.float32).reshape(*kept["shape"])
        return Ground(heights, list(kept["lower"]), list(kept["size"]))
    if "orogen_grid" not in mesh or "elevation" not in mesh.attributes:
        return None
    nx, ny = mesh["orogen_grid"]
    heights = attributes.read(mesh, "elevation", (ny, nx))
    size = [n * mesh["orogen_cell_size"] for n in (nx, ny)]
    return Ground(heights, list(mesh["orogen_offset"]), size)


def keep(mesh):
    """Before a preview is written over it."""
    if KEPT not in mesh and (ground := read(mesh)):
        mesh[KEPT] = {
            "shape": list(ground.heights.shape),
            "values": ground.heights.tobytes(),
            "lower": ground.lower,
            "size": ground.size,
        }


def thaw(mesh):
    mesh.pop(KEPT, None)
