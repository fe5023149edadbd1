"""Writing the map that a terrain grows from, drawn or loaded."""

import json

import bpy
from bpy_extras.io_utils import ExportHelper

from .. import map_features, recipe, terrains
from ..settings_recipe import to_recipe


class OROGEN_OT_save_map(bpy.types.Operator, ExportHelper):
    """Write the active terrain's map, as it is drawn or loaded, as GeoJSON"""

    bl_idname = "orogen.save_map"
    bl_label = "Save Map"

    filename_ext = ".geojson"
    filter_glob: bpy.props.StringProperty(default="*.geojson", options={"HIDDEN"})

    @classmethod
    def poll(cls, context):
        return terrains.active(context) is not None

    def execute(self, context):
        try:
            document = to_recipe(terrains.active(context), context.scene)
            if "map" not in document:
                raise recipe.NotARecipe("This terrain grows from moving plates: it has no map")
            with open(self.filepath, "w", encoding="utf-8") as file:
                json.dump(document["map"], file, indent=1)
        except (recipe.NotARecipe, map_features.NothingDrawn, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}
