"""What a worker makes of a terrain when it is asked for `rocks`: meshes, lines, pictures, files.

A result is a dictionary of dictionaries of arrays, by name. A mesh of rock is `vertices` (n, 3) in
metres, counted from the grid's lower-left corner, `faces` (m, 4), whose corners may be named twice,
and of each face `layer`, `sub_layer` and `color` (sRGB bytes).
"""

import numpy as np

from . import _core, worker_files, worker_lines


def make_meshes(terrain, request):
    """What a request asks for.

    Parameters
    ----------
    terrain : Terrain
    request : dict
        `kind`, a name in KINDS: "block" (walls and base below the ground; with `top` the ground
        too), "section" (along `line`, places in metres on the terrain's map), "horizons" (what of
        each lies below ground), "tin" (the triangles that mountains grew on); lines
        (worker_lines.py); pictures and files (worker_files.py). `base`: height in metres of the
        lower edge of block and section, or None.

    Raises
    ------
    InputError
        The terrain has none of it, or a request cannot be met.
    """
    make = KINDS.get(request["kind"])
    if make is None:
        raise _core.InputError(
            f"kind: there is no '{request['kind']}'; one of {', '.join(KINDS)} is wanted"
        )
    return make(terrain, request)


def describe_rocks(terrain):
    """What the layers of a terrain are called, with their colours: a list of dictionaries from the
    bottom up, a sub-layer each, loose sediment last; `number` as in rock volumes. Those that are
    neither at the surface nor below the map's diagonals are left out."""
    rocks = terrain.rocks
    if rocks is None:
        return []
    column = rocks.column
    layers = [column["basement"], *column["layers"]]
    first = np.cumsum([1, *(len(layer["sub_layers"]) for layer in layers)])
    described = []
    for (layer, sub_layer), color in sorted(_colors(terrain).items()):
        name, lithology = "sediment", "loose sediment"
        if layer < len(layers):
            name = layers[layer]["name"]
            lithology = layers[layer]["sub_layers"][sub_layer]["lithology"]
        described.append(
            {
                "layer": layer,
                "sub_layer": sub_layer,
                "number": int(first[layer]) + sub_layer,
                "name": name,
                "lithology": lithology,
                "color": color,
            }
        )
    return described


def _colors(terrain):
    """The colour of each (layer, sub-layer) that is found."""
    (west, south), grid = terrain.grid.origin, terrain.grid
    east, north = west + grid.nx * grid.cell_size, south + grid.ny * grid.cell_size
    found = {}
    for line in ([(west, south), (east, north)], [(west, north), (east, south)]):
        for band in terrain.rocks.section(line).bands:
            found[band["layer"], band["sub_layer"]] = list(band["color"])
    at_surface = 64 * terrain["rock_layer"].ravel() + terrain["rock_sublayer"].ravel()
    for key in np.flatnonzero(np.bincount(at_surface)).tolist():
        color = int(terrain["strata_color"].flat[(at_surface == key).argmax()])
        found[divmod(key, 64)] = [color >> shift & 255 for shift in (16, 8, 0)]
    return found


def _block(terrain, request):
    block = worker_files.rocks_of(terrain).block_diagram(request.get("base"))
    return {"block": block if request.get("top") else _without_ground(block, terrain.grid)}


def _section(terrain, request):
    return {"section": worker_files.section_of(terrain, request).mesh()}


def _horizons(terrain, _request):
    rocks = worker_files.rocks_of(terrain)
    meshes = {}
    for k, name in enumerate(worker_lines.horizon_names(rocks)):
        mesh = rocks.horizon_mesh(k)
        if len(mesh["faces"]):
            meshes[f"{k} {name}"] = _compact(mesh)
    return meshes


def _tin(terrain, _request):
    tin = terrain.tin
    if tin is None:
        raise _core.InputError(
            "tin: the recipe lacks the stage 'mountain_growth', so nothing grew on triangles"
        )
    places = tin.points - np.asarray(terrain.grid.origin)
    vertices = np.hstack([places, tin.elevation[:, None]]).astype(np.float32)
    return {"tin": {"vertices": vertices, "triangles": tin.triangles}}


def _without_ground(block, grid):
    """The block without the terrain's own surface, whose faces come first."""
    ground = (grid.nx - 1) * (grid.ny - 1)
    return _compact({k: v if k == "vertices" else v[ground:] for k, v in block.items()})


def _compact(mesh):
    """The mesh without vertices that no face names."""
    used, faces = np.unique(mesh["faces"], return_inverse=True)
    faces = faces.reshape(mesh["faces"].shape).astype(np.int32)
    return {**mesh, "vertices": mesh["vertices"][used], "faces": faces}


KINDS = {
    "block": _block,
    "section": _section,
    "horizons": _horizons,
    "tin": _tin,
    "traces": worker_lines.traces,
    "folds": worker_lines.folds,
    "fold_edges": worker_lines.fold_edges,
    "rivers": worker_lines.rivers,
    "picture": worker_files.picture,
    "section_file": worker_files.section_file,
    "volume": worker_files.volume,
    "save": worker_files.save,
}
