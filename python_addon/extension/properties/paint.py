"""What is painted on a terrain, and the ground that is to stay."""

import bpy

from ..declarations import BIOMES
from ..mesh import biome_paint

METHODS = (
    ("NONE", "None", "Nothing is painted"),
    ("IMAGE", "Image", "An image over the terrain: it keeps its detail whatever the resolution"),
    ("VERTEX", "Vertices", "A colour attribute of the terrain's mesh"),
)


class OROGEN_PG_paint(bpy.types.PropertyGroup):
    """One layer of paint: grey changes nothing."""

    method: bpy.props.EnumProperty(
        name="Paint", description="Where the paint is kept", items=METHODS
    )
    image: bpy.props.PointerProperty(
        name="Image", description="The paint, over the whole terrain", type=bpy.types.Image
    )
    strength: bpy.props.FloatProperty(
        name="Strength",
        description="What white multiplies by, and black divides by",
        default=2.0,
        min=1.0,
        max=10.0,
    )


class OROGEN_PG_polygon_edit(bpy.types.PropertyGroup):
    """A change of one polygon of an island, which stays where it was made."""

    layer: bpy.props.StringProperty(description="A layer of paint of islands")
    change: bpy.props.FloatProperty(description="What is added")
    ring: bpy.props.StringProperty(
        description="JSON of the polygon's corners, metres on the terrain's plane"
    )


class OROGEN_PG_paints(bpy.types.PropertyGroup):
    uplift: bpy.props.PointerProperty(type=OROGEN_PG_paint)
    hardness: bpy.props.PointerProperty(type=OROGEN_PG_paint)
    height: bpy.props.PointerProperty(type=OROGEN_PG_paint)
    warmth: bpy.props.PointerProperty(type=OROGEN_PG_paint)
    moisture: bpy.props.PointerProperty(type=OROGEN_PG_paint)
    biome: bpy.props.PointerProperty(type=OROGEN_PG_paint)
    biome_brush: bpy.props.EnumProperty(
        name="Brush",
        description="The biome that is painted",
        items=[
            ("NONE", "None", "Takes paint away"),
            *((b.name, b.label, "") for b in BIOMES if b.name not in biome_paint.WATER),
        ],
        default=BIOMES[8].name,
        update=lambda self, context: biome_paint.set_brush(context, self.biome_brush),
    )
    keep: bpy.props.PointerProperty(type=OROGEN_PG_paint)
    polygons: bpy.props.CollectionProperty(type=OROGEN_PG_polygon_edit)
    keep_object: bpy.props.PointerProperty(
        name="Area",
        description="A mesh whose outline from above is kept too",
        type=bpy.types.Object,
        poll=lambda _self, ob: ob.type == "MESH" and not ob.orogen.is_terrain,
    )
    freeze: bpy.props.BoolProperty(
        name="Freeze",
        description="Keep the ground where it is painted white, or an object lies over it, while"
        " the rest grows anew",
    )
