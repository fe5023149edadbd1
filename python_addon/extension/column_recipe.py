"""Layers of rock as a recipe's column, and a recipe's column as layers.

A layer of several beds keeps them as they are, as JSON; what can be edited is the thickest bed.
"""

import json

import bpy
import numpy as np

from . import map_features
from .declarations import COLUMNS, LAYER_NUMBERS, LITHOLOGIES
from .properties.stages import set_value, value_of
from .scene import ground

FINEST = 128  # rows and columns of a thickness map, at most


def make(settings):
    """Raises NothingDrawn if the list is in use and empty."""
    if settings.column.use_layers and not settings.column.layers:
        raise map_features.NothingDrawn("There are no layers of rock: add some under Strata")
    return describe(settings)


def describe(settings):
    column = settings.column
    if not column.use_layers:
        return {"preset": settings.input.column_preset}
    layers = [_to_recipe(layer) for layer in reversed(column.layers)]
    return {"basement": _to_recipe(column.basement), "layers": layers}


def take_over(settings, document):
    """What a recipe says of its column."""
    column = settings.column
    column.use_layers = "preset" not in document
    if column.use_layers:
        _fill(column, document)
    else:
        settings.input.column_preset = document["preset"]


def copy_preset(column, name):
    _fill(column, COLUMNS[name])


def _fill(column, document):
    column.layers.clear()
    for item in reversed(document["layers"]):
        _take(column.layers.add(), item)
    _take(column.basement, document["basement"])
    column.active_layer = 0


def beds_of(layer):
    return json.loads(layer.beds) if layer.beds else [{"share": 1.0}]


def _thickest(beds):
    return max(range(len(beds)), key=lambda i: beds[i].get("share", 1.0))


def _take(layer, item):
    layer.name = item.get("name", "Layer")
    for parameter in LAYER_NUMBERS:
        set_value(layer, parameter, item.get(parameter.name, parameter.default))
    beds = item["sub_layers"]
    layer.beds = json.dumps(beds)
    bed = beds[_thickest(beds)]
    layer.lithology = bed["lithology"]
    if "resistance" in bed:
        layer.resistance = bed["resistance"]
    layer.thickness_map = None
    if "thickness_map" in item:
        heights = np.array(item["thickness_map"], float)
        layer.thickness = max(heights.max(), 1.0)
        layer.thickness_map = _image(layer.name, heights / layer.thickness)


def _to_recipe(layer):
    beds = beds_of(layer)
    i = _thickest(beds)
    bed = {"lithology": layer.lithology, "share": beds[i].get("share", 1.0)}
    resistance = float(f"{layer.resistance:.6g}")
    if resistance != LITHOLOGIES[layer.lithology].resistance:
        bed["resistance"] = resistance
    numbers = {parameter.name: value_of(layer, parameter) for parameter in LAYER_NUMBERS}
    item = {"name": layer.name, **numbers, "sub_layers": [*beds[:i], bed, *beds[i + 1 :]]}
    if rows := _thickness_rows(layer, numbers["thickness"]):
        item["thickness_map"] = rows
    return item


def _thickness_rows(layer, thickness):
    """Heights from the south-west (m); None without an image, or one without pixels."""
    image = layer.thickness_map
    heights = ground.of_image(image, 0.0, thickness) if image else None
    if heights is None:
        return None
    rows, columns = (
        np.linspace(0, n - 1, min(max(n, 2), FINEST)).round().astype(int) for n in heights.shape
    )
    return np.clip(heights[np.ix_(rows, columns)], 0.0, 50e3).round(1).tolist()


def _image(name, grey):
    rows, columns = grey.shape
    image = bpy.data.images.new(f"{name} Thickness", columns, rows, float_buffer=True)
    image.colorspace_settings.name = "Non-Color"
    pixels = np.ones((rows, columns, 4), np.float32)
    pixels[..., :3] = grey[..., None]
    image.pixels.foreach_set(pixels.ravel())
    image.pack()
    return image
