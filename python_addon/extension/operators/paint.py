"""Painting on a terrain: where it rises faster, where rock is hard, what is to stay."""

import bpy

from .. import terrains
from ..mesh import biome_paint, large_ground, painted, uv

LAYERS = (
    ("uplift", "Uplift", "White rises faster, or aims higher on a map; black slower, or lower"),
    ("hardness", "Hardness", "White is hard rock, black is weak"),
    ("height", "Height", "White lifts an island's ground, black sinks it; the coast follows"),
    ("warmth", "Warmth", "White makes the climate hot, black cold; biomes follow"),
    ("moisture", "Moisture", "White makes the climate wet, black dry; biomes follow"),
    ("biome", "Biome", "Kinds of country, each in its own colour; grey is no paint"),
    ("keep", "Keep", "White stays while the rest grows anew, where Freeze is on"),
)
LONGER_SIDE = 1024  # pixels of a new image


class PaintOperator:
    bl_options = {"REGISTER", "UNDO"}

    layer: bpy.props.EnumProperty(name="Layer", description="What the paint means", items=LAYERS)

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Grow the terrain first: there is nothing to paint on")
        terrain = terrains.own(context)
        return terrain is not None and "orogen_grid" in terrain.data

    def paint(self, context):
        terrain = terrains.own(context)
        return terrain, getattr(terrain.orogen.paints, self.layer)


class OROGEN_OT_paint(PaintOperator, bpy.types.Operator):
    """Paint on the terrain, in Blender's own paint modes"""

    bl_idname = "orogen.paint"
    bl_label = "Paint"

    def execute(self, context):
        terrain, paint = self.paint(context)
        if terrain.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        terrains.activate(context, terrain)
        large_ground.show(terrain, to_paint=True)
        neutral = 0.0 if self.layer == "keep" else painted.NEUTRAL
        if paint.method == "NONE" or self.layer == "biome":
            paint.method = "IMAGE"
        if paint.method == "VERTEX":
            mesh = terrain.data
            mesh.color_attributes.active_color = painted.ensure(mesh, self.layer, neutral)
            bpy.ops.object.mode_set(mode="VERTEX_PAINT")
        else:
            show_image(context, terrain, ensure_image(terrain, paint, self.layer, neutral))
            bpy.ops.object.mode_set(mode="TEXTURE_PAINT")
        if self.layer == "biome":
            biome_paint.set_brush(context, terrain.orogen.paints.biome_brush)
        return {"FINISHED"}


class OROGEN_OT_end_painting(bpy.types.Operator):
    """Leave the paint mode. Ground in tiles shows them again"""

    bl_idname = "orogen.end_painting"
    bl_label = "Done"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return terrains.own(context) is not None

    def execute(self, context):
        if context.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        large_ground.show(terrains.own(context))
        return {"FINISHED"}


class OROGEN_OT_clear_paint(PaintOperator, bpy.types.Operator):
    """Take a layer of paint off the terrain. An image stays in the file"""

    bl_idname = "orogen.clear_paint"
    bl_label = "Clear Paint"

    def execute(self, context):
        terrain, paint = self.paint(context)
        if terrain.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        painted.remove(terrain.data, self.layer)
        paint.method, paint.image = "NONE", None
        return {"FINISHED"}


def ensure_image(terrain, paint, layer, value):
    if paint.image is None:
        nx, ny = terrain.data["orogen_grid"]
        size = [max(1, round(LONGER_SIDE * n / max(nx, ny))) for n in (nx, ny)]
        image = bpy.data.images.new(f"{terrain.name} {layer.capitalize()}", *size)
        image.colorspace_settings.name = "Non-Color"
        image.generated_color = (value, value, value, 1.0)
        image.pack()
        paint.image = image
    return paint.image


def show_image(context, terrain, image):
    """Blender's texture paint works on this image."""
    nx, ny = terrain.data["orogen_grid"]
    if uv.LAYER not in terrain.data.uv_layers:
        uv.write(terrain.data, uv.of_grid(nx, ny))
    brush = context.scene.tool_settings.image_paint
    brush.mode, brush.canvas = "IMAGE", image


@bpy.app.handlers.persistent
def keep_images(*_):
    """What is painted goes into the file that is saved."""
    for ob in bpy.data.objects:
        if not ob.orogen.is_terrain or ob.library:
            continue
        for layer, *_ in LAYERS:
            image = getattr(ob.orogen.paints, layer).image
            if image and image.is_dirty and not image.library and not image.filepath:
                image.pack()
