"""The outline of a feature curve for the viewport: plateau, slopes and envelope (paper B, Figs 3 to
5). No bpy here.

Beside each place of the curve lie, across it, the plateau's rim, the slope's foot and the
envelope's border. Rims of a bend that lie inside the reach of another place are left out, so that
lines are those around the whole, as the core draws them.
"""

from dataclasses import dataclass

import numpy as np

from .feature_curves import SIDES

NORMALS = (8, 48)  # fewest and most slope normals of a side
CAP = 8  # pieces of half a turn about an end


@dataclass
class FeatureShape:
    curve: np.ndarray  # (n, 3) places, m
    rims: np.ndarray  # (k, 3): pairs, the plateau's rim
    feet: np.ndarray  # pairs, where slopes end
    normals: np.ndarray  # pairs, from the rim down or up to the foot
    border: np.ndarray  # pairs (k, 2), the envelope's border: it lies on whatever ground there is
    plateau: np.ndarray  # triangles (k, 3) of the plateau


def shape(curve):
    """The shape of a FeatureCurve of two or more points."""
    points, plateau = curve.points, curve.numbers["plateau"]
    places, height = points[:, :2], points[:, 2]
    across = _across(places)
    parts = {name: [] for name in ("rims", "feet", "normals")}
    band, edges = [], []
    for side, sign in zip(SIDES, (1.0, -1.0), strict=True):
        size = curve.numbers[f"slope_size_{side}"]
        fall = size * np.tan(np.radians(np.clip(curve.numbers[f"slope_angle_{side}"], -89, 89)))
        reach = plateau + size
        rim = np.column_stack([places + sign * across * plateau[:, None], height])
        foot = np.column_stack([places + sign * across * reach[:, None], height - fall])
        at = _spread(places, size)
        parts["rims"].append(_line(rim[_clear(places, rim, plateau)]))
        parts["feet"].append(_line(foot[_clear(places, foot, reach) & (size > 0.0)]))
        parts["normals"].append(np.stack([rim[at], foot[at]], axis=1).reshape(-1, 3))
        band.append(rim)
        edges.append(reach + curve.numbers[f"envelope_{side}"])
    return FeatureShape(
        curve=points,
        border=_border(places, across, *edges),
        plateau=_strip(*band),
        **{name: np.concatenate(lines) for name, lines in parts.items()},
    )


def _across(places):
    """Unit vectors to the left of a line at its points."""
    along = np.gradient(places, axis=0)
    length = np.hypot(*along.T)[:, None]
    along = np.where(length > 0.0, along / np.where(length > 0.0, length, 1.0), (1.0, 0.0))
    return np.column_stack([-along[:, 1], along[:, 0]])


def _clear(places, offset, reach):
    """Which offset points lie inside no place's reach."""
    gaps = np.hypot(*(offset[:, None, :2] - places).transpose(2, 0, 1))
    return (gaps >= reach * (1.0 - 1e-3) - 1e-6).all(axis=1)


def _line(points):
    """A line through points, as pairs."""
    return np.repeat(points, 2, axis=0)[1:-1] if len(points) > 1 else points[:0]


def _spread(places, size):
    """Numbers of places from which slope normals go, evenly along the curve."""
    steps = np.hypot(*np.diff(places, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    if not size.any():
        return np.zeros(0, int)
    count = int(np.clip(along[-1] / (0.35 * size.max()), *NORMALS))
    at = np.searchsorted(along, np.linspace(0.0, along[-1], count))
    return np.unique(np.minimum(at, len(places) - 1))


def _border(places, across, left, right):
    """Pairs of places around a line at a distance of its own on each side; about its ends the two
    are blended by the angle."""
    turns = np.linspace(0.0, np.pi, CAP + 1)[1:-1, None]
    share = 0.5 - 0.5 * np.cos(turns)

    def cap(end, outward, first, second):
        onward = np.array([outward[1], -outward[0]])
        turned = np.cos(turns) * outward + np.sin(turns) * onward
        return places[end] + turned * (first[end] * (1.0 - share) + second[end] * share)

    ring = np.concatenate(
        [
            places + across * left[:, None],
            cap(-1, across[-1], left, right),
            (places - across * right[:, None])[::-1],
            cap(0, -across[0], right, left),
        ]
    )
    ring = ring[_clear(places, ring, np.minimum(left, right))]
    return _line(np.concatenate([ring, ring[:1]]))


def _strip(left, right):
    """Triangles between two lines of as many points."""
    a, b, c, d = left[:-1], right[:-1], right[1:], left[1:]
    return np.stack([a, b, c, a, c, d], axis=1).reshape(-1, 3)
