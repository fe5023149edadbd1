"""A terrain for other programs and for other modifiers: files, meshes, geometry nodes."""

import bpy

from .. import terrains
from .tab import TerrainTab


class OROGEN_PT_output(TerrainTab, bpy.types.Panel):
    bl_label = "Output"

    def draw(self, _context):
        column = self.layout.column(align=True)
        column.operator("orogen.export_terrain", icon="EXPORT")
        column.operator("orogen.save_map", icon="FILE_TICK")
        column.operator("orogen.save_recipe", icon="FILE_TICK")
        column.operator("orogen.save_asset_library", icon="ASSET_MANAGER")


class GrownTab(TerrainTab):
    bl_parent_id = "OROGEN_PT_output"

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and len(terrain.data.vertices) > 0


class OROGEN_PT_meshes(GrownTab, bpy.types.Panel):
    bl_label = "Meshes"

    def draw(self, _context):
        column = self.layout.column(align=True)
        column.operator("orogen.add_uv", icon="UV")
        column.operator("orogen.split_tiles", icon="MESH_GRID")
        column.operator("orogen.add_lods", icon="MOD_MULTIRES")
        column.operator("orogen.add_solid", icon="MESH_CUBE")
        column.operator("orogen.add_decimated", icon="MOD_DECIM")
        column.operator("orogen.add_tin", icon="MOD_TRIANGULATE")
        self.layout.label(text="Numbers: Adjust Last Operation", icon="INFO")


class OROGEN_PT_nodes(GrownTab, bpy.types.Panel):
    bl_label = "Geometry Nodes"

    def draw(self, _context):
        column = self.layout.column(align=True)
        column.operator("orogen.add_scatter", icon="PARTICLES")
        column.operator("orogen.add_water", icon="MOD_FLUIDSIM")
        column.operator("orogen.add_rivers", icon="CURVE_BEZCURVE")
