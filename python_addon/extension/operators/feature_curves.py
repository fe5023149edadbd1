"""Feature curves: adding them, their kinds, laying them on the ground."""

import bpy
import numpy as np
from mathutils import Vector

from .. import terrains
from ..feature_curves import FLAT, KINDS, NUMBERS
from ..mesh.relief import Relief
from ..properties.feature import selected
from ..scene import new_inputs
from ..scene.curves import controls
from ..scene.feature_curves import HEIGHT, longer_side
from ..scene.plane import Planes, cursor_place

LENGTH = 0.25  # of the terrain's longer side
POINTS, BEND = 7, 0.2  # of a new curve; how far it swings to each side, of its half length
ITEMS = [(name, kind.label, kind.text) for name, kind in KINDS.items()]


class FeatureOperator:
    bl_options = {"REGISTER", "UNDO"}

    kind: bpy.props.EnumProperty(name="Kind", description="What the curve makes", items=ITEMS)

    @classmethod
    def description(cls, _context, properties):
        return KINDS[properties.kind].text


class OROGEN_OT_add_feature_curve(FeatureOperator, bpy.types.Operator):
    """Add a curve that the terrain's ground is bent to"""

    bl_idname = "orogen.add_feature_curve"
    bl_label = "Add Feature Curve"

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("A terrain is wanted, in object mode")
        return context.mode == "OBJECT" and terrains.own(context) is not None

    def execute(self, context):
        terrain = terrains.active(context)
        side = longer_side(terrain)
        middle = cursor_place(terrain, context.scene, side)
        half = 0.5 * LENGTH * side
        x = np.linspace(-1.0, 1.0, POINTS)
        places = middle + half * np.column_stack([x, BEND * np.sin(np.pi * x)])
        ob = new_inputs.add_curve(
            terrain, KINDS[self.kind].label, np.insert(places, 2, 0.0, axis=1)
        )
        ob.orogen_feature.take(self.kind, side)
        lay(ob, terrain, lambda ground: KINDS[self.kind].heights(ground, side))
        terrains.activate(context, ob)
        return {"FINISHED"}


class CurveOperator:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Make a curve object active")
        ob = context.object
        return ob is not None and ob.type == "CURVE" and not ob.library


class OROGEN_OT_set_feature_kind(CurveOperator, FeatureOperator, bpy.types.Operator):
    """Give the active curve the usual sizes of a kind. One that lies flat is laid on the ground"""

    bl_idname = "orogen.set_feature_kind"
    bl_label = "Set Kind"

    def execute(self, context):
        ob, terrain = context.object, terrain_of(context)
        if terrain is None:
            self.report({"ERROR"}, "There is no terrain")
            return {"CANCELLED"}
        side = longer_side(terrain)
        ob.orogen_feature.take(self.kind, side)
        forget_points(ob)
        heights = places_of(ob, Planes(terrain).of(ob))[:, 2]
        if len(heights) and (abs(heights) < FLAT).all():
            lay(ob, terrain, lambda ground: KINDS[self.kind].heights(ground, side))
        return {"FINISHED"}


class OROGEN_OT_lay_feature_curve(CurveOperator, bpy.types.Operator):
    """Put the points of the active curve on the ground; in edit mode those that are selected"""

    bl_idname = "orogen.lay_feature_curve"
    bl_label = "Lay on Ground"

    lift: bpy.props.FloatProperty(
        name="Above (m)",
        description="How high above the ground",
        min=-12e3,
        max=12e3,
        step=1000,
        precision=0,
    )

    def execute(self, context):
        terrain = terrain_of(context)
        if terrain is None:
            self.report({"ERROR"}, "There is no terrain")
            return {"CANCELLED"}
        chosen = context.mode == "EDIT_CURVE"
        lay(context.object, terrain, lambda ground: ground + self.lift, only_selected=chosen)
        return {"FINISHED"}


class OROGEN_OT_forget_point_values(CurveOperator, bpy.types.Operator):
    """Take back what points of the active curve have of their own: all are as the curve says"""

    bl_idname = "orogen.forget_point_values"
    bl_label = "As the Curve"

    def execute(self, context):
        forget_points(context.object)
        return {"FINISHED"}


def terrain_of(context):
    """The terrain that the active curve is for: the one above it, else the file's first."""
    found = terrains.own(context)
    return found or next((ob for ob in context.scene.objects if ob.orogen.is_terrain), None)


def forget_points(ob):
    for name in (*NUMBERS, HEIGHT):
        if name in ob:
            del ob[name]
    ob.update_tag()


def places_of(ob, plane):
    """The control points in metres on the plane, (n, 3)."""
    world = [
        ob.matrix_world @ point.co.to_3d()
        for spline in ob.data.splines
        for point in controls(spline)
    ]
    return plane.metres(np.array([tuple(place) for place in world]))


def lay(ob, terrain, heights, only_selected=False):
    """Moves control points to where `heights` says, of the ground below them (m)."""
    bpy.context.view_layer.update()
    plane, inverse = Planes(terrain).of(ob), ob.matrix_world.inverted_safe().to_3x3()
    places = places_of(ob, plane)
    if not len(places):
        return
    rises = heights(Relief(terrain).at(places[:, :2])) - places[:, 2]
    moved = selected(ob) if only_selected else np.ones(len(places), bool)
    up = Vector(plane.places([(0.0, 0.0, 1.0)])[0] - plane.places([(0.0, 0.0, 0.0)])[0])
    points = [point for spline in ob.data.splines for point in controls(spline)]
    for point, rise, moves in zip(points, rises, moved, strict=True):
        if moves:
            shift_point(point, inverse @ (up * float(rise)))
    ob.data.update_tag()


def shift_point(point, way):
    if hasattr(point, "handle_left"):
        for end in ("handle_left", "handle_right"):
            setattr(point, end, getattr(point, end) + way)
        point.co += way
    else:
        point.co += Vector((*way, 0.0))


def draw_menu(self, context):
    if terrains.active(context):
        self.layout.operator_menu_enum(
            OROGEN_OT_add_feature_curve.bl_idname, "kind", text="Feature Curve", icon="CURVE_PATH"
        )
