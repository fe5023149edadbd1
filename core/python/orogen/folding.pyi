# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from .tectonics import BoundaryMap
from .tectonics import PlateMap
from .inputs import VectorMap
from .tectonics import VelocityMap

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
