#!/usr/bin/env python3
"""Grows a recipe in Blender with the extension, and renders a picture of it.

    python python_addon/demo_scene.py FOLDER [--samples N] [--width PIXELS]

Needs the package bpy, and the package `orogen` on the search path. FOLDER holds NAME.orogen.json;
NAME.blend and NAME.png are written beside it, and for a range with layers of rock NAME_block.png.
"""

import argparse
import importlib
import os
import sys
import tempfile
from pathlib import Path

import demo_collision

ADDON = "bl_ext.user_default.orogen"
HERE = Path(__file__).resolve().parent

EXAGGERATION, FARTHER = 1.4, 2.2
TIME_LIMIT = 150.0  # s for the rendering; what noise is left then, the denoiser takes


def install_extension(resources):
    """The extension from its source, with the declarations of the core at hand, in a Blender whose
    user folder is `resources`."""
    sys.path.insert(0, str(HERE))
    import build

    core = Path(importlib.util.find_spec("orogen").origin).parent.parent
    build.assemble(resources / "extensions" / "user_default" / "orogen", core)
    os.environ["BLENDER_USER_RESOURCES"] = str(resources)
    import bpy

    return bpy


def grow(bpy, recipe):
    """The terrain of a recipe in an empty file."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module=ADDON)
    bpy.ops.orogen.load_map(filepath=str(recipe))
    bpy.ops.orogen.grow()
    bpy.context.view_layer.update()
    return bpy.context.object


def build_scene(bpy, terrain):
    terrain.orogen.vertical_exaggeration = EXAGGERATION
    whole = "strata_color" not in terrain.data.attributes  # an island, not a range
    bpy.ops.orogen.set_up_scene(farther=FARTHER if whole else 1.0)


def draw(bpy, terrain, file, width, samples):
    """NAME.png and NAME.blend; of a range with layers of rock NAME_block.png before."""
    if "strata_color" in terrain.data.attributes:
        demo_collision.build_block(bpy, terrain)
        block = file.with_name(f"{file.name}_block.png")
        render(bpy, block, width, samples, transform="Standard")
        terrain = grow(bpy, terrain.orogen.path)
    build_scene(bpy, terrain)
    render(bpy, file.with_suffix(".png"), width, samples)
    bpy.ops.wm.save_as_mainfile(filepath=str(file.with_suffix(".blend")), compress=True)


def render(bpy, file, width, samples, transform="AgX"):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.time_limit = samples, TIME_LIMIT
    scene.cycles.use_denoising = True
    scene.cycles.diffuse_bounces = 1
    scene.cycles.max_bounces, scene.cycles.transparent_max_bounces = 2, 4
    scene.render.resolution_x, scene.render.resolution_y = width, width * 10 // 16
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = str(file)
    scene.view_settings.view_transform = transform
    scene.view_settings.look = "AgX - High Contrast" if transform == "AgX" else "None"
    bpy.ops.render.render(write_still=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--samples", type=int, default=32)
    parser.add_argument("--width", type=int, default=1280)
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    recipe = next(folder.glob("*.orogen.json"))
    name = recipe.name.removesuffix(".orogen.json")
    with tempfile.TemporaryDirectory() as resources:
        bpy = install_extension(Path(resources))
        draw(bpy, grow(bpy, recipe), folder / name, arguments.width, arguments.samples)
        bpy.ops.preferences.addon_disable(module=ADDON)
    print(f"{folder / name}.png and .blend")
    sys.stdout.flush()
    os._exit(0)  # bpy's own end may hang


if __name__ == "__main__":
    main()
