"""Making grease pencil: objects, layers, strokes, for every generation of it (see strokes.py)."""

import bpy
import numpy as np

COLORS = {  # of layers, by name; linear
    "Coast": (0.85, 0.72, 0.45),
    "Rivers": (0.08, 0.35, 1.00),
    "Lakes": (0.08, 0.70, 0.95),
    "Peaks": (1.00, 0.25, 0.06),
    "Plate": (1.00, 0.45, 0.05),
    "Ridge": (0.95, 0.60, 0.10),
    "Valley": (0.25, 0.75, 0.20),
    "Cliff": (0.80, 0.20, 0.50),
    "River Bed": (0.10, 0.65, 0.80),
}
STARTS = sorted(COLORS.items(), reverse=True)  # "River Bed" before "Rivers"
WIDTH = 6  # pixels, before 4.3
RADIUS = 0.003  # of the drawing's size, from 4.3


def new(name, size):
    """A grease-pencil object without layers, not yet in a collection. Its lines are as wide as a
    drawing of that size wants, whatever the brush."""
    pencils = getattr(bpy.data, "grease_pencils_v3", bpy.data.grease_pencils)
    ob = bpy.data.objects.new(name, pencils.new(name))
    ob.show_in_front = True  # ground that grows hides no line
    ob.hide_render = True
    if ob.type == "GPENCIL":
        ob.data.stroke_thickness_space = "SCREENSPACE"
    else:
        width = ob.modifiers.new("Width", "GREASE_PENCIL_THICKNESS")
        width.use_uniform_thickness, width.thickness = True, RADIUS * size
    return ob


def ensure_layer(ob, name, frame):
    """The layer of that name, active, with something to draw on at a frame."""
    layer = ob.data.layers.get(name) or ob.data.layers.new(name)
    if not any(key.frame_number <= frame for key in layer.frames):
        layer.frames.new(frame)
    ob.data.layers.active = layer
    ob.active_material_index = _ensure_material(ob, name)
    return layer


def active_layer(ob):
    """The name of the layer that is drawn on, or ""."""
    layer = ob.data.layers.active
    return getattr(layer, "info" if ob.type == "GPENCIL" else "name", "")


def add_strokes(ob, name, lines, frame, cyclic=False):
    """Strokes on a layer from lines (n, 2) on the object's plane, in its own units."""
    layer = ensure_layer(ob, name, frame)
    on = next(key for key in layer.frames if key.frame_number <= frame)
    lines = [np.insert(np.asarray(line, np.float32).reshape(-1, 2), 2, 0, axis=1) for line in lines]
    add = _add_before_4_3 if ob.type == "GPENCIL" else _add
    if lines:
        add(ob, on, lines, cyclic)


def _add(ob, frame, lines, cyclic):
    drawing = frame.drawing
    first = len(drawing.strokes)
    before = len(drawing.attributes["position"].data) if first else 0
    drawing.add_strokes([len(line) for line in lines])
    positions = drawing.attributes["position"].data
    values = np.empty(len(positions) * 3, np.float32)
    positions.foreach_get("vector", values)
    values[3 * before :] = np.concatenate(lines).ravel()
    positions.foreach_set("vector", values)
    for stroke in list(drawing.strokes)[first:]:
        stroke.cyclic, stroke.material_index = cyclic, ob.active_material_index


def _add_before_4_3(ob, frame, lines, cyclic):
    for line in lines:
        stroke = frame.strokes.new()
        stroke.points.add(len(line))
        stroke.points.foreach_set("co", line.ravel())
        stroke.use_cyclic, stroke.line_width = cyclic, WIDTH
        stroke.material_index = ob.active_material_index


def _ensure_material(ob, layer):
    """The slot of the layer's material."""
    color = next((c for start, c in STARTS if layer.startswith(start)), COLORS["Coast"])
    name = f"Orogen {layer}"
    material = bpy.data.materials.get(name) or bpy.data.materials.new(name)
    if not material.is_grease_pencil:
        bpy.data.materials.create_gpencil_data(material)
        material.grease_pencil.color = (*color, 1.0)
    if name not in ob.data.materials:
        ob.data.materials.append(material)
    return ob.data.materials.find(name)
