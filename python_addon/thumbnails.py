#!/usr/bin/env python3
"""Draws the thumbnails of the presets: each is grown, and rendered as a block where it has layers
of rock, else as land in its sea.

    ./dev thumbnails [NAME...]

Needs the package bpy, and the package `orogen` on the search path. NAME.jpg is written beside the
preset NAME.py.
"""

import math
import os
import sys
import tempfile
from pathlib import Path

import demo_collision
import demo_scene

PRESETS = Path(__file__).resolve().parent / "extension/presets/orogen/terrain"
SIZE = 256  # pixels
SAMPLES = 24
RESOLUTION = 512  # cells
RELIEF = 0.13  # height over width that a block is drawn with
BACK = (0.22, 0.27, 0.32)
VIEW_DEG = 32.0, 42.0  # off the south, and down


def grow(bpy, preset):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module=demo_scene.ADDON)
    bpy.ops.orogen.add_terrain()
    bpy.ops.orogen.load_preset(filepath=str(preset))
    terrain = bpy.context.object
    terrain.orogen.resolution = RESOLUTION
    bpy.ops.orogen.grow()
    bpy.context.view_layer.update()
    return terrain


def block(bpy, terrain):
    """On paper, from the south and above, with a long lens, so that it fills the picture."""
    relief = terrain.dimensions[2] / max(terrain.dimensions[:2])
    terrain.orogen.vertical_exaggeration *= min(max(RELIEF / relief, 1.0), 2.0)
    bpy.context.view_layer.update()
    bpy.ops.orogen.add_block()
    light(bpy)
    size, (turn, tilt) = math.hypot(*terrain.dimensions[:2]), map(math.radians, VIEW_DEG)
    away = (math.sin(turn) * math.cos(tilt), -math.cos(turn) * math.cos(tilt), math.sin(tilt))
    eye = [4.0 * size * part for part in away]
    demo_collision.add_camera(bpy, terrain, eye, (0.0, 0.0, -0.02 * size), lens=140.0)
    bpy.context.scene.view_settings.view_transform = "Standard"
    bpy.context.scene.view_settings.exposure = 0.5


def light(bpy):
    scene = bpy.context.scene
    demo_collision.add_paper(bpy, scene)
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (*BACK, 1.0)
    sun = bpy.data.objects.new("Lamp", bpy.data.lights.new("Lamp", "SUN"))
    sun.data.energy, sun.data.angle, sun.data.color = 4.0, math.radians(2.0), (1.0, 0.93, 0.82)
    sun.rotation_euler = (math.radians(60.0), 0.0, math.radians(-50.0))
    scene.collection.objects.link(sun)


def draw(bpy, preset):
    terrain = grow(bpy, preset)
    scene = bpy.context.scene
    if "strata_color" in terrain.data.attributes:
        block(bpy, terrain)
    else:
        demo_scene.build_scene(bpy, terrain)
        scene.camera.data.lens = 64.0
        scene.view_settings.exposure = 0.7
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.render.engine, scene.cycles.samples = "CYCLES", SAMPLES
    scene.cycles.use_denoising, scene.cycles.max_bounces = True, 3
    scene.render.image_settings.file_format = "JPEG"
    scene.render.image_settings.quality = 88
    scene.render.filepath = str(preset.with_suffix(".jpg"))
    bpy.ops.render.render(write_still=True)


def main():
    wanted = sys.argv[1:]
    presets = [file for file in sorted(PRESETS.glob("*.py")) if file.stem in wanted or not wanted]
    with tempfile.TemporaryDirectory() as resources:
        bpy = demo_scene.install_extension(Path(resources))
        for preset in presets:
            draw(bpy, preset)
            print(preset.with_suffix(".jpg"), flush=True)
        bpy.ops.preferences.addon_disable(module=demo_scene.ADDON)
    sys.stdout.flush()
    os._exit(0)  # bpy's own end may hang


if __name__ == "__main__":
    main()
