#!/usr/bin/env python3
"""Grows a recipe in Blender with the extension, and renders a picture of it.

    python python_addon/demo_scene.py FOLDER [--samples N] [--width PIXELS]

Needs the package bpy, and the package `orogen` on the search path. FOLDER holds NAME.orogen.json;
NAME.blend and NAME.png are written beside it, and for a range with layers of rock NAME_block.png.
"""

import argparse
import importlib
import math
import os
import sys
import tempfile
from pathlib import Path

import demo_collision

ADDON = "bl_ext.user_default.orogen"
HERE = Path(__file__).resolve().parent

EXAGGERATION = 1.7
HAZE_COLOUR = (0.42, 0.60, 0.85)
TIME_LIMIT = 150.0  # s for the rendering; what noise is left then, the denoiser takes
SUN_ELEVATION, SUN_AZIMUTH = 26.0, 330.0  # degrees; azimuth clockwise from north


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
    """Camera, sun, sky, a sea to the horizon, and haze."""
    scene = bpy.context.scene
    terrain.orogen.vertical_exaggeration = EXAGGERATION
    nx, ny = terrain.data["orogen_grid"]
    cell, across = terrain.data["orogen_cell_size"], terrain.orogen.local_scale()[0]
    width, height = nx * cell * across, ny * cell * across
    size = max(width, height)
    extend_sea(bpy, terrain, 60.0 * size)
    add_sky(bpy, scene)
    add_camera(bpy, scene, terrain, width, height)
    for name in ("Orogen Terrain", "Orogen Sea", "Deep Sea"):
        if material := bpy.data.materials.get(name):
            add_haze(material, 1.1 * size, 6.0 * size)


def extend_sea(bpy, terrain, size):
    """The sea's plane to the horizon, and a dark floor where the ground's colour ends."""
    surface = next((c for c in terrain.children if c.get("orogen_role") == "sea"), None)
    if surface is None:
        return
    surface.scale = (size, size, 1.0)
    module = importlib.import_module(f"{ADDON}.material.terrain_material")
    deepest, colour = module.SEA_FLOOR[0]
    depth = deepest * terrain.orogen.local_scale()[1]
    mesh = bpy.data.meshes.new("Deep Sea")
    corners = [(-size, -size), (size, -size), (size, size), (-size, size)]
    mesh.from_pydata([(x, y, depth) for x, y in corners], [], [(0, 1, 2, 3)])
    material = bpy.data.materials.new("Deep Sea")
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Specular IOR Level"].default_value = 0.2
    shader.inputs["Roughness"].default_value = 0.92
    mesh.materials.append(material)
    floor = bpy.data.objects.new("Deep Sea", mesh)
    floor.parent = terrain
    bpy.context.scene.collection.objects.link(floor)


def add_sky(bpy, scene, elevation=SUN_ELEVATION, azimuth=SUN_AZIMUTH):
    elevation, azimuth = math.radians(elevation), math.radians(azimuth)
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.data.energy, sun.data.angle, sun.data.color = 6.5, math.radians(0.6), (1.0, 0.88, 0.72)
    sun.rotation_euler = (math.pi / 2 - elevation, 0.0, math.pi - azimuth)
    scene.collection.objects.link(sun)
    world = scene.world = bpy.data.worlds.new("Sky")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    sky = nodes.new("ShaderNodeTexSky")
    kinds = [item.identifier for item in sky.bl_rna.properties["sky_type"].enum_items]
    sky.sky_type = next(k for k in ("MULTIPLE_SCATTERING", "NISHITA") if k in kinds)
    sky.sun_disc = False
    sky.sun_elevation, sky.sun_rotation = elevation, azimuth
    links.new(sky.outputs[0], nodes["Background"].inputs["Color"])
    nodes["Background"].inputs["Strength"].default_value = 0.14


def add_camera(bpy, scene, terrain, width, height):
    """From the south-west and above, with a long lens: the whole island lies across the picture."""
    from mathutils import Vector

    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    size = math.hypot(width, height)
    camera.data.lens, camera.data.clip_end = 60.0, 100.0 * size
    bearing, tilt = math.radians(246.0), math.radians(33.0)
    centre = terrain.matrix_world @ Vector((0.02 * width, -0.05 * height, 0.0))
    distance = 1.3 * size
    direction = Vector(
        (
            math.sin(bearing) * math.cos(tilt),
            math.cos(bearing) * math.cos(tilt),
            math.sin(tilt),
        )
    )
    camera.location = centre + distance * direction
    camera.rotation_euler = (-direction).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera


def add_haze(material, start, end, most=0.7, colour=HAZE_COLOUR, strength=0.7):
    """Air between the camera and the ground: far things fade into the sky's colour."""
    tree = material.node_tree
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    surface = output.inputs["Surface"].links[0].from_socket
    distance = tree.nodes.new("ShaderNodeCameraData").outputs["View Distance"]
    fade = tree.nodes.new("ShaderNodeMapRange")
    tree.links.new(distance, fade.inputs[0])
    for socket, value in zip(fade.inputs[1:5], (start, end, 0.0, most), strict=True):
        socket.default_value = value
    air = tree.nodes.new("ShaderNodeEmission")
    air.inputs["Color"].default_value = (*colour, 1.0)
    air.inputs["Strength"].default_value = strength
    mix = tree.nodes.new("ShaderNodeMixShader")
    tree.links.new(fade.outputs[0], mix.inputs[0])
    tree.links.new(surface, mix.inputs[1])
    tree.links.new(air.outputs[0], mix.inputs[2])
    tree.links.new(mix.outputs[0], output.inputs["Surface"])


def draw(bpy, terrain, file, width, samples):
    """NAME.png and NAME.blend; of a range with layers of rock NAME_block.png before."""
    if "strata_color" not in terrain.data.attributes:
        build_scene(bpy, terrain)
        render(bpy, file.with_suffix(".png"), width, samples)
    else:
        demo_collision.build_block(bpy, terrain)
        block = file.with_name(f"{file.name}_block.png")
        render(bpy, block, width, samples, exposure=0.0, transform="Standard")
        terrain = grow(bpy, terrain.orogen.path)
        demo_collision.build_range(bpy, terrain, add_sky, add_haze)
        render(bpy, file.with_suffix(".png"), width, samples, exposure=-0.6)
    bpy.ops.wm.save_as_mainfile(filepath=str(file.with_suffix(".blend")), compress=True)


def render(bpy, file, width, samples, exposure=0.7, transform="AgX"):
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
    scene.view_settings.exposure = exposure
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
