"""Previews that follow the hand, and growth that is watched: settings of a terrain."""

import bpy


def _wake(self, _context):
    from ..live import loop

    loop.wake()


class OROGEN_PG_live(bpy.types.PropertyGroup):
    enabled: bpy.props.BoolProperty(
        name="Live Preview",
        description="Grow a coarse preview whenever the drawing or a setting changes",
        update=_wake,
    )
    watch: bpy.props.BoolProperty(
        name="Watch It Grow",
        description="Show mountains between plates as they grow, and water as it wears the ground."
        " Esc brings the terrain back",
        default=True,
    )
    watch_shows: bpy.props.EnumProperty(
        name="Water Shows",
        description="What colours tell while water wears the ground",
        items=(
            ("WATER", "Water", "How deep it is"),
            ("CHANGE", "Change", "What was worn off and laid down"),
        ),
        default="CHANGE",
    )
    variations: bpy.props.IntProperty(
        name="Variations", description="Of the browser of seeds", default=6, min=1, max=36
    )
