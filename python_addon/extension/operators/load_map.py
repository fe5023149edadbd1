"""Picking a GeoJSON map or a recipe."""

import bpy
from bpy_extras.io_utils import ImportHelper

from .. import recipe, terrains
from ..properties.session import tell


class OROGEN_OT_load_map(bpy.types.Operator, ImportHelper):
    """Pick a map, a recipe or an elevation model for the active terrain, or for a new one"""

    bl_idname = "orogen.load_map"
    bl_label = "Load Map or Recipe"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".geojson"
    filter_glob: bpy.props.StringProperty(
        default="*.geojson;*.json;*.tif;*.tiff;*.hgt;*.npy", options={"HIDDEN"}
    )
    filepath: bpy.props.StringProperty(subtype="FILE_PATH", options={"SKIP_SAVE", "HIDDEN"})

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def invoke(self, context, event):
        if self.filepath:  # a file that was dropped
            return self.execute(context)
        return super().invoke(context, event)

    def execute(self, context):
        try:
            document = recipe.read(self.filepath)
        except recipe.NotARecipe as error:
            tell(context, str(error), is_error=True)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        terrain = terrains.active(context) or terrains.add(context, document.get("name", "Terrain"))
        terrain.orogen.source, terrain.orogen.path = "FILE", self.filepath
        return {"FINISHED"}


def draw_menu(self, _context):
    self.layout.operator(OROGEN_OT_load_map.bl_idname, text="Orogen map or recipe (.geojson)")
