# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import Grid
from .inputs import VectorMap

class FlowGraph:
    @property
    def grid(self) -> Grid: ...
    @property
    def pit_count(self) -> int: ...
    def receivers(self) -> NDArray[Any]: ...

class RiverBeds:
    @property
    def river(self) -> NDArray[Any]: ...

class WatershedMap:
    @property
    def elevation(self) -> NDArray[Any]: ...
    @property
    def river_distance(self) -> NDArray[Any]: ...

def carve_to_drain(
    elevation: ArrayLike,
    base_level: ArrayLike,
    cell_size: float,
    least_slope: float = 1e-05,
    threads: int = 0,
) -> NDArray[np.float32]: ...

def drainage_area(
    flow: FlowGraph,
    threads: int = 0,
) -> NDArray[np.float32]: ...

def fill_depressions(
    elevation: ArrayLike,
    base_level: ArrayLike,
    cell_size: float,
    epsilon: float = 0.0,
    threads: int = 0,
) -> NDArray[np.float32]: ...

def lay_river_beds(
    map: VectorMap,
    grid: Grid,
    land: ArrayLike,
    wander: float = 0.0,
    wander_wavelength: float = 2500.0,
    seed: int = 0,
) -> RiverBeds: ...

def route_flow(
    elevation: ArrayLike,
    base_level: ArrayLike,
    cell_size: float,
    threads: int = 0,
) -> FlowGraph: ...

def strahler_order(
    flow: FlowGraph,
    drainage_area: ArrayLike,
    least_area_m2: float,
    threads: int = 0,
) -> NDArray[np.int32]: ...

def watershed_labels(
    flow: FlowGraph,
    threads: int = 0,
) -> NDArray[np.int32]: ...

def watershed_map(
    map: VectorMap,
    beds: RiverBeds,
    land: ArrayLike,
    peak_distance: ArrayLike,
    threads: int = 0,
    *,
    river_slope: float = ...,
    hill_slope: float = ...,
    peak_steepening: float = ...,
    peak_reach: float = ...,
    floor_width: float = ...,
    source_share: float = ...,
    default_peak_height: float = ...,
) -> WatershedMap: ...
