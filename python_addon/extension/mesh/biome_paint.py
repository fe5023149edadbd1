"""Biomes painted on an image, each in its own colour of the core's table; grey is no paint.

A soft brush leaves colours between two: such a pixel takes what lies nearest of those that are
clear, so that no third biome runs along the edge of a stroke.
"""

import numpy as np

from ..declarations import BIOMES

WATER = ("lake", "ocean")  # where the ground has it
UNPAINTED = -1.0
GREY = 0x808080
CLEAR = 1.5 / 255.0  # how far a colour may be off


def rgb(color):
    return [(color >> shift & 255) / 255.0 for shift in (16, 8, 0)]


def set_brush(context, name):
    """The brush of Blender's texture paint takes a biome's colour."""
    color = next((b.color for b in BIOMES if b.name == name), GREY)
    settings = context.scene.tool_settings
    paint = settings.image_paint
    if paint.brush is None:
        return
    paint.brush.color = rgb(color)
    for unified in (getattr(settings, "unified_paint_settings", None), paint):
        unified = getattr(unified, "unified_paint_settings", unified)
        if hasattr(unified, "use_unified_color"):
            unified.color = rgb(color)


def of_image(image):
    """Numbers of biomes (rows, columns) from the south; None if there is no paint."""
    width, height = image.size
    if not width * height:
        return None
    pixels = np.empty(width * height * image.channels, np.float32)
    image.pixels.foreach_get(pixels)
    labels = decode(pixels.reshape(height, width, image.channels)[..., :3])
    return labels if (labels != UNPAINTED).any() else None


def decode(colors):
    """Numbers of biomes from colours (rows, columns, 3)."""
    labels = np.full(colors.shape[:2], np.nan, np.float32)
    known = [(i, b.color) for i, b in enumerate(BIOMES) if b.name not in WATER]
    for number, color in ((UNPAINTED, GREY), *known):
        labels[np.abs(colors - np.float32(rgb(color))).max(axis=-1) < CLEAR] = number
    if np.isnan(labels).all():
        return np.full(labels.shape, UNPAINTED, np.float32)
    while np.isnan(labels).any():
        labels = _grown(labels)
    return labels


def _grown(labels):
    """Unknown labels take those of known neighbours."""
    padded = np.pad(labels, 1, constant_values=np.nan)
    rows, columns = labels.shape
    for up, right in ((0, 1), (2, 1), (1, 0), (1, 2)):
        beside = padded[up : up + rows, right : right + columns]
        labels = np.where(np.isnan(labels), beside, labels)
    return labels
