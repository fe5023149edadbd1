"""Lines on the ground as curves: traces of horizons, folds, rivers."""

import bpy

from ..mesh import line_objects
from .product_operator import ProductOperator, RocksOperator


class LinesOperator:
    def take(self, context, terrain, result):
        line_objects.write(terrain, self.kind, result.meshes())


class OROGEN_OT_add_traces(LinesOperator, RocksOperator, bpy.types.Operator):
    """Add the lines along which the tops of the layers come to light, as curves"""

    bl_idname = "orogen.add_traces"
    bl_label = "Add Traces of Horizons"
    kind = "traces"


class OROGEN_OT_add_folds(LinesOperator, ProductOperator, bpy.types.Operator):
    """Add the crests and troughs of the layers that folded, laid on the ground, as curves"""

    bl_idname = "orogen.add_folds"
    bl_label = "Add Fold Lines"
    kind = "folds"


class OROGEN_OT_add_rivers(LinesOperator, ProductOperator, bpy.types.Operator):
    """Add the network of rivers as curves"""

    bl_idname = "orogen.add_rivers"
    bl_label = "Add Rivers"
    kind = "rivers"

    least_area: bpy.props.FloatProperty(
        name="Least Area (km²)",
        description="Rivers begin where so much land drains",
        default=5.0,
        min=0.001,
        max=1e6,
    )

    def wishes(self, context, terrain):
        return {"least_area_m2": self.least_area * 1e6}
