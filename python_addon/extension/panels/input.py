"""What the terrain grows from: its start, and the means to draw or pick it."""

import bpy

from .. import terrains
from ..recipe import ELEVATION_MODELS
from ..scene import pencil
from ..scene.plates import plate_collections
from .feature import draw_add
from .tab import TerrainTab, property_layout

MAP_LAYERS = (("Coast", "CURVE_NCIRCLE"), ("Rivers", "CURVE_PATH"))
MORE_LAYERS = (("Lakes", "MESH_CIRCLE"), ("Peaks", "EMPTY_SINGLE_ARROW"))


def draw_input(layout, context, terrain):
    settings = terrain.orogen
    row = layout.row(align=True)
    row.popover("OROGEN_PT_presets", text="Presets", icon="PRESET")
    row.operator("orogen.add_terrain_preset", text="", icon="ADD")
    layout.prop(settings, "source")
    if settings.is_drawn():
        draw_drawn(layout, context, terrain)
    else:
        draw_picked(layout, settings)
    draw_add(layout)
    if settings.is_drawn():
        layout.prop(settings, "living")
    layout.prop(settings, "resolution")
    layout.prop(settings, "seed")


def draw_picked(layout, settings):
    if settings.source == "FILE":
        layout.prop(settings, "path")
        layout.operator("orogen.load_map", text="Load Map or Recipe", icon="FILE_FOLDER")
        if settings.path.lower().endswith(ELEVATION_MODELS):
            layout.prop(settings.ground, "use")
    else:
        layout.prop(settings, "example")
    layout.operator("orogen.edit_recipe", icon="GREASEPENCIL")


def draw_drawn(layout, context, terrain):
    settings = terrain.orogen
    if settings.source == "HEIGHTS":
        return draw_ground(layout, settings)
    if settings.source == "ISLAND":
        return None
    if settings.source != "PLATES":
        draw_map_tools(layout, context, settings)
    elif not plate_collections(terrain, context.scene):
        layout.operator("orogen.add_inputs", text="Add Two Plates", icon="ADD")
    layout.operator("orogen.check_drawing", icon="CHECKMARK")


def draw_ground(layout, settings):
    given = settings.ground
    layout.prop(given, "use")
    layout.prop(given, "kind")
    if given.kind == "OBJECT":
        layout.prop(given, "object")
        if given.object is None:
            layout.label(text="Pick a mesh first", icon="INFO")
    else:
        layout.template_ID(given, "image", open="image.open")
        column = layout.column(align=True)
        column.prop(given, "black")
        column.prop(given, "white")


def draw_map_tools(layout, context, settings):
    if settings.drawing is None:
        layout.operator("orogen.add_inputs", text="Add a Map to Draw On", icon="ADD")
    drawing = context.mode.startswith("PAINT_G")
    current = pencil.active_layer(context.object) if drawing else ""
    column = layout.column(align=True)
    for layers in (MAP_LAYERS, MORE_LAYERS):
        row = column.row(align=True)
        for name, icon in layers:
            row.operator("orogen.draw", text=name, icon=icon, depress=name == current).layer = name
    if drawing:
        column.operator("object.mode_set", text="Done", icon="CHECKMARK").mode = "OBJECT"


class OROGEN_PT_frame(TerrainTab, bpy.types.Panel):
    bl_label = "Frame"

    @classmethod
    def poll(cls, context):
        terrain = terrains.active(context)
        return terrain is not None and terrain.orogen.is_drawn()

    def draw_header(self, context):
        self.layout.prop(terrains.active(context).orogen.input, "use_frame", text="")

    def draw(self, context):
        layout = property_layout(self)
        settings = terrains.active(context).orogen
        column = layout.column()
        column.active = settings.input.use_frame
        column.prop(settings.input, "frame_km")
        if settings.source not in ("PLATES", "ISLAND"):
            layout.prop(settings.input, "join_tolerance")
        layout.prop(settings, "drawing")
