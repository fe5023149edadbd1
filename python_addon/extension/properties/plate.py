"""What makes a collection a moving plate. It lives on the collection."""

import bpy

CRUSTS = (
    ("continental", "Continental", "Thick and light: it folds and rises"),
    ("oceanic", "Oceanic", "It dives below another plate: a trench before it, an arc behind"),
)


class OROGEN_PG_plate(bpy.types.PropertyGroup):
    is_plate: bpy.props.BoolProperty(options={"HIDDEN"})
    stable: bpy.props.BoolProperty(
        name="Stable",
        description="The fault lies on this plate's side. If no plate is: on the slowest one's",
    )
    crust: bpy.props.EnumProperty(
        name="Crust", description="What the plate is made of", items=CRUSTS
    )
    color: bpy.props.FloatVectorProperty(
        name="Color",
        description="Of the plate's arrows and outline in the viewport",
        subtype="COLOR",
        size=3,
        min=0.0,
        max=1.0,
        default=(0.9, 0.45, 0.15),
    )
