"""What all panels of the tab share."""

from .. import terrains


class Tab:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Orogen"


class TerrainTab(Tab):
    """A panel that needs a terrain."""

    bl_parent_id = "OROGEN_PT_main"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return terrains.active(context) is not None


def property_layout(panel):
    layout = panel.layout
    layout.use_property_split = True
    layout.use_property_decorate = False
    return layout
