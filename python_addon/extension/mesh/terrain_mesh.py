"""A terrain's result in its object's mesh, updated in place."""

import json

from .. import recipe as recipes
from .. import terrains
from ..material import biome_colors, terrain_material
from ..view import show
from . import (
    attributes,
    children,
    frozen,
    grid_mesh,
    growth_animation,
    lakes,
    large_ground,
    middle,
    painted,
    sea,
    surroundings,
    uv,
)
from . import ground as grounds
from .roles import with_role

# Properties of a terrain's mesh.
RECIPE = "orogen_recipe"  # JSON of what it was grown from; a preview has none
GROWN_FROM = "orogen_grown_from"  # fingerprint of the recipe
PREVIEW = "orogen_preview"  # whether it is one


class NotNow(RuntimeError):
    """The mesh cannot be written at the moment; the message says why."""


def check_writable(ob):
    if ob.mode != "OBJECT":
        raise NotNow(f"'{ob.name}' is in {ob.mode.replace('_', ' ').lower()} mode: leave it first")
    if ob.library or ob.data.library:
        raise NotNow(f"'{ob.name}' is linked from another file")


def grown_from(ob):
    return ob.data.get(GROWN_FROM)


def is_preview(ob):
    return bool(ob.data.get(PREVIEW))


def write_large(ob, result, recipe):
    """Writes ground that is too large for one mesh: a generator that does a part at each step."""
    check_writable(ob)
    uid, tiles = ob.session_uid, large_ground.Tiles()
    offset, scale = offset_of(ob, result.grid), ob.orogen.local_scale()
    try:
        yield from tiles.make(result.grid, result.fields, offset, scale)
        ob = terrains.by_uid(uid)
        if ob is None:
            raise NotNow("The terrain that was to grow is gone")
        check_writable(ob)
        grid, fields, offset = large_ground.coarsened(result.grid, result.fields, offset)
        _write(ob, grid, fields, offset, result.rocks, recipe)
        tiles.put(ob)
        show.refresh(ob)
    finally:
        tiles.drop()


def write(ob, result, recipe, is_preview=False):
    """Positions and attributes are rewritten while the grid keeps its size; else it is rebuilt.
    `recipe` is what the result was grown from."""
    check_writable(ob)
    offset = offset_of(ob, result.grid)
    _write(ob, result.grid, result.fields, offset, result.rocks, recipe, is_preview)
    large_ground.remove(ob)
    show.refresh(ob)


def _write(ob, grid, fields, offset, rocks, recipe, is_preview=False):
    growth_animation.remove(ob)
    mesh = ob.data
    mesh["orogen_origin"] = grid["origin"]
    middle.keep(mesh, grid)
    mesh[GROWN_FROM], mesh[PREVIEW] = recipes.fingerprint(recipe), is_preview
    mesh[attributes.ROCKS] = json.dumps(rocks)
    mesh.pop(RECIPE, None)
    if not is_preview:
        mesh[RECIPE] = json.dumps(recipe)
    if is_preview and ob.orogen.paints.freeze:
        frozen.keep(mesh)
    else:
        frozen.thaw(mesh)
    fill(ob, ob.orogen, grid, fields, offset)


def fill(ob, settings, grid, fields, offset):
    """Writes the mesh of an object, and the sea over it. `offset`: its lower-left corner (m)."""
    mesh, nx, ny = ob.data, grid["nx"], grid["ny"]
    if not grid_mesh.has_topology(mesh, nx, ny):
        paint, has_uv = painted.take(mesh), uv.LAYER in mesh.uv_layers
        grid_mesh.build_topology(mesh, nx, ny)
        painted.put(mesh, paint)
        if has_uv:
            uv.write(mesh, uv.of_grid(nx, ny))
    mesh["orogen_cell_size"], mesh["orogen_offset"] = grid["cell_size"], offset
    attributes.write(mesh, fields)
    _place(ob, settings, fields["elevation"])
    if not mesh.materials:
        mesh.materials.append(terrain_material.ensure())
    sea.update(ob, settings, below_sea=bool(fields["elevation"].min() < 0))
    _set_look(ob, settings)
    surroundings.update(ob)
    if lakes.of(ob):
        lakes.update(ob)


def rescale(ob):
    """Puts the vertices where the settings' scales want them. An animation of growth ends: it was
    written for other scales."""
    mesh = ob.data
    if "orogen_grid" not in mesh or ob.mode != "OBJECT":
        return
    nx, ny = mesh["orogen_grid"]
    if grid_mesh.has_topology(mesh, nx, ny) and "elevation" in mesh.attributes:
        growth_animation.remove(ob)
        _place(ob, ob.orogen, attributes.read(mesh, "elevation", (ny, nx)))
        sea.update(ob, ob.orogen, below_sea=sea.is_shown(ob))
        surroundings.update(ob)
        children.place_all(ob)
        large_ground.place_all(ob)


def set_look(ob):
    """Tells the material what the settings want to be seen, on all of the ground."""
    _set_look(ob, ob.orogen)
    for role in (large_ground.ROLE, surroundings.ROLE):
        for piece in with_role(ob, role):
            grounds.dress(piece, ob)


def _set_look(ob, settings):
    layered = attributes.STRATA_COLOR in ob.data.attributes
    ob[terrain_material.STRATA] = settings.strata if layered else 0.0
    ob[terrain_material.SEA] = float(sea.is_shown(ob))
    ob[terrain_material.BIOMES] = float(biome_colors.ATTRIBUTE in ob.data.attributes)
    ob[terrain_material.BARE_ROCK] = settings.bare_rock
    ob.update_tag()


def offset_of(ob, grid):
    """Lower-left corner in metres from the object's origin. A drawing stays where it was drawn; a
    map from a file, whose projection may count from far away, is centred on the object."""
    return list(grid["origin"]) if ob.orogen.is_drawn() else centred(grid)


def centred(grid):
    return [-0.5 * grid[n] * grid["cell_size"] for n in ("nx", "ny")]


def _place(ob, settings, elevation):
    mesh = ob.data
    grid = {"cell_size": mesh["orogen_cell_size"]}
    scale = settings.local_scale()
    ob[terrain_material.EXAGGERATION] = settings.vertical_exaggeration
    ob[terrain_material.METRES_PER_UNIT] = 1.0 / scale[1]
    offset = mesh["orogen_offset"]
    grid_mesh.set_positions(mesh, grid_mesh.positions(grid, offset, elevation, scale))
