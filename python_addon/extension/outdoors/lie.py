"""How the high ground of a terrain lies, in local units: where its middle is, which way it runs."""

from dataclasses import dataclass

import numpy as np


@dataclass
class Lie:
    middle: np.ndarray  # (2,)
    axis: np.ndarray  # (2,): along the range, to the right for whoever looks from `front`
    front: np.ndarray  # (2,): across the range, to the south
    width: float  # four standard deviations, across
    length: float  # the same, along
    base: float  # of the heights
    top: float


def of(terrain):
    points = np.empty((len(terrain.data.vertices), 3), np.float32)
    terrain.data.attributes["position"].data.foreach_get("vector", points.ravel())
    return of_points(points.astype(float))


def of_points(points):
    low, top = np.percentile(points[:, 2], (5.0, 99.9))
    base = max(low, 0.0) if top > 0.0 else low
    weight = np.maximum(points[:, 2] - base, 0.0) + 1e-6
    middle = np.average(points[:, :2], axis=0, weights=weight)
    values, vectors = np.linalg.eigh(np.cov(points[:, :2].T, aweights=weight))
    front = vectors[:, 0] * (-1.0 if vectors[1, 0] > 0.0 else 1.0)
    axis = np.array([-front[1], front[0]])
    width, length = 4.0 * np.sqrt(np.maximum(values, 1e-12))
    return Lie(middle, axis, front, width, length, base, top)
