"""The picture of all plants on the page about them, rendered with the package bpy.

python docs/plant_pictures.py    writes docs/images/trees.jpg (some minutes)
"""

import math
import os
import tempfile
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector
from orogen import vegetation

PICTURE = Path(__file__).resolve().parent / "images" / "trees.jpg"
COLUMNS, WIDTH, HEIGHT = 9, 184, 230
TWICE = 2  # rendered so much larger
SEEDS = {"european_beech": 2, "sugar_maple_fall": 3, "scots_pine": 2, "umbrella_acacia": 3}
LOWER_QUALITIES = (0.2, 0.03)
GROUND = 0x9A9678
LENS, SENSOR = 70.0, 36.0  # mm


def linear(color):
    srgb = np.array([color >> 16, color >> 8 & 255, color & 255]) / 255
    return *np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4), 1.0


def opaque(color):
    material = bpy.data.materials.new("stem")
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = linear(color)
    shader.inputs["Roughness"].default_value = 0.7
    return material


def translucent(color, other):
    """Leaves let light through, and each has its own colour between two."""
    material = opaque(color)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    mix, glow = nodes.new("ShaderNodeMix"), nodes.new("ShaderNodeBsdfTranslucent")
    both, place = nodes.new("ShaderNodeMixShader"), nodes.new("ShaderNodeNewGeometry")
    mix.data_type = "RGBA"
    mix.inputs["A"].default_value, mix.inputs["B"].default_value = linear(color), linear(other)
    links.new(place.outputs["Random Per Island"], mix.inputs["Factor"])
    shader = nodes["Principled BSDF"]
    for target in (shader.inputs["Base Color"], glow.inputs["Color"]):
        links.new(mix.outputs["Result"], target)
    both.inputs[0].default_value = 0.35
    links.new(shader.outputs[0], both.inputs[1])
    links.new(glow.outputs[0], both.inputs[2])
    links.new(both.outputs[0], nodes["Material Output"].inputs[0])
    return material


def materials_of(species):
    leaf = translucent(species["leaf_color"], species["other_leaf_color"])
    if "bark_color" in species:
        return [opaque(species["bark_color"]), leaf]
    petal = translucent(species["petal_color"], species["petal_color"])
    return [opaque(species["stem_color"]), leaf, petal, opaque(species["centre_color"])]


def to_object(plant, materials):
    mesh = bpy.data.meshes.new("plant")
    mesh.vertices.add(len(plant.positions))
    mesh.vertices.foreach_set("co", plant.positions.ravel())
    mesh.loops.add(len(plant.corners))
    mesh.loops.foreach_set("vertex_index", plant.corners)
    mesh.polygons.add(len(plant.materials))
    mesh.polygons.foreach_set("loop_start", plant.face_starts[:-1])
    mesh.polygons.foreach_set("material_index", plant.materials.astype(np.int32))
    mesh.polygons.foreach_set("use_smooth", plant.materials == 0)
    for material in materials:
        mesh.materials.append(material)
    mesh.update(calc_edges=True)
    item = bpy.data.objects.new("plant", mesh)
    bpy.context.scene.collection.objects.link(item)
    return item


def set_up():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.max_bounces = 16, 4
    scene.render.resolution_x, scene.render.resolution_y = TWICE * WIDTH, TWICE * HEIGHT
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"]
    sky.inputs["Color"].default_value = (0.72, 0.82, 1.0, 1.0)
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = 3.2, 0.02
    sun.rotation_euler = (math.radians(48), 0.0, math.radians(-35))
    far = 500.0
    ground = bpy.data.meshes.new("ground")
    corners = [(-far, -far, 0), (far, -far, 0), (far, far, 0), (-far, far, 0)]
    ground.from_pydata(corners, [], [(0, 1, 2, 3)])
    ground.materials.append(opaque(GROUND))
    scene.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.camera.data.lens, scene.camera.data.clip_end = LENS, 2000.0
    for item in (sun, bpy.data.objects.new("ground", ground), scene.camera):
        scene.collection.objects.link(item)
    return scene


def look_at(camera, plant):
    high = plant.positions[:, 2].max()
    half = max(0.56 * high, 1.3 * np.abs(plant.positions[:, :2]).max())
    away = 1.06 * half / (0.5 * SENSOR / LENS)
    camera.location = (0.0, -away, 0.5 * high + 0.06 * away)
    towards = Vector((0.0, 0.0, 0.48 * high)) - camera.location
    camera.rotation_euler = towards.to_track_quat("-Z", "Y").to_euler()


def rendered(scene, plant, species, path):
    """The picture, (HEIGHT, WIDTH, 4), from below."""
    item = to_object(plant, materials_of(species))
    look_at(scene.camera, plant)
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    bpy.data.meshes.remove(item.data)
    image = bpy.data.images.load(str(path))
    pixels = np.array(image.pixels[:], np.float32).reshape(HEIGHT, TWICE, WIDTH, TWICE, 4)
    bpy.data.images.remove(image)
    return pixels.mean(axis=(1, 3))


def plants():
    for species in vegetation.tree_species():
        name = species["name"]
        yield species, vegetation.make_tree(name, seed=SEEDS.get(name, 1))
    for species in vegetation.ground_cover():
        yield species, vegetation.make_ground_cover(species["name"], seed=1)
    oak = next(s for s in vegetation.tree_species() if s["name"] == "black_oak")
    for quality in LOWER_QUALITIES:
        yield oak, vegetation.make_tree("black_oak", seed=1, quality=quality)


def main():
    scene = set_up()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "plant.png"
        cells = [rendered(scene, plant, species, path) for species, plant in plants()]
    cells += [np.ones_like(cells[0])] * (-len(cells) % COLUMNS)
    rows = [np.hstack(cells[i : i + COLUMNS]) for i in range(0, len(cells), COLUMNS)]
    sheet = np.vstack(rows[::-1])
    image = bpy.data.images.new("sheet", sheet.shape[1], sheet.shape[0])
    image.pixels.foreach_set(sheet.ravel())
    image.filepath_raw, image.file_format = str(PICTURE), "JPEG"
    image.save(quality=88)


if __name__ == "__main__":
    main()
    os._exit(0)  # Blender's own exit may hang
