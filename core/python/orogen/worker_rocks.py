"""Meshes of the rocks below a terrain, as a worker hands them over.

A mesh is `vertices` (n, 3) in metres, counted from the grid's lower-left corner, `faces` (m, 4),
whose corners may be named twice, and of each face `layer`, `sub_layer` and `color` (sRGB bytes).
"""

import numpy as np

from . import _core


def make_meshes(terrain, request):
    """The meshes that a request asks for: a dictionary of dictionaries, by name.

    Parameters
    ----------
    terrain : Terrain
    request : dict
        `kind`: "block" (walls and base below the ground; with `top` the ground too), "section"
        (along `line`, places in metres on the terrain's map) or "horizons" (what of each lies below
        ground). `base`: height in metres of the lower edge of block and section, or None.

    Raises
    ------
    InputError
        The terrain has no rocks, or a request cannot be met.
    """
    rocks = terrain.rocks
    if rocks is None:
        raise _core.InputError("column: the recipe has none, so there are no rocks to show")
    kind, base = request["kind"], request.get("base")
    if kind == "block":
        block = rocks.block_diagram(base)
        return {"block": block if request.get("top") else _without_ground(block, terrain.grid)}
    if kind == "section":
        line = [tuple(place) for place in request["line"]]
        return {"section": rocks.section(line, base=base).mesh()}
    if kind == "horizons":
        return _horizons(rocks)
    raise _core.InputError(f"kind: there is no '{kind}'; block, section or horizons is wanted")


def _horizons(rocks):
    column = rocks.column
    names = [column["basement"]["name"], *(layer["name"] for layer in column["layers"])]
    meshes = {}
    for k, name in enumerate(names):
        mesh = rocks.horizon_mesh(k)
        if len(mesh["faces"]):
            meshes[f"{k} {name}"] = _compact(mesh)
    return meshes


def _without_ground(block, grid):
    """The block without the terrain's own surface, whose faces come first."""
    ground = (grid.nx - 1) * (grid.ny - 1)
    return _compact({k: v if k == "vertices" else v[ground:] for k, v in block.items()})


def _compact(mesh):
    """The mesh without vertices that no face names."""
    used, faces = np.unique(mesh["faces"], return_inverse=True)
    faces = faces.reshape(mesh["faces"].shape).astype(np.int32)
    return {**mesh, "vertices": mesh["vertices"][used], "faces": faces}
