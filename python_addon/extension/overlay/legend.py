"""The legend of the field that a terrain shows, in the lower right of the 3D view."""

import json

import blf
import bpy
import gpu
from gpu_extras.batch import batch_for_shader

from .. import terrains
from ..view import scales, show, ticks

FONT = 0
BACK, LIGHT, DIM = (0.06, 0.06, 0.06, 0.78), (0.95, 0.95, 0.95, 1.0), (0.72, 0.72, 0.72, 1.0)
SIZES = {"text": 12, "title": 13, "bar": 280, "thick": 16, "row": 19, "pad": 12, "margin": 18}


def draw():
    context = bpy.context
    legend = wanted(context)
    if legend is None:
        return
    pen = Pen(context.preferences.system.ui_scale)
    corner = _free_corner(context, pen.size["margin"])
    gpu.state.blend_set("ALPHA")
    if "rows" in legend:
        draw_rows(pen, legend, *corner)
    else:
        draw_bar(pen, legend, *corner)
    gpu.state.blend_set("NONE")


def wanted(context):
    """What is to be explained: of the active terrain, else of one that shows a field; or None."""
    if not context.space_data.overlay.show_overlays:
        return None
    active = terrains.active(context)
    for ob in [active] if active else context.view_layer.objects:
        if ob.orogen.is_terrain and ob.orogen.view.legend and ob.visible_get():
            if show.LEGEND in ob.data:
                return json.loads(ob.data[show.LEGEND])
    return None


def draw_bar(pen, legend, right, bottom):
    """A bar of colours from low to high, ticks below, name and unit above."""
    size, low, high = pen.size, legend["low"], legend["high"]
    logarithmic = legend["logarithmic"]
    width = size["bar"] + 2 * size["pad"]
    height = size["thick"] + 2 * size["row"] + 2.2 * size["pad"]
    left = right - width
    pen.box(left, bottom, width, height, BACK)
    x, y = left + size["pad"], bottom + size["row"] + 1.1 * size["pad"]
    pen.gradient(x, y, size["bar"], size["thick"], *scales.stops(legend["scale"]))
    for value in ticks.ticks(low, high, logarithmic):
        at = x + size["bar"] * ticks.share(value, low, high, logarithmic)
        pen.box(at - 0.5, y - 0.35 * size["pad"], 1, 0.35 * size["pad"], LIGHT)
        label = ticks.text(value)
        half = 0.5 * pen.width(label)
        start = min(max(at - half, left + 4), right - 4 - 2 * half)
        pen.write(label, start, bottom + 0.6 * size["pad"], LIGHT)
    title_at = y + size["thick"] + 0.7 * size["pad"]
    end = pen.write(legend["label"], x, title_at, LIGHT, "title")
    if legend["unit"]:
        pen.write(f"  {legend['unit']}", end, title_at, DIM)


def draw_rows(pen, legend, right, bottom):
    """A swatch and a name for each class."""
    size, rows = pen.size, legend["rows"]
    swatch = 1.5 * size["text"]
    names = [pen.width(name) for name, _ in rows]
    title = pen.width(legend["label"], "title")
    width = max(title, swatch + 0.7 * size["pad"] + max(names)) + 2 * size["pad"]
    height = (len(rows) + 1) * size["row"] + 1.6 * size["pad"]
    left = right - width
    pen.box(left, bottom, width, height, BACK)
    x, y = left + size["pad"], bottom + height - 0.6 * size["pad"] - size["row"]
    pen.write(legend["label"], x, y + 0.3 * size["text"], LIGHT, "title")
    for name, colour in rows:
        y -= size["row"]
        if colour is not None:
            pen.box(x, y, swatch, size["text"], [c / 255 for c in colour] + [1.0])
        pen.write(name, x + swatch + 0.7 * size["pad"], y + 0.08 * size["text"], LIGHT)


class Pen:
    """Boxes and text in the pixels of the region."""

    def __init__(self, scale):
        self.size = {name: value * scale for name, value in SIZES.items()}

    def box(self, x, y, width, height, colour):
        corners = [(x, y), (x + width, y), (x, y + height), (x + width, y + height)]
        shader = gpu.shader.from_builtin("UNIFORM_COLOR")
        shader.uniform_float("color", colour)
        batch_for_shader(shader, "TRI_STRIP", {"pos": corners}).draw(shader)

    def gradient(self, x, y, width, height, places, colours):
        shader = gpu.shader.from_builtin("SMOOTH_COLOR")
        corners, of_corners = [], []
        for place, colour in zip(places, colours, strict=True):
            at = x + width * place
            corners += [(at, y), (at, y + height)]
            of_corners += [(*colour, 1.0)] * 2
        batch = batch_for_shader(shader, "TRI_STRIP", {"pos": corners, "color": of_corners})
        batch.draw(shader)

    def width(self, text, kind="text"):
        blf.size(FONT, self.size[kind])
        return blf.dimensions(FONT, text)[0]

    def write(self, text, x, y, colour, kind="text"):
        """Returns where the text ends."""
        blf.size(FONT, self.size[kind])
        blf.color(FONT, *colour)
        blf.position(FONT, x, y, 0)
        blf.draw(FONT, text)
        return x + blf.dimensions(FONT, text)[0]


def _free_corner(context, margin):
    """The lower right corner that the sidebar, where it lies over the view, leaves free."""
    right = context.region.width
    if context.preferences.system.use_region_overlap:
        sidebar = next(r for r in context.area.regions if r.type == "UI")
        right -= sidebar.width if sidebar.width > 1 else 0
    return right - margin, margin
