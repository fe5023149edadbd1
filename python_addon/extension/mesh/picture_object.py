"""A section's picture: an image of the .blend, and an empty that shows it south of the terrain."""

import bpy
import numpy as np

from . import children

ROLE = "picture"


def write(terrain, arrays):
    """`pixels` (h, w, 4), the upper row first; `extent`: length and height in metres."""
    pixels, (length, _) = arrays["pixels"], arrays["extent"]
    image = _image(f"{terrain.name} Section", pixels)
    ob = children.renew(terrain, ROLE, [ROLE], lambda _name: None)[ROLE]
    ob.empty_display_type = "IMAGE"
    ob.data = image
    ob.empty_display_size = length * terrain.orogen.local_scale()[0]
    ob.empty_image_offset = (-0.5, 0.0)  # stands on its lower edge
    ob.rotation_euler = (np.pi / 2, 0.0, 0.0)
    (nx, ny), (x, y) = terrain.data["orogen_grid"], terrain.data["orogen_offset"]
    cell, across = terrain.data["orogen_cell_size"], terrain.orogen.local_scale()[0]
    ob.location = ((x + 0.5 * nx * cell) * across, (y - 0.05 * ny * cell) * across, 0.0)


def _image(name, pixels):
    height, width = pixels.shape[:2]
    image = bpy.data.images.get(name)
    if image is None or image.library:
        image = bpy.data.images.new(name, width, height, alpha=True)
    image.scale(width, height)
    values = np.ascontiguousarray(pixels[::-1], np.float32) / np.float32(255)
    image.pixels.foreach_set(values.ravel())
    image.update()
    image.pack()
    return image
