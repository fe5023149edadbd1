# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .hydrology import RiverBeds
from .inputs import VectorMap
from .hydrology import WatershedMap

def combine_relief(
    fold_relief: ArrayLike,
    watershed: WatershedMap,
    land: ArrayLike,
    threads: int = 0,
    *,
    blend_distance: float = ...,
    reconcile: bool = ...,
    reconcile_distance: float = ...,
    valley_slope: float = ...,
    valley_wall_slope: float = ...,
) -> NDArray[np.float32]: ...

def enforce_map(
    elevation: ArrayLike,
    map: VectorMap,
    land: ArrayLike,
    beds: RiverBeds,
    threads: int = 0,
    *,
    least_height: float = ...,
    summit_reach: float = ...,
    least_fall: float = ...,
) -> tuple[Any, ...]: ...

def lay_sea_floor(
    elevation: ArrayLike,
    land: ArrayLike,
    cell_size: float,
    seed: int = 0,
    threads: int = 0,
    *,
    shelf_width: float = ...,
    shelf_depth: float = ...,
    slope_width: float = ...,
    deep_depth: float = ...,
    sea_floor_relief: float = ...,
) -> NDArray[np.float32]: ...
