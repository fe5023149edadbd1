"""Renders pictures of ready scenes into docs/images: ready_scene.jpg, and paper B's four views of
biomes (its figures 14 to 17).

    python docs/ready_scene.py [NAME...]

Needs the package bpy, and `orogen` on the search path; some minutes a picture.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
WIDTH, SAMPLES = 1280, 24
WISHES = {"variants": 1, "quality": 0.3, "reach": 3500.0, "eye_height": 62.0, "sun_elevation": 0.42}
LOW = WISHES | {"eye_height": 9.0, "reach": 2500.0, "cover_reach": 120.0}
ISLAND = {"peak_height": 800, "sea_depth": 250, "relief": 0.6, "lake_depth": 25}
TAIGA, DECIDUOUS, GRASSLAND, DESERT = 4, 8, 9, 12  # as the core counts biomes
TREE_LINE = 160.0  # m, of deciduous forest
RECIPE = {
    "orogen": 1,
    "name": "isle",
    "seed": 7,
    "resolution": 1024,
    "extent": {"origin": [0, 0], "size": [14000, 14000]},
    "stages": [
        {"stage": "island", "parameters": ISLAND},
        {"stage": "feature_curves"},
        {"stage": "hydraulic_erosion"},
        {"stage": "lakes"},
        {"stage": "biomes"},
        {"stage": "vegetation"},
    ],
}
PICTURES = {  # by name: what is painted, and the wishes
    "ready_scene": (None, WISHES),
    "paper_b_14_grassland": (lambda z: np.full_like(z, GRASSLAND), LOW),
    "paper_b_15_forest": (lambda z: np.full_like(z, DECIDUOUS), WISHES | {"eye_height": 36.0}),
    "paper_b_16_taiga": (lambda z: np.where(z > TREE_LINE, TAIGA, DECIDUOUS), WISHES),
    "paper_b_17_desert": (lambda z: np.full_like(z, DESERT), LOW),
}


def recipe_of(painted):
    if painted is None:
        return RECIPE
    import orogen

    terrain = orogen.generate(orogen.Recipe.from_dict({**RECIPE, "resolution": 256}))
    biome = orogen.pack_raster(painted(terrain["elevation"]).astype(np.float32))
    return {**RECIPE, "rasters": {"biome": biome}}


def render(name):
    sys.path.insert(0, str(ROOT / "python_addon"))
    import demo_scene

    painted, wishes = PICTURES[name]
    with tempfile.TemporaryDirectory() as folder:
        bpy = demo_scene.install_extension(Path(folder))
        recipe = Path(folder, "isle.orogen.json")
        recipe.write_text(json.dumps(recipe_of(painted)))
        demo_scene.grow(bpy, recipe)
        bpy.ops.orogen.make_ready_scene(**wishes)
        scene = bpy.context.scene
        scene.render.engine = "CYCLES"
        scene.cycles.samples, scene.cycles.use_denoising = SAMPLES, True
        scene.cycles.max_bounces, scene.cycles.diffuse_bounces = 6, 2
        scene.render.resolution_x, scene.render.resolution_y = WIDTH, WIDTH * 9 // 16
        scene.render.image_settings.file_format = "JPEG"
        scene.render.image_settings.quality = 85
        scene.render.filepath = str(IMAGES / f"{name}.jpg")
        bpy.ops.render.render(write_still=True)


def main(names):
    if len(names) == 1:
        render(names[0])
        sys.stdout.flush()
        os._exit(0)  # bpy's own end may hang
    for name in names or PICTURES:  # each in a Blender of its own
        subprocess.run([sys.executable, __file__, name], check=True)


if __name__ == "__main__":
    main(sys.argv[1:])
