"""The lines of folds as GeoJSON, to be drawn, picked and edited elsewhere."""

import json

from . import _core


def check_folds(recipe):
    """InputError unless layers fold in the recipe."""
    if all(stage["stage"] != "fold_layers" for stage in recipe.to_dict()["stages"]):
        raise _core.InputError("folds: the recipe lacks the stage 'fold_layers'")


def write_folds(file, terrain):
    """Writes crests and troughs, in metres from the terrain's lower-left corner (`frame`)."""
    grid = terrain.grid
    frame = {
        "origin_m": list(grid.origin),
        "size_km": [n * grid.cell_size / 1000.0 for n in (grid.nx, grid.ny)],
    }
    if terrain.recipe.projection:
        frame["proj4"] = terrain.recipe.projection
    document = {
        "type": "FeatureCollection",
        "name": f"{terrain.name} folds",
        "units": "m",
        "frame": frame,
        "features": list(_features(terrain.folds, grid.origin)),
    }
    with open(file, "w", encoding="utf-8", newline="\n") as stream:
        json.dump(document, stream)
        stream.write("\n")


def _features(folds, origin):
    for fold in folds:
        skeleton = fold["skeleton"]
        for kind, lines in (("crest", skeleton.top), ("trough", skeleton.bottom)):
            for line in lines:
                points = (line.points - origin).round(2).tolist()
                if line.closed:
                    points.append(points[0])
                yield {
                    "type": "Feature",
                    "properties": {
                        "kind": kind,
                        "layer": fold["layer"],
                        "phase": fold["phase"],
                        "id": f"{line.id:016x}",
                    },
                    "geometry": {"type": "LineString", "coordinates": points},
                }
