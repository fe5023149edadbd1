"""Heights of the scene, or of a file, to start from or to grow towards."""

import bpy

KINDS = (
    ("OBJECT", "Mesh", "The highest ground of a mesh object"),
    ("IMAGE", "Image", "An image over the frame: black is low, white is high"),
)


USES = (
    ("START", "Start From", "Rivers cut into the heights as they are"),
    (
        "TOWARDS",
        "Grow Towards",
        "Mountains rise until they stand at large where the heights do, with valleys of their own",
    ),
)


def notice_stages(self, _context):
    from .. import settings_recipe

    settings_recipe.notice_stages(self.id_data.orogen)


def is_mesh(_self, ob):
    return ob.type == "MESH" and not ob.orogen.is_terrain


class OROGEN_PG_ground(bpy.types.PropertyGroup):
    use: bpy.props.EnumProperty(
        name="Use",
        description="What the heights are for",
        items=USES,
        update=notice_stages,
    )
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
