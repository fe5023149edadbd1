"""Folds that are edited as meshes."""

import bpy

from .. import terrains
from ..fold_edits import STAGE, objects_of
from ..mesh import fold_objects, terrain_mesh
from .product_operator import ProductOperator


class OROGEN_OT_edit_folds(ProductOperator, bpy.types.Operator):
    """Put the crests of the terrain's folds into the scene, a mesh each layer, as high as the layer
    folds. Delete edges, draw new ones, move vertices up or down: the next Grow follows"""

    bl_idname = "orogen.edit_folds"
    bl_label = "Edit Folds"
    bl_options = {"REGISTER", "UNDO"}
    kind = "fold_edges"

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Grow a terrain whose layers fold first, and leave Edit Mode")
        terrain = terrains.own(context)
        return (
            context.mode == "OBJECT"
            and terrain is not None
            and f'"{STAGE}"' in terrain.data.get(terrain_mesh.RECIPE, "")
        )

    def take(self, context, terrain, result):
        fold_objects.write(terrain, result.meshes())


class OROGEN_OT_clear_fold_edits(bpy.types.Operator):
    """Forget what was changed in the terrain's folds, and take their meshes away"""

    bl_idname = "orogen.clear_fold_edits"
    bl_label = "Clear Fold Edits"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        terrain = terrains.own(context)
        return context.mode == "OBJECT" and terrain is not None and bool(objects_of(terrain))

    def execute(self, context):
        terrain = terrains.own(context)
        terrains.activate(context, terrain)
        fold_objects.clear(terrain)
        return {"FINISHED"}
