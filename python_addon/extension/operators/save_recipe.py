"""Writing the settings as a recipe that the command line and Python take."""

import json

import bpy
from bpy_extras.io_utils import ExportHelper

from .. import map_features, recipe, terrains
from ..settings_recipe import to_recipe


class SavesJson:
    """An operator that writes the active terrain's recipe, or a part of it."""

    @classmethod
    def poll(cls, context):
        return terrains.active(context) is not None

    def content(self, document):
        """What is written of a recipe; may raise NotARecipe."""
        return document

    def execute(self, context):
        try:
            content = self.content(to_recipe(terrains.active(context), context.scene))
            with open(self.filepath, "w", encoding="utf-8") as file:
                json.dump(content, file, indent=1)
        except (recipe.NotARecipe, map_features.NothingDrawn, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class OROGEN_OT_save_recipe(SavesJson, bpy.types.Operator, ExportHelper):
    """Write the active terrain's map and settings as an Orogen recipe"""

    bl_idname = "orogen.save_recipe"
    bl_label = "Save Recipe"

    filename_ext = ".orogen.json"
    filter_glob: bpy.props.StringProperty(default="*.orogen.json", options={"HIDDEN"})
