"""Changing an island polygon by polygon: the operator, and the tool for it in the toolbar."""

import json

import bpy
import numpy as np
from bpy_extras.view3d_utils import region_2d_to_origin_3d, region_2d_to_vector_3d

from .. import given_fields, terrains
from ..live import polygons
from ..mesh import middle
from ..polygon_edits import inside
from ..scene.plane import Plane
from .draw_arrow import place_below
from .job_operator import REFUSALS

LAYERS = (
    ("height", "Height", "Of -1, the deepest sea, to 1, the highest peak; the coast follows"),
    ("warmth", "Warmth", "Of 0, cold, to 1, hot; biomes follow"),
    ("moisture", "Moisture", "Of 0, dry, to 1, wet; biomes follow"),
)


class PolygonOperator:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("An island is wanted, in object mode")
        terrain = terrains.own(context)
        if context.mode != "OBJECT" or terrain is None:
            return False
        return given_fields.has_island(terrain.orogen.stage_names())


class OROGEN_OT_change_polygon(PolygonOperator, bpy.types.Operator):
    """Add to the height, warmth or moisture of the island's polygon below the mouse; with Ctrl take
    away"""

    bl_idname = "orogen.change_polygon"
    bl_label = "Change Polygon"

    layer: bpy.props.EnumProperty(name="Layer", description="What is changed", items=LAYERS)
    change: bpy.props.FloatProperty(
        name="Change", description="What is added", default=0.1, min=-1.0, max=1.0, step=5
    )
    subtract: bpy.props.BoolProperty(
        name="Subtract", description="Take away instead", options={"SKIP_SAVE"}
    )
    place: bpy.props.FloatVectorProperty(
        name="Place",
        description="Metres east and north of the terrain's origin",
        size=2,
        options={"SKIP_SAVE"},
    )

    def invoke(self, context, event):
        below = ground_below(context, event)
        if below is None:
            return {"CANCELLED"}
        self.place = Plane(terrains.active(context)).metres(below)[0, :2]
        return self.execute(context)

    def execute(self, context):
        terrain = terrains.active(context)
        try:
            found = polygons.now(terrain, context.scene)
        except REFUSALS as error:
            found = {"error": str(error)}
        if "error" in found:
            self.report({"ERROR"}, found["error"])
            return {"CANCELLED"}
        ring = ring_at(found, self.place, middle.shift(terrain) or (0.0, 0.0))
        if ring is None:
            self.report({"WARNING"}, "There is no polygon")
            return {"CANCELLED"}
        add(terrain, self.layer, ring, -self.change if self.subtract else self.change)
        terrain.update_tag()
        return {"FINISHED"}


class OROGEN_OT_clear_polygons(PolygonOperator, bpy.types.Operator):
    """Take back all changes of single polygons"""

    bl_idname = "orogen.clear_polygons"
    bl_label = "Clear Polygon Changes"

    def execute(self, context):
        terrain = terrains.active(context)
        terrain.orogen.paints.polygons.clear()
        terrain.update_tag()
        return {"FINISHED"}


def ring_at(found, place, shift):
    """The corners (m on the plane) of the polygon that holds a place, or None."""
    place = np.array(place)
    centers, corners = (np.array(found[name]) - shift for name in ("centers", "corners"))
    ring = corners[found["rings"][np.hypot(*(centers - place).T).argmin()]]
    return ring if inside(ring, *place, 1.0) else None


def add(terrain, layer, ring, change):
    """Notes a change; one of the same polygon adds up with it."""
    text, edits = json.dumps(np.round(ring, 1).tolist()), terrain.orogen.paints.polygons
    for number, edit in enumerate(edits):
        if (edit.layer, edit.ring) == (layer, text):
            edit.change += change
            if abs(edit.change) < 1e-6:
                edits.remove(number)
            return
    edit = edits.add()
    edit.layer, edit.ring, edit.change = layer, text, change


def ground_below(context, event):
    """The place on the terrain below the mouse: on its ground, else on its plane; or None."""
    terrain = terrains.active(context)
    view = context.region, context.region_data, (event.mouse_region_x, event.mouse_region_y)
    inverse = terrain.matrix_world.inverted_safe()
    eye = inverse @ region_2d_to_origin_3d(*view)
    ray = inverse.to_3x3() @ region_2d_to_vector_3d(*view)
    hit, place, *_ = terrain.ray_cast(eye, ray) if len(terrain.data.polygons) else (False, None)
    return terrain.matrix_world @ place if hit else place_below(context, event)


class PolygonTool(bpy.types.WorkSpaceTool):
    bl_space_type = "VIEW_3D"
    bl_context_mode = "OBJECT"
    bl_idname = "orogen.polygon_tool"
    bl_label = "Island Polygons"
    bl_description = OROGEN_OT_change_polygon.__doc__
    bl_cursor = "CROSSHAIR"
    bl_icon = "ops.mesh.polybuild_hover"
    bl_keymap = (
        (
            OROGEN_OT_change_polygon.bl_idname,
            {"type": "LEFTMOUSE", "value": "PRESS", "ctrl": True},
            {"properties": [("subtract", True)]},
        ),
        (OROGEN_OT_change_polygon.bl_idname, {"type": "LEFTMOUSE", "value": "PRESS"}, None),
    )

    @staticmethod
    def draw_settings(_context, layout, tool):
        settings = tool.operator_properties(OROGEN_OT_change_polygon.bl_idname)
        layout.prop(settings, "layer")
        layout.prop(settings, "change")


def register_tool():
    bpy.utils.register_tool(PolygonTool, after={"orogen.arrow_tool"})


def unregister_tool():
    bpy.utils.unregister_tool(PolygonTool)
