"""Lines on the screen, of any width, in every Blender from 4.2 on."""

import gpu
from gpu_extras.batch import batch_for_shader


def draw(points, color, width):
    """A line for each pair of points (n, 3), or (n, 2) in pixels."""
    if not len(points):
        return
    shader = gpu.shader.from_builtin("POLYLINE_UNIFORM_COLOR")
    points = [(*point, 0.0)[:3] for point in points]
    batch = batch_for_shader(shader, "LINES", {"pos": points})
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    shader.uniform_float("lineWidth", width)
    shader.uniform_float("color", color)
    gpu.state.blend_set("ALPHA")
    batch.draw(shader)
    gpu.state.blend_set("NONE")


def shown_terrains(context):
    """The terrains whose overlays this view shows."""
    if not context.space_data.overlay.show_overlays:
        return []
    return [ob for ob in context.view_layer.objects if ob.orogen.is_terrain and ob.visible_get()]
