"""Lines on the screen, of any width, in every Blender from 4.2 on."""

import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader


class Lines:
    """A line for each pair of points (n, 3), or (n, 2) in pixels. Called, it draws them."""

    def __init__(self, points, color, width):
        self._color, self._width = color, width
        self._shader = gpu.shader.from_builtin("POLYLINE_UNIFORM_COLOR")
        points = np.asarray(points, np.float32)
        if points.ndim == 2 and points.shape[1] == 2:
            points = np.insert(points, 2, 0.0, axis=1)
        data = {"pos": points}
        self._batch = batch_for_shader(self._shader, "LINES", data) if len(points) else None

    def __call__(self):
        if self._batch is None:
            return
        shader = self._shader
        shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
        shader.uniform_float("lineWidth", self._width)
        shader.uniform_float("color", self._color)
        gpu.state.blend_set("ALPHA")
        self._batch.draw(shader)
        gpu.state.blend_set("NONE")


class Triangles:
    """Triangles (3 n, 3) of one colour, or with a colour for each corner (3 n, 4). Called, it draws
    them."""

    def __init__(self, points, color):
        data = {"pos": np.asarray(points, np.float32)}
        each = np.ndim(color) == 2
        if each:
            data["color"] = np.asarray(color, np.float32)
        self._color = None if each else color
        self._shader = gpu.shader.from_builtin("SMOOTH_COLOR" if each else "UNIFORM_COLOR")
        self._batch = batch_for_shader(self._shader, "TRIS", data) if len(points) else None

    def __call__(self):
        if self._batch is None:
            return
        if self._color is not None:
            self._shader.uniform_float("color", self._color)
        gpu.state.blend_set("ALPHA")
        self._batch.draw(self._shader)
        gpu.state.blend_set("NONE")


def draw(points, color, width):
    """Draws lines that are not kept."""
    Lines(points, color, width)()


def shown_terrains(context):
    """The terrains whose overlays this view shows."""
    if not context.space_data.overlay.show_overlays:
        return []
    return [ob for ob in context.view_layer.objects if ob.orogen.is_terrain and ob.visible_get()]
