"""The folds of the layers, and what was changed in them by hand."""

import bpy

from .. import terrains
from ..fold_edits import STAGE, objects_of
from .stages import GroupPanel


class OROGEN_PT_folds(GroupPanel, bpy.types.Panel):
    bl_label = group = "Folds"

    def draw(self, context):
        layout, terrain = self.layout, terrains.active(context)
        if STAGE not in terrain.orogen.stage_names():
            return
        edited = objects_of(terrain)
        row = layout.row(align=True)
        text = "Renew Meshes" if edited else "Edit Folds"
        row.operator("orogen.edit_folds", text=text, icon="EDITMODE_HLT")
        if edited:
            row.operator("orogen.clear_fold_edits", text="", icon="X")
            layout.label(text="Edit the meshes, then Grow", icon="INFO")
        elif not bpy.ops.orogen.edit_folds.poll():
            layout.label(text="Grow the terrain first", icon="INFO")
            layout.operator("orogen.grow", icon="RNDCURVE")
