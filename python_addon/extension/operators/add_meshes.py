"""A terrain's ground as other meshes: tiles, coarser copies, a closed body, triangles, with UVs.

The terrain's own mesh stays as it is; these are children of it.
"""

import bpy

from .. import terrains
from ..mesh import large_ground, tiles, uv
from ..mesh.terrain_mesh import NotNow
from ..properties.session import tell
from .product_operator import ProductOperator

SKIRT = bpy.props.FloatProperty(
    name="Skirt (m)",
    description="Walls at the borders down to so far below the lowest ground. 0: none",
    default=0.0,
    min=0.0,
    max=1e5,
)


class GroundOperator:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        if terrain is not None and large_ground.is_tiled(terrain):
            cls.poll_message_set(large_ground.TOO_LARGE)
            return False
        cls.poll_message_set("Grow a terrain first, in object mode")
        return context.mode == "OBJECT" and terrain is not None and "orogen_grid" in terrain.data

    def execute(self, context):
        try:
            self.make(terrains.active(context))
        except NotNow as error:
            tell(context, str(error), is_error=True)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class OROGEN_OT_split_tiles(GroundOperator, bpy.types.Operator):
    """Cut the ground into tiles, children of the terrain, whose borders fit to the bit"""

    bl_idname = "orogen.split_tiles"
    bl_label = "Split into Tiles"

    count: bpy.props.IntProperty(
        name="Tiles a Side", description="So many times so many", default=2, min=1, max=64
    )
    skirt: SKIRT

    def make(self, terrain):
        tiles.split(terrain, self.count, self.skirt)


class OROGEN_OT_add_lods(GroundOperator, bpy.types.Operator):
    """Add coarser copies of the ground, children of the terrain: of every 2nd, 4th ... vertex"""

    bl_idname = "orogen.add_lods"
    bl_label = "Add Levels of Detail"

    levels: bpy.props.IntProperty(
        name="Levels", description="How many coarser copies", default=3, min=1, max=10
    )
    skirt: SKIRT

    def make(self, terrain):
        tiles.make_coarser(terrain, self.levels, self.skirt)


class OROGEN_OT_add_solid(GroundOperator, bpy.types.Operator):
    """Add the ground as a closed body with walls and a floor, to be printed"""

    bl_idname = "orogen.add_solid"
    bl_label = "Add Solid"

    depth: bpy.props.FloatProperty(
        name="Depth (m)",
        description="Of the floor below the lowest ground",
        default=500.0,
        min=1.0,
        max=1e5,
    )

    def make(self, terrain):
        tiles.close(terrain, self.depth)


class OROGEN_OT_add_decimated(GroundOperator, bpy.types.Operator):
    """Add the ground with fewer faces where it is smooth: its own mesh under a Decimate modifier,
    which follows the terrain"""

    bl_idname = "orogen.add_decimated"
    bl_label = "Add Decimated"

    ratio: bpy.props.FloatProperty(
        name="Ratio",
        description="Share of the faces that is left",
        default=0.1,
        min=0.001,
        max=1.0,
        subtype="FACTOR",
    )

    def make(self, terrain):
        tiles.decimate(terrain, self.ratio)


class OROGEN_OT_add_uv(GroundOperator, bpy.types.Operator):
    """Give the terrain's mesh UVs over the map: a picture with a pixel a cell fits. Another
    resolution takes them away"""

    bl_idname = "orogen.add_uv"
    bl_label = "Add UV Map"

    def make(self, terrain):
        uv.write(terrain.data, uv.of_grid(*terrain.data["orogen_grid"]))


class OROGEN_OT_add_tin(ProductOperator, bpy.types.Operator):
    """Add the triangles that mountains between colliding plates grew on, as they are"""

    bl_idname = "orogen.add_tin"
    bl_label = "Add Triangles"
    kind = "tin"

    def take(self, context, terrain, result):
        tiles.triangulate(terrain, result.meshes()["tin"])
