"""Heights of the scene to start from."""

import bpy

KINDS = (
    ("OBJECT", "Mesh", "The highest ground of a mesh object"),
    ("IMAGE", "Image", "An image over the frame: black is low, white is high"),
)


def is_mesh(_self, ob):
    return ob.type == "MESH" and not ob.orogen.is_terrain


class OROGEN_PG_ground(bpy.types.PropertyGroup):
    kind: bpy.props.EnumProperty(
        name="Heights", description="What gives the heights to start from", items=KINDS
    )
    object: bpy.props.PointerProperty(
        name="Mesh",
        description="A mesh of the scene, seen from above",
        type=bpy.types.Object,
        poll=is_mesh,
    )
    image: bpy.props.PointerProperty(
        name="Image",
        description="A height map; its colour space is best set to Non-Color",
        type=bpy.types.Image,
    )
    black: bpy.props.FloatProperty(
        name="Black (m)", description="Height of black", default=0.0, min=-12000.0, max=12000.0
    )
    white: bpy.props.FloatProperty(
        name="White (m)", description="Height of white", default=2000.0, min=-12000.0, max=12000.0
    )
