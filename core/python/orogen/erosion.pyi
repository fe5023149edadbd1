# Made by core/python/bindings/make_stubs.py; do not edit.
from collections.abc import Callable
from typing import Any, Literal

from numpy.typing import ArrayLike, NDArray

from ._core import Grid
from .hydrology import RiverBeds
from .inputs import VectorMap

class GrownTin(Tin):
    @property
    def elevation(self) -> NDArray[Any]: ...
    @property
    def sediment_thickness(self) -> NDArray[Any]: ...

class MassBalance:
    @property
    def deposited_m3(self) -> float: ...
    @property
    def eroded_m3(self) -> float: ...
    @property
    def exported_m3(self) -> float: ...
    @property
    def relative_residual(self) -> float: ...
    @property
    def residual_m3(self) -> float: ...
    @property
    def stored_m3(self) -> float: ...
    @property
    def supplied_m3(self) -> float: ...

class PipeErosionResult:
    @property
    def deposition(self) -> NDArray[Any]: ...
    @property
    def elevation(self) -> NDArray[Any]: ...
    @property
    def sediment_balance(self) -> MassBalance: ...
    @property
    def sediment_thickness(self) -> NDArray[Any]: ...
    @property
    def steps(self) -> int: ...
    @property
    def time_step(self) -> float: ...
    @property
    def water_balance(self) -> MassBalance: ...
    @property
    def water_depth(self) -> NDArray[Any]: ...
    @property
    def wear(self) -> NDArray[Any]: ...

class ReliefGrowth:
    @property
    def drainage_area(self) -> NDArray[Any]: ...
    @property
    def elevation(self) -> NDArray[Any]: ...
    @property
    def erodibility(self) -> NDArray[Any]: ...
    @property
    def uplift_rate(self) -> NDArray[Any]: ...

class SlippageResult:
    @property
    def elevation(self) -> NDArray[Any]: ...
    @property
    def sediment_thickness(self) -> NDArray[Any]: ...
    @property
    def steepest_excess(self) -> float: ...
    @property
    def sweeps(self) -> int: ...

class Tin:
    def __len__(self) -> int: ...
    @property
    def cell_areas(self) -> NDArray[Any]: ...
    @property
    def edge_lengths(self) -> NDArray[Any]: ...
    @property
    def first_edge(self) -> NDArray[Any]: ...
    @staticmethod
    def from_points(points: Any, size: tuple[float, float], origin: tuple[float, float] = (0.0, 0.0)) -> Tin: ...
    @staticmethod
    def grid(shape: tuple[int, int], cell_size: float, origin: tuple[float, float] = (0.0, 0.0)) -> Tin: ...
    @staticmethod
    def jittered(size: tuple[float, float], spacing: float, seed: int = 0, origin: tuple[float, float] = (0.0, 0.0)) -> Tin: ...
    @property
    def neighbors(self) -> NDArray[Any]: ...
    @property
    def points(self) -> NDArray[Any]: ...
    @staticmethod
    def poisson(size: tuple[float, float], spacing: float, seed: int = 0, origin: tuple[float, float] = (0.0, 0.0)) -> Tin: ...
    def sample_at(self, field: Any, points: Any) -> NDArray[Any]: ...
    def sample_to_grid(self, field: Any, grid: Grid) -> NDArray[Any]: ...
    @property
    def sides(self) -> NDArray[Any]: ...
    @property
    def triangles(self) -> NDArray[Any]: ...

def creep(
    elevation: ArrayLike,
    base_level: ArrayLike,
    cell_size: float,
    years: float,
    threads: int = 0,
    *,
    diffusivity: float = ...,
    critical_slope: float = ...,
) -> tuple[Any, ...]: ...

def erode_stream_power(
    elevation: ArrayLike,
    base_level: ArrayLike,
    cell_size: float,
    uplift_rate: float | ArrayLike = 0.0005,
    erodibility: float | ArrayLike = 5.5e-07,
    threads: int = 0,
    *,
    area_exponent: float = ...,
    slope_exponent: float = ...,
    minimum_drainage_area: float = ...,
    area_floor: Literal['maximum', 'sum'] = ...,
    deposition_coefficient: float = ...,
    deposition_iterations: int = ...,
    fill_lakes: bool = ...,
    step_years: float = ...,
    steps: int = ...,
) -> tuple[Any, ...]: ...

