"""How large the terrain stands in the scene."""

import bpy

from .. import terrains
from .tab import TerrainTab, property_layout


class OROGEN_PT_size(TerrainTab, bpy.types.Panel):
    bl_label = "Size in the Scene"

    def draw(self, context):
        layout = property_layout(self)
        settings = terrains.active(context).orogen
        layout.prop(settings, "units_per_km")
        layout.prop(settings, "vertical_exaggeration")
