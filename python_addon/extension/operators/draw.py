"""Drawing the map: the right layer, draw mode, seen from above."""

import bpy

from .. import terrains
from ..scene import new_inputs, pencil
from ..scene.plane import Plane

LAYERS = (
    ("Coast", "Coast", "Outlines of land. Strokes are joined end to end"),
    ("Rivers", "Rivers", "Lines, each drawn either way"),
    ("Lakes", "Lakes", "Outlines of lakes"),
    ("Peaks", "Peaks", "A dot for each summit"),
    ("Plate", "Plate Arrows", "An arrow for each stroke: ground moves from its start to its end"),
)
FEATURES = (
    ("Ridges", "Ridges", "Crests from which ground falls to both sides"),
    ("Valleys", "Valleys", "Flat floors with a slope up on both sides"),
    ("Cliffs", "Cliffs", "Ground breaks off on the right of each stroke"),
    ("River Beds", "River Beds", "Narrow channels that are cut into the ground"),
)
MODES = {"GREASEPENCIL": "PAINT_GREASE_PENCIL", "GPENCIL": "PAINT_GPENCIL"}
SEEN = 1.3  # of the frame's longer side


class OROGEN_OT_draw(bpy.types.Operator):
    """Draw on a layer of the terrain's map, seen from above"""

    bl_idname = "orogen.draw"
    bl_label = "Draw"
    bl_options = {"REGISTER", "UNDO"}

    layer: bpy.props.EnumProperty(
        name="Layer", description="What is drawn", items=LAYERS + FEATURES
    )

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Add a terrain or make one active first")
        return terrains.own(context) is not None

    @classmethod
    def description(cls, _context, properties):
        return next(text for name, _, text in LAYERS + FEATURES if name == properties.layer)

    def execute(self, context):
        terrain, scene = terrains.active(context), context.scene
        if context.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        ob = new_inputs.map_of(terrain)
        pencil.ensure_layer(ob, self.layer, min(scene.frame_current, scene.frame_start))
        terrains.activate(context, ob)
        on_its_plane(scene.tool_settings)
        bpy.ops.object.mode_set(mode=MODES[ob.type])
        if context.space_data and context.space_data.type == "VIEW_3D":
            look_down(context.space_data.region_3d, terrain)
        return {"FINISHED"}


def on_its_plane(tools):
    """Strokes come to lie on the x and y of the object that they are drawn on."""
    tools.gpencil_stroke_placement_view3d = "ORIGIN"
    tools.gpencil_sculpt.lock_axis = "AXIS_Z"


def look_down(region, terrain):
    region.view_perspective = "ORTHO"
    region.view_rotation = terrain.matrix_world.to_quaternion()
    look_at_frame(region, terrain)


def look_at_frame(region, terrain):
    plane, half = Plane(terrain), [500.0 * side for side in terrain.orogen.input.frame_km]
    middle, corner = plane.world([(0.0, 0.0), half])
    region.view_location = middle
    region.view_distance = SEEN * max(abs(corner - middle)) * 2
