"""Layers of rock, how the ground shows them, what lies below; and the animation of growth."""

import bpy

from .. import terrains
from ..mesh.terrain_mesh import RECIPE
from .tab import TerrainTab, property_layout


class OROGEN_PT_rocks(TerrainTab, bpy.types.Panel):
    bl_label = "Rocks"

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and RECIPE in terrain.data

    def draw(self, context):
        layout = property_layout(self)
        settings = terrains.active(context).orogen
        layout.prop(settings, "strata")
        layout.prop(settings, "bare_rock")
        column = layout.column(align=True)
        column.operator("orogen.add_block", icon="MESH_CUBE")
        column.operator("orogen.add_section", icon="MESH_GRID")
        column.operator("orogen.add_horizons", icon="MOD_OCEAN")


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
