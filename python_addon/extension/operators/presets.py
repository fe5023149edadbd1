"""Presets of a terrain's settings, in Blender's own way: small scripts in folders."""

from pathlib import Path

import bpy
from bl_operators.presets import AddPresetBase

from .. import preset_files, terrains
from ..preset_files import FOLDER


class OROGEN_MT_terrain_presets(bpy.types.Menu):
    bl_label = "Terrain Presets"
    preset_subdir = FOLDER
    preset_operator = "orogen.load_preset"
    draw = bpy.types.Menu.draw_preset


class OROGEN_OT_load_preset(bpy.types.Operator):
    """Set the terrain up as the preset says"""

    bl_idname = "orogen.load_preset"
    bl_label = "Load Terrain Preset"
    bl_options = {"REGISTER", "UNDO"}

    filepath: bpy.props.StringProperty(
        name="File", description="Of the preset", subtype="FILE_PATH", options={"SKIP_SAVE"}
    )

    @classmethod
    def poll(cls, context):
        return terrains.own(context) is not None

    def execute(self, context):
        if not Path(self.filepath).is_file():
            self.report({"ERROR"}, f"There is no preset '{self.filepath}'")
            return {"CANCELLED"}
        apply(context, terrains.active(context), self.filepath)
        return {"FINISHED"}


class OROGEN_OT_add_from_preset(bpy.types.Operator):
    """Add a terrain that is set up as the preset says"""

    bl_idname = "orogen.add_from_preset"
    bl_label = "Add Terrain from Preset"
    bl_options = {"REGISTER", "UNDO"}

    filepath: bpy.props.StringProperty(
        name="File", description="Of the preset", subtype="FILE_PATH", options={"SKIP_SAVE"}
    )

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def execute(self, context):
        file = Path(self.filepath)
        if not file.is_file():
            self.report({"ERROR"}, f"There is no preset '{self.filepath}'")
            return {"CANCELLED"}
        apply(context, terrains.add(context, preset_files.name_of(file)), file)
        return {"FINISHED"}


class OROGEN_OT_add_terrain_preset(AddPresetBase, bpy.types.Operator):
    """Keep the terrain's settings as a preset. What is drawn in the scene is no part of it"""

    bl_idname = "orogen.add_terrain_preset"
    bl_label = "Add Terrain Preset"
    preset_menu = OROGEN_MT_terrain_presets.__name__
    preset_subdir = FOLDER
    preset_defines = ["settings = bpy.context.object.orogen"]
    preset_values = [
        f"settings.{name}"
        for name in (
            "source",
            "example",
            "path",
            "resolution",
            "seed",
            "units_per_km",
            "vertical_exaggeration",
            "strata",
            "bare_rock",
            "input",
            "column.document",
            "stages",
        )
    ]

    @classmethod
    def poll(cls, context):
        return terrains.own(context) is not None

    def execute(self, context):
        with context.temp_override(object=terrains.active(context)):
            return super().execute(context)


def apply(context, terrain, file):
    with context.temp_override(object=terrain):
        bpy.utils.execfile(str(file))


def folder():
    """What Blender looks for presets in."""
    return str(Path(__file__).parent.parent)
