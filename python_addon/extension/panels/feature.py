"""The active curve as a feature curve: above the terrain's own panel."""

import bpy

from .. import terrains
from ..feature_curves import KINDS, NUMBERS
from ..operators.draw import FEATURES
from ..scene.feature_curves import HEIGHT
from .tab import Tab, property_layout

ICONS = {
    "RIDGE": "SHARPCURVE",
    "VALLEY": "INVERSESQUARECURVE",
    "CLIFF": "NOCURVE",
    "RIVER_BED": "SMOOTHCURVE",
}


class OROGEN_PT_feature(Tab, bpy.types.Panel):
    bl_label = "Feature Curve"
    bl_order = -1

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "CURVE"

    def draw_header(self, context):
        self.layout.prop(context.object.orogen_feature, "is_feature", text="")

    def draw(self, context):
        layout = property_layout(self)
        settings = context.object.orogen_feature
        grid = layout.grid_flow(columns=2, even_columns=True, align=True)
        for name, kind in KINDS.items():
            grid.operator("orogen.set_feature_kind", text=kind.label, icon=ICONS[name]).kind = name
        column = layout.column()
        column.active = settings.is_feature
        column.prop(settings, HEIGHT)
        column.prop(settings, "plateau")
        column.prop(settings, "alike")
        draw_numbers(column, settings, settings.alike)
        column.operator("orogen.lay_feature_curve", icon="TRIA_DOWN_BAR")
        if terrain := terrains.active(context):
            layout.prop(terrain.orogen.input, "show_features")


class OROGEN_PT_feature_points(Tab, bpy.types.Panel):
    bl_label = "Selected Points"
    bl_parent_id = "OROGEN_PT_feature"

    @classmethod
    def poll(cls, context):
        ob = context.object
        return context.mode == "EDIT_CURVE" and ob.orogen_feature.is_feature

    def draw(self, context):
        layout = property_layout(self)
        ob = context.object
        points = ob.orogen_feature.points
        layout.prop(points, HEIGHT)
        layout.prop(points, "plateau")
        draw_numbers(layout, points, alike=False)
        if any(name in ob for name in (*NUMBERS, HEIGHT)):
            layout.operator("orogen.forget_point_values", icon="LOOP_BACK")
        layout.label(text="Radius widens, tilt leans (Item tab)", icon="INFO")


def draw_numbers(layout, settings, alike):
    """Slope and envelope, for each side or for both."""
    for side in ("left",) if alike else ("left", "right"):
        column = layout.column(align=True, heading="" if alike else side.capitalize())
        if not alike:
            column.label(text=side.capitalize())
        column.prop(settings, f"slope_size_{side}", text="Slope Width (m)")
        column.prop(settings, f"slope_angle_{side}", text="Angle (°)")
        column.prop(settings, f"envelope_{side}", text="Blend (m)")


class OROGEN_MT_draw_features(bpy.types.Menu):
    bl_label = "Draw"

    def draw(self, _context):
        for name, *_ in FEATURES:
            self.layout.operator("orogen.draw", text=name).layer = name


def draw_add(layout):
    row = layout.row(align=True)
    row.operator_menu_enum(
        "orogen.add_feature_curve", "kind", text="Feature Curve", icon="CURVE_BEZCURVE"
    )
    row.menu("OROGEN_MT_draw_features", text="", icon="GREASEPENCIL")
