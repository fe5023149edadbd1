# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

def classify_biomes(
    warmth: ArrayLike,
    water: ArrayLike,
    classification: Literal['paper', 'whittaker', 'holdridge'] = 'paper',
) -> NDArray[np.int32]: ...

def orographic_rain(
    elevation: ArrayLike,
    cell_size: float,
    threads: int = 0,
    *,
    wind_from_deg: float = ...,
    wind_speed: float = ...,
    background_rain: float = ...,
    storm_share: float = ...,
    uplift_sensitivity: float = ...,
    moist_layer: float = ...,
    moist_stability: float = ...,
    conversion_time: float = ...,
    fallout_time: float = ...,
) -> NDArray[np.float32]: ...
