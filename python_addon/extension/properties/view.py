"""What a terrain's ground shows in the viewport: its natural look, or one of its fields."""

import bpy

from ..view import fields

SCALES = (
    ("AUTO", "Automatic", "Two-sided where numbers lie on both sides of 0, else one that suits"),
    ("VIRIDIS", "Viridis", "From dark violet to yellow"),
    ("CIVIDIS", "Cividis", "From dark blue to yellow"),
    ("BATLOW", "Batlow", "From dark blue over olive to pink"),
    ("VIK", "Vik", "Blue and brown on both sides of the middle"),
    ("OLERON", "Oleron", "Sea and land on both sides of the middle"),
)


def field_items():
    """Their numbers in a .blend are hashes of the names: fields may come and go."""
    from ..examples import number

    items = [("MATERIAL", "Natural Look", "The ground's own material", "MATERIAL", 0)]
    items += [
        (field.name, field.label, field.description.rstrip("."), "NONE", number(field.name))
        for field in fields.known().values()
    ]
    return items


def refresh(self, _context):
    from ..view import show

    show.refresh(self.id_data)


def refresh_by_hand(self, context):
    if not self.automatic:
        refresh(self, context)


def change_field(self, context):
    from ..view import show

    refresh(self, context)
    show.in_solid_view(context, self.field != show.NATURAL)


class OROGEN_PG_view(bpy.types.PropertyGroup):
    field: bpy.props.EnumProperty(
        name="Show",
        items=field_items(),
        description="What the ground's colours tell. Solid viewports show it too",
        update=change_field,
    )
    scale: bpy.props.EnumProperty(
        name="Colours",
        items=SCALES,
        description="All can be read by the colour-blind",
        update=refresh,
    )
    automatic: bpy.props.BoolProperty(
        name="Automatic Range",
        description="Colours span the middle 96 % of the ground's numbers",
        default=True,
        update=refresh,
    )
    low: bpy.props.FloatProperty(
        name="From", description="Where the colours begin", precision=3, update=refresh_by_hand
    )
    high: bpy.props.FloatProperty(
        name="To", description="Where the colours end", precision=3, update=refresh_by_hand
    )
    legend: bpy.props.BoolProperty(
        name="Legend", description="Explain the colours in the viewport", default=True
    )
    own_material: bpy.props.PointerProperty(
        type=bpy.types.Material, options={"HIDDEN"}
    )  # the object's own, kept while a field is shown
