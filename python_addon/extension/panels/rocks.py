"""Layers of rock, how the ground shows them, what lies below; and the animation of growth."""

import bpy

from .. import terrains
from ..mesh.attributes import STRATA_COLOR
from .tab import TerrainTab, property_layout


class OROGEN_PT_rocks(TerrainTab, bpy.types.Panel):
    bl_label = "Rocks"

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and STRATA_COLOR in terrain.data.attributes

    def draw(self, context):
        layout = property_layout(self)
        settings = terrains.active(context).orogen
        layout.prop(settings, "strata")
        layout.prop(settings, "bare_rock")
        column = layout.column(align=True)
        column.operator("orogen.add_block", icon="MESH_CUBE")
        column.operator("orogen.add_section", icon="MESH_GRID")
        column.operator("orogen.add_horizons", icon="MOD_OCEAN")
        column.operator("orogen.add_traces", icon="IPO_EASE_IN_OUT")
        column.operator("orogen.add_folds", icon="CURVE_PATH")
        column.operator("orogen.add_volume", icon="OUTLINER_OB_VOLUME")
        column = layout.column(align=True)
        column.operator("orogen.add_section_picture", icon="IMAGE_DATA")
        column.operator("orogen.export_section", icon="EXPORT")


class OROGEN_PT_growth(TerrainTab, bpy.types.Panel):
    bl_label = "Animation of Growth"

    @classmethod
    def poll(cls, context):
        return bpy.ops.orogen.animate_growth.poll()

    def draw(self, context):
        layout = property_layout(self)
        settings = terrains.active(context).orogen
        layout.prop(settings, "growth_frames")
        layout.prop(settings, "growth_step")
        animate = layout.operator("orogen.animate_growth", icon="RENDER_ANIMATION")
        animate.frames, animate.step = settings.growth_frames, settings.growth_step
        keep = layout.operator("orogen.keep_growth", icon="FILE_TICK")
        keep.frames, keep.step = settings.growth_frames, settings.growth_step
