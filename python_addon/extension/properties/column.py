"""The layers of rock that plates fold, the top one first, as in a section."""

import json

import bpy

from ..declarations import LAYER_NUMBERS, LITHOLOGIES
from ..examples import number
from ..titles import title
from .stages import make_property


def take_resistance(self, _context):
    """That of the rock which was picked."""
    self.resistance = LITHOLOGIES[self.lithology].resistance


def color_of(self):
    """Linear, in the palette that the outcrop has."""
    palette = self.id_data.orogen.stages.outcrop.palette
    srgb = getattr(LITHOLOGIES[self.lithology], palette)
    return [_linear((srgb >> shift & 255) / 255) for shift in (16, 8, 0)]


def _linear(value):
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def start_list(self, _context):
    """A list is never empty at first: it begins as the preset was."""
    from .. import column_recipe

    if self.use_layers and not self.layers:
        column_recipe.copy_preset(self, self.id_data.orogen.input.column_preset)


def to_text(self):
    from .. import column_recipe

    return json.dumps(column_recipe.describe(self.id_data.orogen))


def from_text(self, text):
    from .. import column_recipe

    column_recipe.take_over(self.id_data.orogen, json.loads(text))


NUMBERS = {parameter.name: make_property(parameter) for parameter in LAYER_NUMBERS}
ROCK = {
    "name": bpy.props.StringProperty(
        name="Name", description="What the layer is called", default="Layer"
    ),
    "lithology": bpy.props.EnumProperty(
        name="Rock",
        description="What the layer is made of; of several beds, the thickest one",
        items=[(name, title(name), "", number(name)) for name in LITHOLOGIES],
        default="limestone",
        update=take_resistance,
    ),
    "resistance": bpy.props.FloatProperty(
        name="Resistance",
        description="To erosion: 0 is the weakest rock, 1 the hardest",
        subtype="FACTOR",
        default=LITHOLOGIES["limestone"].resistance,
        min=0.0,
        max=1.0,
    ),
    "beds": bpy.props.StringProperty(options={"HIDDEN"}),  # JSON of a recipe's sub_layers
    "color": bpy.props.FloatVectorProperty(
        name="Color",
        description="How the rock is shown; the palette is that of Outcrop",
        subtype="COLOR",
        size=3,
        min=0.0,
        max=1.0,
        get=color_of,
    ),
    "thickness_map": bpy.props.PointerProperty(
        name="Thickness Map",
        description="An image over the terrain: grey times the thickness",
        type=bpy.types.Image,
    ),
}

OROGEN_PG_layer = type(
    "OROGEN_PG_layer",
    (bpy.types.PropertyGroup,),
    {
        "__doc__": "A layer of rock.",
        "__module__": __name__,
        "__annotations__": {**ROCK, **NUMBERS},
    },
)


class OROGEN_PG_column(bpy.types.PropertyGroup):
    use_layers: bpy.props.BoolProperty(
        name="Own Layers",
        description="Fold the layers of the list in place of a preset's",
        update=start_list,
    )
    layers: bpy.props.CollectionProperty(type=OROGEN_PG_layer)
    active_layer: bpy.props.IntProperty(options={"HIDDEN"}, min=0)
    basement: bpy.props.PointerProperty(type=OROGEN_PG_layer)
    document: bpy.props.StringProperty(
        options={"HIDDEN"}, get=to_text, set=from_text
    )  # for presets

    def active(self):
        """The layer that is picked in the list, or None."""
        index = self.active_layer
        return self.layers[index] if index < len(self.layers) else None
