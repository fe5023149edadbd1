"""Feature curves: kinds, their usual sizes, and how a recipe writes them. No bpy here.

A curve is places in metres on the terrain's plane, with numbers of each place; left and right are
as seen along it. Beside the curve lies its plateau, then a slope, then the envelope in which the
ground is blended into what was there.
"""

import math
from dataclasses import dataclass

import numpy as np

NUMBERS = (
    "plateau",
    "slope_size_left",
    "slope_size_right",
    "slope_angle_left",
    "slope_angle_right",
    "envelope_left",
    "envelope_right",
)
SIDES = ("left", "right")
ANGLES = ("slope_angle_left", "slope_angle_right")
STEEPEST = 89.0  # degrees, as the core allows
FLAT = 1.0  # m: what lies on the plane says nothing of its height


@dataclass(frozen=True)
class Kind:
    """Sizes are shares of the terrain's longer side, angles degrees; above 0 ground falls away from
    the curve."""

    label: str
    text: str
    plateau: float
    slope_size: tuple[float, float]  # left, right
    slope_angle: tuple[float, float]
    envelope: tuple[float, float]
    lift: float  # above the ground that the curve is laid on
    falls: bool = False  # whether it goes downhill all the way, from its higher end

    def heights(self, ground, side):
        """Of a curve over ground of these heights (m) at its points."""
        if self.falls:
            turn = slice(None, None, -1 if ground[0] < ground[-1] else 1)
            ground = np.minimum.accumulate(ground[turn])[turn]
        return ground + self.lift * side

    def numbers(self, side):
        """Those of a terrain whose longer side is `side` metres."""
        values = {"plateau": self.plateau * side}
        for k, name in enumerate(SIDES):
            values[f"slope_size_{name}"] = self.slope_size[k] * side
            values[f"slope_angle_{name}"] = self.slope_angle[k]
            values[f"envelope_{name}"] = self.envelope[k] * side
        return {name: _rounded(value) for name, value in values.items()}


KINDS = {
    "RIDGE": Kind(
        "Ridge",
        "A crest from which the ground falls to both sides",
        *(0.001, (0.02, 0.02), (25.0, 25.0), (0.03, 0.03), 0.009),
    ),
    "VALLEY": Kind(
        "Valley",
        "A flat floor with a slope up on both sides",
        *(0.004, (0.012, 0.012), (-16.0, -16.0), (0.03, 0.03), -0.0035, True),
    ),
    "CLIFF": Kind(
        "Cliff",
        "Ground that breaks off on the right, seen along the curve",
        *(0.004, (0.0, 0.006), (0.0, 60.0), (0.04, 0.02), 0.006),
    ),
    "RIVER_BED": Kind(
        "River Bed",
        "A narrow channel that is cut into the ground",
        *(0.0015, (0.004, 0.004), (-14.0, -14.0), (0.006, 0.006), -0.001, True),
    ),
}
LAYERS = {  # how the names of grease-pencil layers begin
    "ridge": "RIDGE",
    "feature": "RIDGE",
    "valley": "VALLEY",
    "cliff": "CLIFF",
    "river bed": "RIVER_BED",
    "riverbed": "RIVER_BED",
}


def kind_of_layer(name):
    """A key of KINDS, or None."""
    name = name.lower()
    return next((kind for start, kind in LAYERS.items() if name.startswith(start)), None)


@dataclass
class FeatureCurve:
    name: str
    points: np.ndarray  # (n, 3) m
    numbers: dict  # of NUMBERS: (n,) m, degrees
    elevation: np.ndarray  # (n,) whether the height is asked for


def to_recipe(curves, shift=(0.0, 0.0)):
    """The curves as a recipe's `features`, `shift` (m) added to their places."""
    return [{"name": curve.name, "points": _listed(curve, shift)} for curve in curves]


def from_recipe(curve):
    """A FeatureCurve of what a recipe says."""
    points = curve["points"]
    places = np.array([(*point["position"], 0.0)[:3] for point in points], float)
    numbers = {name: np.array([_number(point, name) for point in points]) for name in NUMBERS}
    asked = [point.get("elevation", len(point["position"]) == 3) for point in points]
    return FeatureCurve(curve.get("name", "Feature"), places, numbers, np.array(asked))


def _number(point, name):
    if name == "plateau":
        return float(point.get(name, 0.0))
    name, side = name.rsplit("_", 1)
    key = "slope_angle_deg" if name == "slope_angle" else name
    return float(point.get(side, point.get("sides", {})).get(key, 0.0))


def _listed(curve, shift):
    points = np.round(curve.points + (*shift, 0.0), 2).tolist()
    numbers = {name: np.round(curve.numbers[name], 3).tolist() for name in NUMBERS}
    return [
        {
            "position": point,
            "elevation": bool(curve.elevation[i]),
            "plateau": numbers["plateau"][i],
            **{
                side: {
                    "slope_size": numbers[f"slope_size_{side}"][i],
                    "slope_angle_deg": numbers[f"slope_angle_{side}"][i],
                    "envelope": numbers[f"envelope_{side}"][i],
                }
                for side in SIDES
            },
        }
        for i, point in enumerate(points)
    ]


def shaped(numbers, radius, tilt):
    """Numbers of points with their radius, which widens all sizes, and tilt (radians), which turns
    the profile: the left slope becomes steeper by it, the right one gentler."""
    turn = np.degrees(tilt)
    return {
        name: values + (turn if name.endswith("left") else -turn)
        if name in ANGLES
        else values * radius
        for name, values in numbers.items()
    }


def too_steep(curve):
    """The places of a curve whose slopes have no angle that the core takes."""
    angles = np.abs([curve.numbers[name] for name in ANGLES]).max(axis=0)
    return curve.points[angles > STEEPEST, :2]


def _rounded(value):
    """Two digits: a size for a panel."""
    if value == 0.0:
        return 0.0
    return round(value, 1 - math.floor(math.log10(abs(value))))
