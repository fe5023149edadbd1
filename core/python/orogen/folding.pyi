# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .tectonics import BoundaryMap
from .tectonics import CompressionField
from .tectonics import PlateMap
from .inputs import VectorMap
from .tectonics import VelocityMap

class FoldLine:
    @property
    def closed(self) -> bool: ...
    @property
    def id(self) -> int: ...
    @property
    def points(self) -> NDArray[Any]: ...

class FoldSkeleton:
    @property
    def bottom(self) -> list[FoldLine]: ...
    @property
    def choice(self) -> NDArray[Any]: ...
    @property
    def edges(self) -> NDArray[Any]: ...
    @property
    def points(self) -> NDArray[Any]: ...
    @property
    def top(self) -> list[FoldLine]: ...

class FoldStatistics:
    @property
    def angle(self) -> typing.Annotated[list[float], "FixedSize(18)"]: ...
    @property
    def ends(self) -> int: ...
    @property
    def joints(self) -> int: ...
    @property
    def mean_length(self) -> float: ...
    @property
    def mean_wavelength(self) -> float: ...
    @property
    def nodes(self) -> int: ...
    @property
    def wavelength(self) -> typing.Annotated[list[float], "FixedSize(30)"]: ...

class FoldedLayer:
    @property
    def edits_without_effect(self) -> list[int]: ...
    @property
    def skeleton(self) -> FoldSkeleton: ...
    @property
    def speed(self) -> NDArray[Any]: ...

def fold_layers(
    field: CompressionField,
    layers: list[dict[str, Any]],
    seed: int = 0,
    threads: int = 0,
    *,
    uplift_rate: float = ...,
    folding_time: float = ...,
    shortest_wavelength: float = ...,
) -> list[FoldedLayer]: ...

def fold_statistics(
    field: CompressionField,
    skeleton: FoldSkeleton,
    fold_wavelength: float | ArrayLike,
) -> FoldStatistics: ...

def warped_folds(
    map: VectorMap,
    plates: PlateMap,
    boundaries: BoundaryMap,
    velocity: VelocityMap,
    seed: int = 0,
    threads: int = 0,
    *,
    fold_wavelength: float = ...,
    octaves: int = ...,
    gain: float = ...,
    folding_time: float = ...,
    warp: Literal['compress', 'paper'] = ...,
    fold_strength: float = ...,
    plain_share: float = ...,
    peak_reach: float = ...,
    massif_radius: float = ...,
    default_peak_height: float = ...,
    rift_depth: float = ...,
    rift_width: float = ...,
    volcano_slope_deg: float = ...,
    crater_radius: float = ...,
    crater_depth: float = ...,
) -> NDArray[np.float32]: ...
