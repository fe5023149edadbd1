"""What makes an empty a spring, and its numbers. They live on the object."""

import bpy

from ..declarations import SPRING_NUMBERS
from .stages import make_property, set_value, value_of


class SpringNumbers:
    """What the settings of a spring can do."""

    def numbers(self):
        """As a recipe has them."""
        return {p.name: value_of(self, p) for p in SPRING_NUMBERS}

    def take(self, numbers):
        for p in SPRING_NUMBERS:
            set_value(self, p, numbers[p.name])


OROGEN_PG_spring = type(
    "OROGEN_PG_spring",
    (SpringNumbers, bpy.types.PropertyGroup),
    {
        "__doc__": "A spring.",
        "__module__": __name__,
        "__annotations__": {
            "is_spring": bpy.props.BoolProperty(options={"HIDDEN"}),
            **{p.name: make_property(p) for p in SPRING_NUMBERS},
        },
    },
)
