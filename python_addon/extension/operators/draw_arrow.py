"""Drawing an arrow of a plate with the mouse, and the tool for it in the toolbar."""

import bpy
from bpy_extras.view3d_utils import region_2d_to_origin_3d, region_2d_to_vector_3d
from mathutils import Vector
from mathutils.geometry import intersect_line_plane

from .. import terrains
from ..overlay import plates as overlay
from ..scene import new_inputs
from ..scene.plane import Plane
from ..scene.plates import active_plate
from .plates import PlateOperator, add_arrow

DOT = 4  # pixels: a shorter drag is ground that stays


class OROGEN_OT_draw_arrow(PlateOperator, bpy.types.Operator):
    """Draw an arrow of the active plate: from a point to where that ground goes. A click: it
    stays"""

    bl_idname = "orogen.draw_arrow"
    bl_label = "Draw Arrow"

    start: bpy.props.FloatVectorProperty(
        name="Start", description="Point of the plate, in the world", subtype="XYZ"
    )
    end: bpy.props.FloatVectorProperty(
        name="End", description="Where that ground goes, in the world", subtype="XYZ"
    )

    def execute(self, context):
        terrain = terrains.active(context)
        plate = active_plate(context, terrain) or new_inputs.add_plate(terrain, "Plate")
        start, end = Plane(terrain).metres([self.start, self.end])[:, :2]
        add_arrow(context, terrain, plate, start, end - start)
        return {"FINISHED"}

    def invoke(self, context, event):
        start = place_below(context, event)
        if start is None:
            return {"CANCELLED"}
        self.start = self.end = start
        self._pressed = Vector((event.mouse_region_x, event.mouse_region_y))
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type in ("ESC", "RIGHTMOUSE"):
            self._show(context, None)
            return {"CANCELLED"}
        if event.type == "MOUSEMOVE":
            mouse = Vector((event.mouse_region_x, event.mouse_region_y))
            below = place_below(context, event)
            is_dot = (mouse - self._pressed).length < DOT or below is None
            self.end = self.start if is_dot else below
            self._show(context, (tuple(self.start), tuple(self.end)))
        elif event.type == "LEFTMOUSE" and event.value == "RELEASE":
            self._show(context, None)
            return self.execute(context)
        return {"RUNNING_MODAL"}

    def cancel(self, context):
        self._show(context, None)

    def _show(self, context, arrow):
        overlay.drawn_now = arrow
        context.area.tag_redraw()


def place_below(context, event):
    """The place on the active terrain's plane below the mouse, or None."""
    mouse = event.mouse_region_x, event.mouse_region_y
    view = context.region, context.region_data, mouse
    eye, ray = region_2d_to_origin_3d(*view), region_2d_to_vector_3d(*view)
    matrix = terrains.active(context).matrix_world
    return intersect_line_plane(eye, eye + ray, matrix.translation, matrix.col[2].to_3d())


class ArrowTool(bpy.types.WorkSpaceTool):
    bl_space_type = "VIEW_3D"
    bl_context_mode = "OBJECT"
    bl_idname = "orogen.arrow_tool"
    bl_label = "Plate Arrow"
    bl_description = OROGEN_OT_draw_arrow.__doc__
    bl_cursor = "CROSSHAIR"
    bl_icon = "ops.gpencil.primitive_line"
    bl_keymap = ((OROGEN_OT_draw_arrow.bl_idname, {"type": "LEFTMOUSE", "value": "PRESS"}, None),)


def register_tool():
    bpy.utils.register_tool(ArrowTool, after={"builtin.select_box"}, group=True)  # below the cursor


def unregister_tool():
    bpy.utils.unregister_tool(ArrowTool)
