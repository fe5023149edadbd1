# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import Grid
from .inputs import VectorMap

class BoundaryMap:
    @property
    def boundary_distance(self) -> NDArray[Any]: ...
    @property
    def boundary_kind(self) -> NDArray[Any]: ...
    @property
    def convergence(self) -> NDArray[Any]: ...

class CollisionUplift:
    @property
    def fault(self) -> NDArray[Any]: ...
    @property
    def fault_lines(self) -> list: ...
    @property
    def stable_plate(self) -> int: ...
    @property
    def uplift_rate(self) -> NDArray[Any]: ...

class CompressionField:
    @property
    def compression_x(self) -> NDArray[Any]: ...
    @property
    def compression_y(self) -> NDArray[Any]: ...
    @property
    def crust(self) -> NDArray[Any]: ...
    @staticmethod
    def from_arrays(compression_x: Any, compression_y: Any, grid: Grid) -> CompressionField: ...
    @property
    def grid(self) -> Grid: ...
    @property
    def influence(self) -> NDArray[Any]: ...
    @property
    def source_area_m2(self) -> float: ...

class FaultMotion:
    @property
    def velocity_x(self) -> NDArray[Any]: ...
    @property
    def velocity_y(self) -> NDArray[Any]: ...

class PlateMap:
    @property
    def peak_distance(self) -> NDArray[Any]: ...
    @property
    def plate(self) -> NDArray[Any]: ...
    @property
    def plates(self) -> list: ...
    @property
    def volcanoes(self) -> list: ...

class PlateMargins:
    @property
    def uplift_rate(self) -> NDArray[Any]: ...
    @property
    def volcanoes(self) -> NDArray[Any]: ...

class RigidPlate:
    @property
    def angle(self) -> float: ...
    @property
    def arrows(self) -> NDArray[Any]: ...
    @property
    def crust(self) -> str: ...
    @property
    def displacement(self) -> float: ...
    @property
    def hull(self) -> NDArray[Any]: ...
    @property
    def moved_hull(self) -> NDArray[Any]: ...
    @property
    def name(self) -> str: ...
    @property
    def residual_m(self) -> float: ...
    @property
    def translation(self) -> tuple: ...

class VelocityMap:
    @property
    def velocity_x(self) -> NDArray[Any]: ...
    @property
    def velocity_y(self) -> NDArray[Any]: ...

def airy_root_share(
    *,
    isostasy: Literal['none', 'airy', 'flexure'] = ...,
    crust_density: float = ...,
    mantle_density: float = ...,
    elastic_thickness: float = ...,
    young_modulus: float = ...,
    poisson_ratio: float = ...,
) -> float: ...

def airy_uplift_share(
    *,
    isostasy: Literal['none', 'airy', 'flexure'] = ...,
    crust_density: float = ...,
    mantle_density: float = ...,
    elastic_thickness: float = ...,
    young_modulus: float = ...,
    poisson_ratio: float = ...,
) -> float: ...

def collision_uplift(
    plates: list[RigidPlate],
    field: CompressionField,
    threads: int = 0,
    *,
    crust_smoothing: float = ...,
    target_uplift_rate: float = ...,
    fault: bool = ...,
    stable_plate: int = ...,
    fault_level: float = ...,
    fault_offset: float = ...,
) -> CollisionUplift: ...

def compression_field(
    plates: list[RigidPlate],
    grid: Grid,
    threads: int = 0,
    *,
    falloff_exponent: float = ...,
) -> CompressionField: ...

def fault_motion(
    uplift_rate: ArrayLike,
    fault: ArrayLike,
    cell_size: float,
    threads: int = 0,
    *,
    dipping_fault: bool = ...,
    dip_deg: float = ...,
    dip_reach: float = ...,
) -> FaultMotion: ...

def flexural_deflection(
    load: ArrayLike,
    cell_size: float,
    threads: int = 0,
    *,
    isostasy: Literal['none', 'airy', 'flexure'] = ...,
    crust_density: float = ...,
    mantle_density: float = ...,
    elastic_thickness: float = ...,
    young_modulus: float = ...,
    poisson_ratio: float = ...,
) -> NDArray[np.float32]: ...

def flexural_parameter(
    *,
    isostasy: Literal['none', 'airy', 'flexure'] = ...,
    crust_density: float = ...,
    mantle_density: float = ...,
    elastic_thickness: float = ...,
    young_modulus: float = ...,
    poisson_ratio: float = ...,
) -> float: ...

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

def isostatic_uplift(
    thickening: ArrayLike,
    cell_size: float,
    threads: int = 0,
    *,
    isostasy: Literal['none', 'airy', 'flexure'] = ...,
    crust_density: float = ...,
    mantle_density: float = ...,
    elastic_thickness: float = ...,
    young_modulus: float = ...,
    poisson_ratio: float = ...,
) -> NDArray[np.float32]: ...

def plate_boundaries(
    plates: PlateMap,
    threads: int = 0,
    *,
    fade_length: float = ...,
    fade_distance: float = ...,
    slow_speed: float = ...,
) -> BoundaryMap: ...

def plate_margins(
    plates: list[RigidPlate],
    field: CompressionField,
    growth_time: float = 2000000.0,
    seed: int = 0,
    threads: int = 0,
    *,
    margins: bool = ...,
    margin_smoothing: float = ...,
    rift_depth: float = ...,
    rift_width: float = ...,
    trench_depth: float = ...,
    trench_width: float = ...,
    arc_distance: float = ...,
    arc_height: float = ...,
    arc_width: float = ...,
    volcano_height: float = ...,
    volcano_radius: float = ...,
    volcano_spacing: float = ...,
) -> PlateMargins: ...

def rigid_plates(
    plates: list[dict[str, Any]],
) -> list[RigidPlate]: ...

def smoothed_compression(
    field: CompressionField,
    smoothing: float,
    threads: int = 0,
) -> CompressionField: ...

def transport_inverse(
    plates: list[RigidPlate],
    points: ArrayLike,
    threads: int = 0,
    *,
    falloff_exponent: float = ...,
) -> NDArray[np.float64]: ...

def velocity_map(
    plates: PlateMap,
    threads: int = 0,
    *,
    velocity_blur: float = ...,
) -> VelocityMap: ...
