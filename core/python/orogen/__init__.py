"""Terrain that obeys first-order geology, grown from a vector map.

>>> import orogen
>>> terrain = orogen.generate("corsica", resolution=256)
>>> terrain["elevation"].shape
(256, 132)
"""

from . import (
    climate,
    erosion,
    folding,
    hydrology,
    inputs,
    island,
    sculpting,
    strata,
    tectonics,
    vegetation,
)
from ._core import (
    Cache,
    Cancelled,
    Grid,
    InputError,
    MemoryLimitError,
    __version__,
    available_memory,
    schema,
)
from .elevation_files import Elevation, read_elevation
from .pipeline import Recipe, Terrain, cache, generate, pack_raster, shipped

__all__ = [
    "Cache",
    "Cancelled",
    "Elevation",
    "Grid",
    "InputError",
    "MemoryLimitError",
    "Recipe",
    "Terrain",
    "__version__",
    "available_memory",
    "cache",
    "climate",
    "erosion",
    "folding",
    "generate",
    "hydrology",
    "inputs",
    "island",
    "pack_raster",
    "read_elevation",
    "schema",
    "sculpting",
    "shipped",
    "strata",
    "tectonics",
    "vegetation",
]
