"""The rocks below a terrain as meshes: block diagram, sections, horizons."""

import bpy

from ..mesh import rock_objects
from ..scene import section_line
from .product_operator import RocksOperator

BEARING = bpy.props.FloatProperty(
    name="Bearing",
    description="Direction of the straight section, clockwise from the terrain's north (+Y)",
    subtype="ANGLE",
    min=-6.3,
    max=6.3,
)


class RockMeshOperator(RocksOperator):
    def take(self, context, terrain, result):
        rock_objects.write(terrain, self.kind, result.meshes())


class OROGEN_OT_add_block(RockMeshOperator, bpy.types.Operator):
    """Add the block below the terrain: its layers on four walls, and a base"""

    bl_idname = "orogen.add_block"
    bl_label = "Add Block Diagram"
    kind = "block"

    top: bpy.props.BoolProperty(
        name="With Ground",
        description="Close the block above, as a body of its own. Else the terrain is its surface",
    )

    def wishes(self, context, terrain):
        return {"top": self.top}


class OROGEN_OT_add_section(RockMeshOperator, bpy.types.Operator):
    """Add a section through the rocks: along the selected curve or grease-pencil stroke, else
    straight through the 3D cursor, or the middle where that lies elsewhere"""

    bl_idname = "orogen.add_section"
    bl_label = "Add Section"
    kind = "section"

    bearing: BEARING

    def wishes(self, context, terrain):
        return {"line": section_line.find(context, terrain, self.bearing)}


class OROGEN_OT_add_horizons(RockMeshOperator, bpy.types.Operator):
    """Add the tops of the layers of rock, where they lie below ground"""

    bl_idname = "orogen.add_horizons"
    bl_label = "Add Horizons"
    kind = "horizons"
