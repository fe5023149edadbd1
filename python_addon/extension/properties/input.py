"""How what is drawn in the scene is read."""

import bpy

from ..declarations import COLUMNS
from ..examples import number


def _wake(_self, _context):
    from ..live import loop

    loop.wake_inputs()


class OROGEN_PG_input(bpy.types.PropertyGroup):
    use_frame: bpy.props.BoolProperty(
        name="Frame",
        description="Grow just the rectangle around the terrain's origin that the viewport shows."
        " Otherwise: what is drawn, and a margin",
    )
    frame_km: bpy.props.FloatVectorProperty(
        name="Size (km)",
        description="Width and height of the frame",
        size=2,
        default=(90.0, 60.0),
        min=0.1,
        max=20000.0,
        soft_min=5.0,
        soft_max=500.0,
        precision=1,
    )
    join_tolerance: bpy.props.FloatProperty(
        name="Join Strokes",
        description="Open coast strokes are joined, the nearest ends first; a gap wider than this"
        " share of the coasts' longer side is told as a problem. 0: each stroke closes by itself",
        subtype="FACTOR",
        default=0.02,
        min=0.0,
        max=0.5,
    )
    phase_years: bpy.props.FloatProperty(
        name="Duration (yr)",
        description="For how long plates move, where no arrow is keyed",
        default=5e6,
        min=1e3,
        max=1e9,
        soft_min=1e5,
        soft_max=5e7,
        step=1e7,
        precision=0,
    )
    years_per_frame: bpy.props.FloatProperty(
        name="Years a Frame",
        description="Keyed arrows: at each key a phase begins, and the next key ends it",
        default=1e5,
        min=1.0,
        max=1e8,
        soft_min=1e3,
        soft_max=1e6,
        step=1e6,
        precision=0,
    )
    column_preset: bpy.props.EnumProperty(
        name="Rocks",
        description="The column of rock that plates fold",
        items=[(name, name.capitalize(), "", number(name)) for name in COLUMNS],
        default="alps",
    )
    show_hulls: bpy.props.BoolProperty(
        name="Hulls and Influence",
        description="Shade the rigid part of each plate, and draw the borders of the ground that"
        " each one carries along",
        default=True,
        update=_wake,
    )
    show_features: bpy.props.BoolProperty(
        name="Show Outlines",
        description="Draw the plateau, the slopes and the envelope of each feature curve",
        default=True,
    )
    show_polygons: bpy.props.BoolProperty(
        name="Polygons",
        description="Draw the island's polygons over the ground, in the colours of their biomes,"
        " and its rivers",
        update=_wake,
    )
    show_downslopes: bpy.props.BoolProperty(
        name="Downslopes",
        description="Draw which way water goes from each corner of a polygon",
    )
    rigid_arrows: bpy.props.BoolProperty(
        name="Rigid Arrows",
        description="When you have moved or turned an arrow, those of its plate turn to the rigid"
        " motion that is nearest to them all",
        default=True,
    )
    active_plate: bpy.props.IntProperty(options={"HIDDEN"}, min=0)

    def frame_size(self):
        """Width and height of the frame in metres, or None without one."""
        return self.frame_metres() if self.use_frame else None

    def frame_metres(self):
        return [round(1000.0 * side, 1) for side in self.frame_km]
