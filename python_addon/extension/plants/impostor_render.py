"""Renders a plant from its sides: colour with alpha, and the direction of its surface.

A copy for each side stands in a row, turned, before a parallel camera; a second row above glows
with its normals in place of its colours. One picture of both is cut in two: the upper half are the
normals. Colours are without light but for the shade that the plant makes within itself.
"""

import math
import os
import tempfile
from dataclasses import dataclass

import bpy
import numpy as np

from ..material.graph import Graph
from . import colors

SAMPLES = 16
SHADE_REACH = 0.12  # of the height: how far off a part of the plant darkens another


@dataclass
class Tile:
    """A view: its size in metres and pixels; the plant's axis is in its middle."""

    width: float
    height: float
    bottom: float
    pixels: tuple[int, int]


def tile_of(positions, pixels):
    """`positions`: (n, 3), a plant's vertices; `pixels`: of the longer side."""
    radius = float(np.hypot(positions[:, 0], positions[:, 1]).max())
    bottom, top = float(positions[:, 2].min()), float(positions[:, 2].max())
    scale = pixels / max(2.0 * radius, top - bottom)
    across, up = (math.ceil(size * scale) + 2 for size in (2.0 * radius, top - bottom))
    return Tile(across / scale, up / scale, bottom - 1.0 / scale, (across, up))


def render(mesh, palette, tile, angles):
    """Colours (straight alpha) and normals, (h, w times views, 4) each, the lower row first; the
    views side by side. `mesh`: a plant's, without materials; `angles`: where each is seen from,
    anticlockwise from +x."""
    scene = bpy.data.scenes.new("Orogen Pictures")
    made = []
    try:
        _settings(scene, tile, len(angles))
        made.append(_camera(scene, tile, len(angles)))
        for row, material_of in enumerate((_coloured, _directed)):
            materials = [
                material_of(part, palette, SHADE_REACH * tile.height)
                for part in colors.parts(palette)
            ]
            made += materials
            made += _row(scene, mesh, materials, tile, row, angles)
        pixels = _picture(scene)
    finally:
        bpy.data.scenes.remove(scene)
        bpy.data.batch_remove(made)
    height = tile.pixels[1]
    return _filled(pixels[:height]), _filled(pixels[height:])


def _settings(scene, tile, views):
    scene.render.engine = "CYCLES"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_adaptive_sampling = scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.cycles.filter_width = 1.0
    scene.render.film_transparent = True
    scene.render.resolution_x = views * tile.pixels[0]
    scene.render.resolution_y = 2 * tile.pixels[1]
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Raw"
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.dither_intensity = 0.0


def _camera(scene, tile, views):
    data = bpy.data.cameras.new("Orogen Pictures")
    data.type, data.sensor_fit = "ORTHO", "HORIZONTAL"
    data.ortho_scale = views * tile.width
    if views * tile.pixels[0] < 2 * tile.pixels[1]:
        data.sensor_fit, data.ortho_scale = "VERTICAL", 2 * tile.height
    data.clip_end = 10.0 * (tile.width + tile.height)
    camera = bpy.data.objects.new(data.name, data)
    camera.location = (0.0, -4.0 * tile.width, tile.bottom + tile.height)
    camera.rotation_euler = (math.pi / 2, 0.0, 0.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    return data


def _row(scene, mesh, materials, tile, row, angles):
    mesh = mesh.copy()
    for material in materials:
        mesh.materials.append(material)
    for view, angle in enumerate(angles):
        copy = bpy.data.objects.new("Orogen Pictures", mesh)
        copy.location = ((view + 0.5 - len(angles) / 2) * tile.width, 0.0, row * tile.height)
        copy.rotation_euler.z = -math.pi / 2 - angle
        scene.collection.objects.link(copy)
    return [mesh]


def _coloured(part, palette, reach):
    def colour(graph):
        shade = graph.node("ShaderNodeAmbientOcclusion", only_local=True, samples=2)
        graph.connect(shade.inputs["Color"], colors.albedo(graph, part, palette))
        shade.inputs["Distance"].default_value = reach
        return shade.outputs["Color"]

    return _glowing(colour)


def _directed(_part, _palette, _reach):
    def colour(graph):
        normal = graph.node("ShaderNodeNewGeometry").outputs["Normal"]
        local = graph.node(
            "ShaderNodeVectorTransform",
            normal,
            vector_type="NORMAL",
            convert_from="WORLD",
            convert_to="OBJECT",
        ).outputs[0]
        half = (0.5, 0.5, 0.5)
        return graph.node(
            "ShaderNodeVectorMath", local, half, half, operation="MULTIPLY_ADD"
        ).outputs[0]

    return _glowing(colour)


def _glowing(colour):
    material = bpy.data.materials.new("Orogen Pictures")
    material.use_nodes = True
    graph = Graph(material.node_tree)
    glow = graph.node("ShaderNodeEmission", colour(graph)).outputs[0]
    graph.node("ShaderNodeOutputMaterial", glow)
    return material


def _picture(scene):
    with tempfile.TemporaryDirectory(prefix="orogen-") as folder:
        scene.render.filepath = os.path.join(folder, "views.png")
        bpy.ops.render.render(write_still=True, scene=scene.name)
        image = bpy.data.images.load(scene.render.filepath)
        image.colorspace_settings.name = "Non-Color"
        image.alpha_mode = "CHANNEL_PACKED"
        pixels = np.empty(image.size[0] * image.size[1] * 4, np.float32)
        image.pixels.foreach_get(pixels)
        shape = image.size[1], image.size[0], 4
        bpy.data.images.remove(image)
    return pixels.reshape(shape)


def _filled(pixels):
    """Clear pixels take the colour of those near them, so that no edge has a dark rim."""
    colour, weight = pixels[..., :3] * pixels[..., 3:], pixels[..., 3:].copy()
    result = pixels.copy()
    for step in (1, 2, 4, 8, 16):
        for axis in (0, 1):
            for way in (step, -step):
                colour = colour + 0.5 * np.roll(colour, way, axis)
                weight = weight + 0.5 * np.roll(weight, way, axis)
        empty = (result[..., 3] == 0.0) & (weight[..., 0] > 0.0) & (result[..., :3].sum(-1) == 0.0)
        result[empty, :3] = (colour / np.maximum(weight, 1e-9))[empty]
    return result
