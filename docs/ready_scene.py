"""Renders docs/images/ready_scene.jpg, of docs/blender_plants.md.

    python docs/ready_scene.py

Needs the package bpy, and `orogen` on the search path; some ten minutes.
"""

import json
import os
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PICTURE = ROOT / "docs" / "images" / "ready_scene.jpg"
WIDTH, SAMPLES = 1280, 24
WISHES = {"variants": 1, "quality": 0.3, "reach": 3500.0, "eye_height": 62.0, "sun_elevation": 0.42}
ISLAND = {"peak_height": 800, "sea_depth": 250, "relief": 0.6, "lake_depth": 25}
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


def main():
    sys.path.insert(0, str(ROOT / "python_addon"))
    import demo_scene

    with tempfile.TemporaryDirectory() as folder:
        bpy = demo_scene.install_extension(Path(folder))
        recipe = Path(folder, "isle.orogen.json")
        recipe.write_text(json.dumps(RECIPE))
        demo_scene.grow(bpy, recipe)
        bpy.ops.orogen.make_ready_scene(**WISHES)
        scene = bpy.context.scene
        scene.render.engine = "CYCLES"
        scene.cycles.samples, scene.cycles.use_denoising = SAMPLES, True
        scene.cycles.max_bounces, scene.cycles.diffuse_bounces = 6, 2
        scene.render.resolution_x, scene.render.resolution_y = WIDTH, WIDTH * 9 // 16
        scene.render.image_settings.file_format = "JPEG"
        scene.render.image_settings.quality = 85
        scene.render.filepath = str(PICTURE)
        bpy.ops.render.render(write_still=True)
    sys.stdout.flush()
    os._exit(0)  # bpy's own end may hang


if __name__ == "__main__":
    main()
