# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Any

from numpy.typing import NDArray

from ._core import Grid

class Island:
    @property
    def biomes(self) -> NDArray[Any]: ...
    @property
    def center_elevation(self) -> NDArray[Any]: ...
    @property
    def center_moisture(self) -> NDArray[Any]: ...
    @property
    def center_ocean(self) -> NDArray[Any]: ...
    @property
    def center_temperature(self) -> NDArray[Any]: ...
    @property
    def center_water(self) -> NDArray[Any]: ...
    @property
    def coast(self) -> NDArray[Any]: ...
    @property
    def corner_elevation(self) -> NDArray[Any]: ...
    @property
    def corner_moisture(self) -> NDArray[Any]: ...
    @property
    def corner_river(self) -> NDArray[Any]: ...
    @property
    def downstream(self) -> NDArray[Any]: ...
    @property
    def edge_river(self) -> NDArray[Any]: ...
    @property
    def map(self) -> PolygonMap: ...

class IslandRelief:
    @property
    def biome(self) -> NDArray[Any]: ...
    @property
    def elevation(self) -> NDArray[Any]: ...
    @property
    def land(self) -> NDArray[Any]: ...
    @property
    def moisture(self) -> NDArray[Any]: ...
    @property
    def temperature(self) -> NDArray[Any]: ...
    @property
    def water_depth(self) -> NDArray[Any]: ...

class PolygonMap:
    @property
    def center_corners(self) -> tuple: ...
    @property
    def center_edges(self) -> tuple: ...
    @property
    def centers(self) -> NDArray[Any]: ...
    @property
    def corner_centers(self) -> tuple: ...
    @property
    def corner_edges(self) -> tuple: ...
    @property
    def corners(self) -> NDArray[Any]: ...
    @property
    def edge_centers(self) -> NDArray[Any]: ...
    @property
    def edge_corners(self) -> NDArray[Any]: ...

def biomes(
) -> list[dict[str, Any]]: ...

def island_relief(
    island: Island,
    grid: Grid,
    seed: int = 0,
    threads: int = 0,
    *,
    peak_height: float = ...,
    sea_depth: float = ...,
    height_exponent: float = ...,
    perturbation: float = ...,
    relief: float = ...,
    relief_frequency: float = ...,
    relief_octaves: int = ...,
    lake_depth: float = ...,
) -> IslandRelief: ...

def make_island(
    grid: Grid,
    seed: int = 0,
    threads: int = 0,
    *,
    cells: int = ...,
    relaxations: int = ...,
    octaves: int = ...,
    base_octave: float = ...,
    octave_scale: float = ...,
    base_amplitude: float = ...,
    amplitude_scale: float = ...,
    distance_scale: float = ...,
    offset: float = ...,
    window: float = ...,
    water_share: float = ...,
    river_density: float = ...,
    river_spacing: int = ...,
    moist_volume: float = ...,
    moisture_decay: float = ...,
) -> Island: ...
