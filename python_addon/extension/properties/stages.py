"""One property group per stage, made from the declarations."""

import struct

import bpy

from ..declarations import STAGES
from ..titles import title


def make_property(parameter):
    texts = {"name": parameter.label, "description": parameter.tooltip}
    if parameter.type == "bool":
        return bpy.props.BoolProperty(default=parameter.default, **texts)
    if parameter.type == "choice":
        items = [(name, title(name), "") for name in parameter.choices]
        return bpy.props.EnumProperty(items=items, default=parameter.default, **texts)
    limits = {"default": parameter.default, "min": parameter.min, "max": parameter.max}
    if parameter.type == "int":
        return bpy.props.IntProperty(**{k: int(v) for k, v in limits.items()}, **texts)
    shown = {key: value / parameter.scale for key, value in limits.items()}
    digits = 1 if abs(shown["default"]) >= 100 else 3
    return bpy.props.FloatProperty(**shown, precision=digits, step=100 / 10**digits, **texts)


def value_of(group, parameter):
    """The value as the core takes it. A number is the shortest decimal that Blender's float32
    stands for, so that 0.35 is 0.35 here, on the command line and in Python alike."""
    value = getattr(group, parameter.name)
    if parameter.type != "float":
        return value
    if value == as_float32(parameter.default / parameter.scale):
        return parameter.default
    exact = float(f"{value:.7g}") * parameter.scale
    exact = float(f"{exact:.9g}")
    return min(max(exact, parameter.min), parameter.max)


def set_value(group, parameter, value):
    setattr(group, parameter.name, value / parameter.scale if parameter.type == "float" else value)


def as_float32(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def group_of(stage):
    annotations = {p.name: make_property(p) for p in stage.parameters}
    return type(
        f"OROGEN_PG_stage_{stage.name}",
        (bpy.types.PropertyGroup,),
        {"__doc__": stage.text, "__annotations__": annotations, "__module__": __name__},
    )


GROUPS = tuple(group_of(stage) for stage in STAGES)

OROGEN_PG_stages = type(
    "OROGEN_PG_stages",
    (bpy.types.PropertyGroup,),
    {
        "__doc__": "The parameters of every stage.",
        "__module__": __name__,
        "__annotations__": {
            stage.name: bpy.props.PointerProperty(type=group)
            for stage, group in zip(STAGES, GROUPS, strict=True)
        },
    },
)
