"""Crests of folds as meshes to be edited: one for each layer and phase, children of the terrain, in
metres. A vertex is as high as its layer folds there."""

import json

import bpy
import numpy as np

from .. import fold_edits
from . import attributes, children

COLOURS = ((0.85, 0.25, 0.05), (0.95, 0.65, 0.05), (0.10, 0.50, 0.80), (0.35, 0.65, 0.15))  # linear


def write(terrain, networks):
    """`networks`: {"layer 2, phase 1": {points, edges}}. They replace what was edited, whose edits
    go on in them."""
    kept = fold_edits.of(terrain)
    clear(terrain)
    folds = bpy.data.collections.new(f"{terrain.name} Folds")
    terrain.users_collection[0].children.link(folds)
    terrain.orogen.folds = folds
    several = any(not part.endswith("phase 1") for part in networks)
    for part, network in networks.items():
        layer, phase = (int(word.split()[1]) for word in part.split(", "))
        name = f"{terrain.name} Folds Layer {layer}" + (f" Phase {phase}" if several else "")
        ob = bpy.data.objects.new(name, _mesh(name, **network))
        ob.parent = terrain
        ob.show_in_front = True
        ob.color = (*COLOURS[(layer - 1) % len(COLOURS)], 1.0)
        folds.objects.link(ob)
        children.place(ob, terrain, terrain.data["orogen_offset"])
        ob[fold_edits.WHERE] = [layer, phase]
        ob[fold_edits.ORIGIN] = list(terrain.data["orogen_origin"])
        ob[fold_edits.START] = network["points"].ravel().tolist()
        ob[fold_edits.EDGES] = network["edges"].ravel().tolist()
        own = [edit for edit in kept if (edit["layer"], edit["phase"]) == (layer, phase)]
        ob[fold_edits.KEPT] = json.dumps(own)


def clear(terrain):
    """A copy of the terrain may go on with them."""
    objects, folds = fold_edits.objects_of(terrain), terrain.orogen.folds
    terrain.orogen.folds = None
    if folds and not any(ob.orogen.folds == folds for ob in bpy.data.objects):
        for ob in objects:
            children.remove(ob)
        bpy.data.collections.remove(folds)


def _mesh(name, points, edges):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points.tolist(), edges.tolist(), [])
    numbers = np.arange(1, len(points) + 1, dtype=np.int32)
    attributes.write_values(mesh, fold_edits.NUMBER, numbers, "POINT")
    return mesh
