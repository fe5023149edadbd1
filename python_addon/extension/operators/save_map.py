"""Writing the map that a terrain grows from, drawn or loaded."""

import bpy
from bpy_extras.io_utils import ExportHelper

from .. import recipe
from .save_recipe import SavesJson


class OROGEN_OT_save_map(SavesJson, bpy.types.Operator, ExportHelper):
    """Write the active terrain's map, as it is drawn or loaded, as GeoJSON"""

    bl_idname = "orogen.save_map"
    bl_label = "Save Map"

    filename_ext = ".geojson"
    filter_glob: bpy.props.StringProperty(default="*.geojson", options={"HIDDEN"})

    def content(self, document):
        if "map" not in document:
            raise recipe.NotARecipe("This terrain grows from moving plates: it has no map")
        return document["map"]
