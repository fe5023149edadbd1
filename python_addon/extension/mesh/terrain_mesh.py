"""A terrain's result in its object's mesh, updated in place."""

import json

from ..material import terrain_material
from ..view import show
from . import attributes, children, grid_mesh, growth_animation, sea

RECIPE = "orogen_recipe"  # JSON of what a terrain was grown from; a property of its mesh


class NotNow(RuntimeError):
    """The mesh cannot be written at the moment; the message says why."""


def check_writable(ob):
    if ob.mode != "OBJECT":
        raise NotNow(f"'{ob.name}' is in {ob.mode.replace('_', ' ').lower()} mode: leave it first")
    if ob.library or ob.data.library:
        raise NotNow(f"'{ob.name}' is linked from another file")


def write(ob, result, recipe):
    """Positions and attributes are rewritten while the grid keeps its size; else it is rebuilt.
    `recipe` is what the result was grown from."""
    check_writable(ob)
    growth_animation.remove(ob)
    mesh, grid, fields = ob.data, result.grid, result.fields
    nx, ny = grid["nx"], grid["ny"]
    if not grid_mesh.has_topology(mesh, nx, ny):
        grid_mesh.build_topology(mesh, nx, ny)
    mesh["orogen_cell_size"] = grid["cell_size"]
    mesh["orogen_offset"] = _offset(ob, grid)
    mesh["orogen_origin"] = grid["origin"]
    mesh[RECIPE] = json.dumps(recipe)
    mesh[attributes.ROCKS] = json.dumps(result.rocks)
    attributes.write(mesh, fields)
    _place(ob, fields["elevation"])
    if not mesh.materials:
        mesh.materials.append(terrain_material.ensure())
    sea.update(ob, below_sea=bool(fields["elevation"].min() < 0))
    set_look(ob)
    show.refresh(ob)


def rescale(ob):
    """Puts the vertices where the settings' scales want them. An animation of growth ends: it was
    written for other scales."""
    mesh = ob.data
    if "orogen_grid" not in mesh or ob.mode != "OBJECT":
        return
    nx, ny = mesh["orogen_grid"]
    if grid_mesh.has_topology(mesh, nx, ny) and "elevation" in mesh.attributes:
        growth_animation.remove(ob)
        _place(ob, attributes.read(mesh, "elevation", (ny, nx)))
        sea.update(ob, below_sea=sea.is_shown(ob))
        children.place_all(ob)


def set_look(ob):
    """Tells the material what the settings want to be seen."""
    layered = attributes.STRATA_COLOR in ob.data.attributes
    ob[terrain_material.STRATA] = ob.orogen.strata if layered else 0.0
    ob[terrain_material.SEA] = float(sea.is_shown(ob))
    ob[terrain_material.BARE_ROCK] = ob.orogen.bare_rock
    ob.update_tag()


def _offset(ob, grid):
    """Lower-left corner in metres from the object's origin. A drawing stays where it was drawn; a
    map from a file, whose projection may count from far away, is centred on the object."""
    if ob.orogen.is_drawn():
        return list(grid["origin"])
    cell = grid["cell_size"]
    return [-0.5 * grid["nx"] * cell, -0.5 * grid["ny"] * cell]


def _place(ob, elevation):
    mesh = ob.data
    grid = {"cell_size": mesh["orogen_cell_size"]}
    scale = ob.orogen.local_scale()
    ob[terrain_material.EXAGGERATION] = ob.orogen.vertical_exaggeration
    ob[terrain_material.METRES_PER_UNIT] = 1.0 / scale[1]
    offset = mesh["orogen_offset"]
    grid_mesh.set_positions(mesh, grid_mesh.positions(grid, offset, elevation, scale))
