"""What makes a curve object a feature curve, and its numbers. They live on the object.

`points` are the same numbers of the control points that are selected in edit mode; they are kept in
custom properties of the object, lists by name (scene/feature_curves.py).
"""

import math

import bpy
import numpy as np

from ..feature_curves import ANGLES, KINDS, NUMBERS
from ..scene.curves import controls
from ..scene.feature_curves import HEIGHT, control_numbers, own_numbers

TEXTS = {
    "plateau": ("Half Width", "Half the width of the flat top, or of a valley's floor"),
    "slope_size": ("Width", "How far the slope reaches from the flat top. 0: no slope"),
    "slope_angle": ("Angle (°)", "Above 0 ground falls away from the curve, below 0 it rises"),
    "envelope": ("Blend", "How far beyond the slope ground is blended into what was there"),
}
WIDEST = 1e6  # m


def _tell(self, _context):
    """A script that sets a number is noticed as a hand is."""
    self.id_data.update_tag()


def _declared(name, **more):
    kind = name.removesuffix("_left").removesuffix("_right")
    label, text = TEXTS[kind]
    if name in ANGLES:
        limits = {"min": -89.0, "max": 89.0, "step": 100, "precision": 1}
    else:
        limits = {"min": 0.0, "max": WIDEST, "soft_max": 20e3, "step": 1000, "precision": 0}
        label += " (m)"
    return bpy.props.FloatProperty(name=label, description=text, **limits, **more)


def selected(ob):
    """Which of a curve object's control points are selected."""
    return np.array(
        [
            getattr(point, "select_control_point" if spline.type == "BEZIER" else "select")
            for spline in ob.data.splines
            for point in controls(spline)
        ],
        bool,
    )


def _getter(name):
    def get(self):
        ob = self.id_data
        chosen = selected(ob)
        values = control_numbers(ob)[name]
        return float(values[chosen].mean()) if chosen.any() else 0.0

    return get


def _setter(name):
    def set_(self, value):
        ob = self.id_data
        chosen = selected(ob)
        own = own_numbers(ob, name, len(chosen)) or [math.nan] * len(chosen)
        ob[name] = np.where(chosen, float(value), own).tolist()
        ob.update_tag()

    return set_


OROGEN_PG_feature_points = type(
    "OROGEN_PG_feature_points",
    (bpy.types.PropertyGroup,),
    {
        "__doc__": "Numbers of the selected control points.",
        "__module__": __name__,
        "__annotations__": {
            **{
                name: _declared(name, get=_getter(name), set=_setter(name), options={"SKIP_SAVE"})
                for name in NUMBERS
            },
            HEIGHT: bpy.props.BoolProperty(
                name="Hold Height",
                description="The ground comes to lie as high as these points",
                get=lambda self: _getter(HEIGHT)(self) >= 0.5,
                set=_setter(HEIGHT),
                options={"SKIP_SAVE"},
            ),
        },
    },
)


class FeatureNumbers:
    """What the settings of a feature curve can do."""

    def number(self, name):
        """A number of the whole curve; the left side's for both where they are alike."""
        if self.alike and name.endswith("_right"):
            name = name.removesuffix("right") + "left"
        return getattr(self, name)

    def take(self, kind, side):
        """The usual numbers of a kind on a terrain whose longer side is `side` metres."""
        numbers = KINDS[kind].numbers(side)
        self.is_feature, self.elevation = True, True
        for name, value in numbers.items():
            setattr(self, name, value)
        left = [numbers[name] for name in NUMBERS if name.endswith("_left")]
        right = [numbers[name] for name in NUMBERS if name.endswith("_right")]
        self.alike = left == right


OROGEN_PG_feature = type(
    "OROGEN_PG_feature",
    (FeatureNumbers, bpy.types.PropertyGroup),
    {
        "__doc__": "A feature curve.",
        "__module__": __name__,
        "__annotations__": {
            "is_feature": bpy.props.BoolProperty(
                name="Feature Curve", description="Ground is bent to this curve", update=_tell
            ),
            HEIGHT: bpy.props.BoolProperty(
                name="Hold Height",
                description="The ground comes to lie as high as the curve. Otherwise its slopes"
                " hang on the ground around them",
                default=True,
                update=_tell,
            ),
            "alike": bpy.props.BoolProperty(
                name="Both Sides Alike",
                description="One slope for both sides; else left and right as seen along the curve",
                default=True,
                update=_tell,
            ),
            **{name: _declared(name, update=_tell) for name in NUMBERS},
            "points": bpy.props.PointerProperty(type=OROGEN_PG_feature_points),
        },
    },
)
