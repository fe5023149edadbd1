# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Any

from numpy.typing import NDArray

from ._core import Grid
from .inputs import VectorMap

class BoundaryMap:
    @property
    def boundary_distance(self) -> NDArray[Any]: ...
    @property
    def boundary_kind(self) -> NDArray[Any]: ...
    @property
    def convergence(self) -> NDArray[Any]: ...

class PlateMap:
    @property
    def peak_distance(self) -> NDArray[Any]: ...
    @property
    def plate(self) -> NDArray[Any]: ...
    @property
    def plates(self) -> list: ...
    @property
    def volcanoes(self) -> list: ...

class VelocityMap:
    @property
    def velocity_x(self) -> NDArray[Any]: ...
    @property
    def velocity_y(self) -> NDArray[Any]: ...

def infer_plates(
    map: VectorMap,
    grid: Grid,
    seed: int = 0,
    threads: int = 0,
    *,
    merge_direction: float = ...,
    merge_area: float = ...,
    plate_speed: float = ...,
    line_boundaries: bool = ...,
    chain_minimum_peaks: int = ...,
    volcanoes: bool = ...,
    isolation_factor: float = ...,
    boundary_roughness: float = ...,
    boundary_wavelength: float = ...,
) -> PlateMap: ...

def plate_boundaries(
    plates: PlateMap,
    threads: int = 0,
    *,
    fade_length: float = ...,
    fade_distance: float = ...,
    slow_speed: float = ...,
) -> BoundaryMap: ...

def velocity_map(
    plates: PlateMap,
    threads: int = 0,
    *,
    velocity_blur: float = ...,
) -> VelocityMap: ...
