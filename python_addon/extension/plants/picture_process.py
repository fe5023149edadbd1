"""Runs in a Blender of its own, without a window, and renders what `pictures.py` asks for.

    blender --background --factory-startup --python picture_process.py -- FOLDER

FOLDER holds `wanted.json`, a list, and the meshes of its plants in `meshes.npz`; what the n-th
looks like becomes `n.npy`: colours and normals, (2, rows, columns, 4).
"""

import importlib
import json
import os
import sys
import types
from pathlib import Path

import bpy
import numpy as np


def main(folder):
    plant_mesh, impostor_render = (_module(name) for name in ("plant_mesh", "impostor_render"))
    meshes = np.load(folder / "meshes.npz")
    for number, wanted in enumerate(json.loads((folder / "wanted.json").read_text("utf-8"))):
        mesh = bpy.data.meshes.new("Plant")
        arrays = {name: meshes[f"{number}/{name}"] for name in plant_mesh.ARRAYS}
        plant_mesh.write(mesh, arrays)
        tile = impostor_render.Tile(**wanted["tile"])
        pictures = impostor_render.render(mesh, wanted["colors"], tile, wanted["angles"])
        bpy.data.meshes.remove(mesh)
        unfinished = folder / "unfinished.npy"
        np.save(unfinished, np.stack(pictures))
        unfinished.rename(folder / f"{number}.npy")


def _module(name):
    """One of the extension's, which is not registered here."""
    if "extension" not in sys.modules:
        extension = sys.modules["extension"] = types.ModuleType("extension")
        extension.__path__ = [str(Path(__file__).resolve().parent.parent)]
    return importlib.import_module(f"extension.plants.{name}")


if __name__ == "__main__":
    main(Path(sys.argv[-1]))
    sys.stdout.flush()
    os._exit(0)  # bpy's own end may hang
