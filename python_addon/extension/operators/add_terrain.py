"""Add > Mesh > Orogen Terrain, and the things in the scene that a terrain starts from."""

import bpy

from .. import examples, preset_files, recipe, terrains
from ..properties.settings import SOURCES
from ..scene import from_recipe, new_inputs
from ..scene.plates import plate_collections
from ..settings_recipe import set_parameters
from .draw import look_at_frame

TWO_PLATES = "folded_range"  # the example that moving plates start as


class OROGEN_OT_add_terrain(bpy.types.Operator):
    """Add a terrain, to be grown from a map or from plates"""

    bl_idname = "orogen.add_terrain"
    bl_label = "Orogen Terrain"
    bl_options = {"REGISTER", "UNDO"}

    start: bpy.props.EnumProperty(
        name="Start", description="What it grows from", items=SOURCES, default="EXAMPLE"
    )

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def invoke(self, context, _event):
        done = self.execute(context)
        if context.space_data and context.space_data.type == "VIEW_3D":
            context.view_layer.update()
            look_at_frame(context.space_data.region_3d, terrains.active(context))
        return done

    def execute(self, context):
        before = context.object
        terrain = terrains.add(context)
        terrain.orogen.source = self.start
        if before and before.type == "MESH" and not before.orogen.is_terrain:
            terrain.orogen.ground.object = before  # for a start from heights
        add_inputs(terrain, context.scene)
        return {"FINISHED"}


class OROGEN_OT_add_inputs(bpy.types.Operator):
    """Add what this start is drawn with: a grease-pencil map, or two plates that collide"""

    bl_idname = "orogen.add_inputs"
    bl_label = "Set Up"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        terrain = terrains.own(context)
        return context.mode == "OBJECT" and terrain is not None and terrain.orogen.is_drawn()

    def execute(self, context):
        add_inputs(terrains.active(context), context.scene)
        return {"FINISHED"}


class OROGEN_MT_add_terrain(bpy.types.Menu):
    bl_label = "Orogen Terrain"

    def draw(self, _context):
        layout = self.layout
        layout.operator_enum(OROGEN_OT_add_terrain.bl_idname, "start")
        layout.separator()
        for file in preset_files.found():
            name, icon = preset_files.name_of(file), preset_files.icon(file)
            add = layout.operator("orogen.add_from_preset", text=name, icon_value=icon)
            add.filepath = str(file)


def add_inputs(terrain, scene):
    """Whatever the terrain's start is drawn with and the scene lacks."""
    settings, frame = terrain.orogen, min(scene.frame_current, scene.frame_start)
    if settings.source in ("DRAWING", "JOIN"):
        settings.input.use_frame |= settings.drawing is None
        new_inputs.add_map(terrain, frame)
    elif settings.source == "ISLAND":
        settings.input.use_frame = True
    elif settings.source == "PLATES" and not plate_collections(terrain, scene):
        document = recipe.read(examples.path_of(TWO_PLATES))
        from_recipe.add(terrain, document, frame, size=settings.input.frame_km)
        set_parameters(settings, document)


def draw_menu(self, _context):
    self.layout.menu(OROGEN_MT_add_terrain.__name__, icon="RNDCURVE")