def erode_stream_power_tin(
    tin: Tin,
    elevation: ArrayLike,
    base_level: ArrayLike,
    dt_years: float,
    steps: int = 1,
    uplift_rate: float | ArrayLike = 0.0005,
    erodibility: float | ArrayLike = 5.5e-07,
    rain_weight: float | ArrayLike = 1.0,
    talus_slope: float | ArrayLike | None = None,
    threads: int = 0,
    *,
    area_exponent: float = ...,
    slope_exponent: float = ...,
    minimum_drainage_area: float = ...,
    deposition_coefficient: float = ...,
    deposition_iterations: int = ...,
    fill_lakes: bool = ...,
) -> tuple[Any, ...]: ...

def erode_virtual_pipes(
    elevation: ArrayLike,
    cell_size: float,
    land: ArrayLike | None = None,
    moisture: ArrayLike | None = None,
    temperature: ArrayLike | None = None,
    water_depth: ArrayLike | None = None,
    sources: sequence of (x, y, discharge) = (),
    progress: Callable[[str, float], bool | None] | None = None,
    threads: int = 0,
    *,
    duration: float = ...,
    time_step: float = ...,
    pipe_depth: float = ...,
    drag_coefficient: float = ...,
    gravity: float = ...,
    rain_rate_mm_per_h: float = ...,
    random_rain: bool = ...,
    drop_probability: float = ...,
    evaporation_rate: float = ...,
    sediment_capacity: float = ...,
    capacity_law: Literal['stream_power', 'discharge', 'velocity'] = ...,
    bed_slope: Literal['gradient', 'steepest'] = ...,
    min_slope: float = ...,
    max_slope: float = ...,
    sediment_dissolution_rate: float = ...,
    rock_dissolution_rate: float = ...,
    deposition_rate: float = ...,
    erosion_halving_depth: float = ...,
    deposition_halving_depth: float = ...,
    max_change: float = ...,
    limit_to_neighbours: bool = ...,
    sediment_talus_angle_deg: float = ...,
    rock_talus_angle_deg: float = ...,
    slippage_interval: int = ...,
    transport: Literal['conservative', 'semi_lagrangian'] = ...,
    open_sides: bool = ...,
    sea_keeps_sediment: bool = ...,
    settle_at_end: bool = ...,
    seed: int = ...,
) -> PipeErosionResult: ...

def grow_relief(
    map: VectorMap,
    combined_relief: ArrayLike,
    land: ArrayLike,
    beds: RiverBeds,
    progress: Callable[[str, float], bool | None] | None = None,
    seed: int = 0,
    threads: int = 0,
    *,
    coarsest_cells: int = ...,
    coarse_steps: int = ...,
    middle_steps: int = ...,
    finest_steps: int = ...,
    fit_radius: float = ...,
    peak_reach: float = ...,
    fit_rate: float = ...,
    area_exponent: float = ...,
    erodibility: float = ...,
    erodibility_variation: float = ...,
    rock_roughness: float = ...,
    rock_wavelength: float = ...,
    fold_hardness: float = ...,
    uplift_variation: float = ...,
    uplift_wavelength: float = ...,
    hillslope_area: float = ...,
    plain_area: float = ...,
    range_relief: float = ...,
    range_reach: float = ...,
    talus_angle_deg: float = ...,
    bed_area_factor: float = ...,
    creep_length: float = ...,
) -> ReliefGrowth: ...

def landslide(
    elevation: ArrayLike,
    base_level: ArrayLike,
    cell_size: float,
    talus_angle_deg: float,
    years: float,
    threads: int = 0,
    *,
    landslide_rate: float = ...,
    rounds: int = ...,
) -> tuple[Any, ...]: ...

def paper_b_setting(
    cell_size: float,
    height_unit: float,
    units: float = 10.0,
) -> dict: ...

def slip_sediment(
    rock_elevation: ArrayLike,
    sediment_thickness: ArrayLike,
    cell_size: float,
    threads: int = 0,
    *,
    sediment_talus_angle_deg: float = ...,
    max_sweeps: int = ...,
) -> SlippageResult: ...
