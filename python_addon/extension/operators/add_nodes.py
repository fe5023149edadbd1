"""Children of a terrain that geometry nodes make from its named attributes."""

import bpy
from mathutils import Matrix

from .. import terrains
from ..declarations import FIELDS
from ..material import plain_material
from ..mesh import sea
from ..nodes import group, scatter, water
from .add_meshes import GroundOperator

CONE_COLOUR = (0.02, 0.05, 0.015)


class OROGEN_OT_add_scatter(GroundOperator, bpy.types.Operator):
    """Scatter the other selected object, or cones, over the ground where a field lies within
    bounds: a child with the node group Orogen Scatter by Field"""

    bl_idname = "orogen.add_scatter"
    bl_label = "Scatter by Field"

    field: bpy.props.EnumProperty(
        name="Field",
        items=[(f.name, f.label, f.description.rstrip(".")) for f in FIELDS],
        description="The attribute that says where",
    )
    low: bpy.props.FloatProperty(name="From", description="In the field's unit", default=1.0)
    high: bpy.props.FloatProperty(name="To", description="In the field's unit", default=1e9)
    density: bpy.props.FloatProperty(
        name="Density", description="Instances a square unit", default=20.0, min=0.0
    )

    def execute(self, context):
        terrain = terrains.active(context)
        others = [ob for ob in context.selected_objects if ob != terrain]
        picked = next((ob for ob in others if ob.type in ("MESH", "CURVE", "EMPTY")), None)
        group.add_child(
            terrain,
            "scatter",
            scatter.ensure(),
            Object=picked or _cone(terrain),
            Field=self.field,
            From=self.low,
            To=self.high,
            Density=self.density,
        )
        return {"FINISHED"}


class OROGEN_OT_add_water(GroundOperator, bpy.types.Operator):
    """Add water in the river beds, and a sea up to the coast where the terrain has none: a child
    with the node group Orogen Water Surface"""

    bl_idname = "orogen.add_water"
    bl_label = "Add Water Surface"

    least_area: bpy.props.FloatProperty(
        name="Rivers from (km²)",
        description="So much land drains through a river, at least",
        default=20.0,
        min=0.001,
        max=1e6,
    )
    depth: bpy.props.FloatProperty(
        name="Depth (m)",
        description="How far water stands above its bed",
        default=10.0,
        min=0.0,
        max=1000.0,
    )

    def execute(self, context):
        terrain = terrains.active(context)
        group.add_child(
            terrain,
            "water",
            water.ensure(),
            Depth=self.depth * terrain.orogen.local_scale()[1],
            Sea=not sea.is_shown(terrain),
            **{"Rivers from": self.least_area * 1e6},
        )
        return {"FINISHED"}


def _cone(terrain):
    """A small tree, as it were; out of sight, to be changed by whoever likes."""
    name = "Orogen Cone"
    ob = bpy.data.objects.get(name)
    if ob is None:
        mesh = bpy.data.meshes.new(name)
        rim = [(0.3, 0.0), (0.15, 0.26), (-0.15, 0.26), (-0.3, 0.0), (-0.15, -0.26), (0.15, -0.26)]
        points = [(x, y, 0.0) for x, y in rim] + [(0.0, 0.0, 1.0)]
        mesh.from_pydata(points, [], [(i, (i + 1) % 6, 6) for i in range(6)])
        size = 0.8 * terrain.data["orogen_cell_size"] * terrain.orogen.local_scale()[0]
        mesh.transform(Matrix.Scale(size, 4))
        mesh.materials.append(plain_material.ensure("cone", CONE_COLOUR))
        ob = bpy.data.objects.new(name, mesh)
    return ob
