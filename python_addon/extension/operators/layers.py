"""The list of layers of rock."""

import bpy

from .. import column_recipe, terrains
from ..declarations import COLUMNS
from ..examples import number


class LayerOperator:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        terrain = terrains.own(context)
        return terrain is not None and terrain.orogen.column.use_layers

    def column(self, context):
        return terrains.own(context).orogen.column


class OneLayerOperator(LayerOperator):
    @classmethod
    def poll(cls, context):
        return super().poll(context) and terrains.own(context).orogen.column.active() is not None


class OROGEN_OT_add_layer(LayerOperator, bpy.types.Operator):
    """Add a layer of rock above the active one"""

    bl_idname = "orogen.add_layer"
    bl_label = "Add Layer"

    def execute(self, context):
        column = self.column(context)
        column.layers.add()
        at = min(column.active_layer, len(column.layers) - 1)
        column.layers.move(len(column.layers) - 1, at)
        column.active_layer = at
        return {"FINISHED"}


class OROGEN_OT_remove_layer(OneLayerOperator, bpy.types.Operator):
    """Remove the active layer of rock"""

    bl_idname = "orogen.remove_layer"
    bl_label = "Remove Layer"

    def execute(self, context):
        column = self.column(context)
        column.layers.remove(column.active_layer)
        column.active_layer = max(0, min(column.active_layer, len(column.layers) - 1))
        return {"FINISHED"}


class OROGEN_OT_move_layer(OneLayerOperator, bpy.types.Operator):
    """Move the active layer of rock within the list; its top one is the youngest"""

    bl_idname = "orogen.move_layer"
    bl_label = "Move Layer"

    direction: bpy.props.EnumProperty(
        name="Direction",
        description="Where to move it",
        items=(("UP", "Up", "Towards the ground"), ("DOWN", "Down", "Towards the basement")),
    )

    def execute(self, context):
        column = self.column(context)
        to = column.active_layer + (1 if self.direction == "DOWN" else -1)
        if not 0 <= to < len(column.layers):
            return {"CANCELLED"}
        column.layers.move(column.active_layer, to)
        column.active_layer = to
        return {"FINISHED"}


class OROGEN_OT_copy_column(LayerOperator, bpy.types.Operator):
    """Put the layers of a preset into the list, in place of those that it holds"""

    bl_idname = "orogen.copy_column"
    bl_label = "Start from Preset"

    preset: bpy.props.EnumProperty(
        name="Preset",
        description="A column of rock that comes with Orogen",
        items=[(name, name.capitalize(), "", number(name)) for name in COLUMNS],
    )

    def execute(self, context):
        column_recipe.copy_preset(self.column(context), self.preset)
        return {"FINISHED"}
