"""Colours the ground by a field.

Colours lie in a colour attribute of the mesh, which is its active one: the solid viewport shows it
(Color: Attribute), exporters take it along, and a material of its own shows it everywhere else.
That material stands in the object's slot while a field is shown; the mesh keeps its own.
"""

import json

import numpy as np

from ..material import view_material
from ..mesh import attributes, colors, sea
from . import fields, scales, tiles

NATURAL = "MATERIAL"
ATTRIBUTE = "orogen_view"
LEGEND = "orogen_legend"  # JSON; a property of the mesh
MOST_ROWS = 18


def shown_field(ob):
    """The field that is to be seen and that the terrain has, else None."""
    name = ob.orogen.view.field
    return fields.known()[name] if name != NATURAL and name in fields.names(ob.data) else None


def refresh(ob):
    """After the ground or a setting changed."""
    mesh = ob.data
    if ob.mode != "OBJECT" or ob.library or mesh.library or "orogen_grid" not in mesh:
        return
    field = shown_field(ob)
    sea.hide_from_view(ob, field is not None)  # it would tint the colours
    if field is None:
        clear(mesh)
        _wear(ob, None)
    else:
        legend = {"label": field.label, **_legend(mesh, field, ob.orogen.view)}
        colour(mesh, field, legend)
        mesh[LEGEND] = json.dumps(legend)
        _wear(ob, view_material.ensure())
        ob.update_tag()
    tiles.wake()


def colour(mesh, field, legend):
    """Writes the colours of a field that the mesh has, as a legend says."""
    if field.name == fields.STRATA:
        rgba = np.empty((len(mesh.vertices), 4), np.float32)
        mesh.attributes[fields.STRATA].data.foreach_get("color", rgba.ravel())
    elif field.type == "int32":
        rgba = colors.to_linear(fields.class_colours(field, fields.values(mesh, field)))
    else:
        rgba = of_numbers(fields.values(mesh, field), legend)
    attributes.write_linear(mesh, ATTRIBUTE, rgba, "POINT")
    mesh.color_attributes.active_color = mesh.attributes[ATTRIBUTE]
    mesh.color_attributes.render_color_index = mesh.color_attributes.active_color_index


def in_solid_view(context, coloured):
    """Lets the solid viewports show the attribute, or the material again."""
    before, after = ("MATERIAL", "VERTEX") if coloured else ("VERTEX", "MATERIAL")
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D" and area.spaces.active.shading.color_type == before:
                area.spaces.active.shading.color_type = after
            area.tag_redraw()


def clear(mesh):
    if attribute := mesh.attributes.get(ATTRIBUTE):
        mesh.attributes.remove(attribute)
    mesh.pop(LEGEND, None)


def _legend(mesh, field, view):
    if field.name == fields.STRATA:
        return _strata(mesh)
    numbers = fields.values(mesh, field)
    if field.type == "int32":
        return _classes(mesh, field, numbers)
    return _bar(field, numbers, view)


def _bar(field, numbers, view):
    logarithmic = field.name in fields.LOGARITHMIC
    if view.automatic:
        view.low, view.high = _best_range(numbers, logarithmic, view.scale)
    low, high = view.low, max(view.high, view.low + 1e-6 * abs(view.low) + 1e-12)
    scale = _best_scale(field, low, high) if view.scale == "AUTO" else view.scale
    if logarithmic:
        low = max(low, 1e-12)
        high = max(high, 1.001 * low)
    legend = {"unit": fields.shown_unit(field), "scale": scale, "low": low, "high": high}
    return {**legend, "logarithmic": logarithmic}


def of_numbers(numbers, legend):
    """Linear colours (n, 4) of numbers, as a legend says."""
    low, high = legend["low"], legend["high"]
    if legend["logarithmic"]:
        share = np.log(np.maximum(numbers, 1e-30) / low) / np.log(high / low)
    else:
        share = (numbers - low) / (high - low)
    return colors.to_linear(scales.table(legend["scale"]))[scales.step_of(share)]


def _best_range(numbers, logarithmic, scale):
    """The usual one; alike on both sides of 0 where colours part there."""
    low, high = fields.usual_range(numbers, logarithmic)
    if scale in ("AUTO", "VIK", "OLERON") and fields.two_sided(low, high):
        return -max(-low, high), max(-low, high)
    return low, high


def _best_scale(field, low, high):
    is_height = field.name == "elevation"
    if fields.two_sided(low, high):
        return "OLERON" if is_height else "VIK"
    return "BATLOW" if is_height else "VIRIDIS"


def _classes(mesh, field, numbers):
    names = fields.class_names(mesh, field)
    classes = np.unique(numbers)
    rows = [
        (names.get(int(k), str(k)), colour.tolist())
        for k, colour in zip(classes, fields.class_colours(field, classes), strict=True)
    ]
    return {"rows": _cut(rows)}


def _strata(mesh):
    rocks = fields.rocks(mesh)[::-1]
    if len(rocks) > MOST_ROWS:  # a row a layer
        rocks = list({item["layer"]: {**item, "lithology": ""} for item in rocks}.values())
    rows = {
        ", ".join(filter(None, (item["name"], item["lithology"]))): item["color"] for item in rocks
    }
    return {"label": "Strata", "rows": _cut(list(rows.items()))}


def _cut(rows):
    more = len(rows) - MOST_ROWS
    return rows if more <= 0 else [*rows[:MOST_ROWS], (f"and {more} more", None)]


def _wear(ob, material):
    """Puts the view's material into the object's first slot; None: what was there comes back."""
    if not ob.material_slots:
        return
    slot, view = ob.material_slots[0], ob.orogen.view
    wears_it = slot.link == "OBJECT" and view_material.is_it(slot.material)
    if material and not wears_it:
        view.own_material = slot.material if slot.link == "OBJECT" else None
        slot.link = "OBJECT"
        slot.material = material
    elif material is None and wears_it:
        slot.material = view.own_material
        slot.link = "OBJECT" if view.own_material else "DATA"
        view.own_material = None
