"""Impostors: what stands for a plant afar, upright quads through its axis with pictures of it.

A tree has eight (paper B, Fig. 12), each with a picture from its side, seen from there alone; a
tuft has two at right angles, seen from everywhere (Fig. 10).

The pictures hold colours without light and normals, so that a quad is lit as the scene is, wherever
the sun stands and however the instance is turned.

Limits: seen from high above a quad is foreshortened; in EEVEE quads shade one another.
"""

import math
from dataclasses import dataclass

import bpy
import numpy as np
from mathutils.geometry import convex_hull_2d

from . import colors, fade, impostor_render, materials, species
from .pictures import PictureProcess

WHOLE = math.radians(22.5)  # from its axis a quad of eight is opaque: there two meet
GONE = math.radians(34.0)


@dataclass
class Kind:
    angles: list[float]  # that a plant is seen from, anticlockwise from +x
    one_sided: bool
    size: float  # of pictures, beside those of trees


KINDS = {
    "trees": Kind([i * math.tau / 8 for i in range(8)], True, 1.0),
    "ground_cover": Kind([0.0, math.tau / 4], False, 0.5),
}


def ensure(plants, meshes, pixels):
    """Impostors of the plants' variants, made anew where the species or the size is another than
    before: a generator that yields how much of it is done.

    `plants`, `meshes`: as for `species.ensure`; `pixels`: of the longer side of a tree's picture.
    """
    stale = [
        (plant, variant, _made_from(plant, pixels))
        for plant in plants
        for variant in plant["variants"]
        if not species.is_made(variant, "picture", _made_from(plant, pixels))
    ]
    if not stale:
        return
    wanted = [_wanted(plant, meshes[variant], pixels) for plant, variant, _ in stale]
    with PictureProcess(wanted) as process:
        for number, (plant, variant, made_from) in enumerate(stale):
            while (pictures := process.picture(number)) is None:
                yield number / len(stale)
            ob = _make(variant, KINDS[plant["layer"]], wanted[number]["tile"], pictures)
            ob[species.MADE_FROM] = made_from
            yield (number + 1) / len(stale)


def _made_from(plant, pixels):
    return f"{plant['fingerprint']} {pixels}"


def _wanted(plant, mesh, pixels):
    kind = KINDS[plant["layer"]]
    tile = impostor_render.tile_of(mesh["positions"], kind.size * pixels)
    return {"mesh": mesh, "colors": plant["colors"], "tile": tile, "angles": kind.angles}


def _make(variant, kind, tile, pictures):
    name = f"Orogen {variant} picture"
    ob = species.find(variant, "picture")
    if ob is None:
        ob = species.new(variant, "picture", name, bpy.data.meshes.new(name))
    _write_quads(ob.data, tile, kind, pictures[0][..., 3])
    colour, normal = (
        _image(f"{name} {what}", pixels)
        for what, pixels in zip(("colour", "normal"), pictures, strict=True)
    )
    ob.data.materials.clear()
    ob.data.materials.append(_material(name, colour, normal, 0.5 * tile.width, kind.one_sided))
    return ob


def _write_quads(mesh, tile, kind, alpha):
    """Each cut to what is to be seen on it, which solid view shows, and light passes sooner.
    Corners against the clock for whoever looks from the quad's side. `alpha`: of the pictures."""
    half, views = 0.5 * tile.width, len(kind.angles)
    apart = materials.APART if kind.one_sided else 0.0
    points, uvs, faces, parts = [], [], [], np.split(alpha, views, axis=1)
    for view, at in enumerate(kind.angles):
        front = np.array([math.cos(at), math.sin(at), 0.0])
        right = np.array([-math.sin(at), math.cos(at), 0.0])
        shares = outline(parts[view])
        across, up = shares[:, :1], shares[:, 1:]
        height = (tile.bottom + up * tile.height) * (0.0, 0.0, 1.0)
        faces.append(range(len(points), len(points) + len(shares)))
        points += list((2.0 * across - 1.0) * half * right + apart * front + height)
        uvs.append(np.hstack([(view + across) / views, up]))
    mesh.clear_geometry()
    mesh.from_pydata(points, [], faces)
    layer = mesh.uv_layers.get("UVMap") or mesh.uv_layers.new(name="UVMap")
    layer.uv.foreach_set("vector", np.concatenate(uvs).astype(np.float32).ravel())
    mesh.update()


def outline(alpha):
    """The convex hull of what a picture shows, half a pixel wider: (n, 2), shares of its width and
    height, against the clock."""
    rows = np.flatnonzero(alpha.any(axis=1))
    first = (alpha[rows] > 0.0).argmax(axis=1)
    last = alpha.shape[1] - (alpha[rows, ::-1] > 0.0).argmax(axis=1)
    sides = [(x, y) for x in (first - 0.5, last + 0.5) for y in (rows - 0.5, rows + 1.5)]
    corners = np.concatenate([np.stack(side, axis=1) for side in sides])
    corners = np.clip(corners / np.array(alpha.shape[::-1]), 0.0, 1.0)
    hull = corners[convex_hull_2d(corners.tolist())]
    x, y = hull.T
    anticlockwise = np.dot(x, np.roll(y, -1)) > np.dot(y, np.roll(x, -1))
    return hull if anticlockwise else hull[::-1]


def _image(name, pixels):
    height, width = pixels.shape[:2]
    image = bpy.data.images.get(name)
    if image:
        bpy.data.images.remove(image)
    image = bpy.data.images.new(name, width, height, alpha=True)
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "CHANNEL_PACKED"
    image.pixels.foreach_set(np.ascontiguousarray(pixels, np.float32).ravel())
    image.pack()
    return image


def _material(name, colour, normal, radius, one_sided):
    material, graph = materials.new(name, (0.05, 0.10, 0.03))
    material.use_backface_culling = one_sided
    picture = graph.node("ShaderNodeTexImage", image=colour, extension="EXTEND")
    directions = graph.node("ShaderNodeTexImage", image=normal, extension="EXTEND")
    normal = graph.node(
        "ShaderNodeVectorMath",
        directions.outputs["Color"],
        (2.0, 2.0, 2.0),
        (-1.0, -1.0, -1.0),
        operation="MULTIPLY_ADD",
    ).outputs[0]
    normal = graph.node(
        "ShaderNodeVectorTransform",
        normal,
        vector_type="NORMAL",
        convert_from="OBJECT",
        convert_to="WORLD",
    ).outputs[0]
    normal = graph.node("ShaderNodeVectorMath", normal, operation="NORMALIZE").outputs[0]
    surface = materials.lit(graph, colors.varied(graph, picture.outputs["Color"]), normal)
    alpha = graph.math("MULTIPLY", picture.outputs["Alpha"], fade.of_picture(graph))
    if one_sided:
        alpha = graph.math("MULTIPLY", alpha, _facing(graph))
    alpha = graph.math("MULTIPLY", alpha, _not_own_shadow(graph, radius))
    fade.put(graph, surface, alpha)
    graph.arrange()
    return material


def _facing(graph):
    """1 where the quad is nearly square to the view, seen from above; 0 for the others."""
    geometry = graph.node("ShaderNodeNewGeometry")
    normal, view = (_level(graph, geometry.outputs[name]) for name in ("True Normal", "Incoming"))
    cosine = graph.node("ShaderNodeVectorMath", normal, view, operation="DOT_PRODUCT")
    share = graph.smooth(cosine.outputs["Value"], math.cos(GONE), math.cos(WHOLE))
    front = graph.math("SUBTRACT", 1.0, geometry.outputs["Backfacing"])
    return graph.math("MULTIPLY", share, front)


def _level(graph, vector):
    x, y, _ = graph.node("ShaderNodeSeparateXYZ", vector).outputs
    flat = graph.node("ShaderNodeCombineXYZ", x, y, 0.0).outputs[0]
    return graph.node("ShaderNodeVectorMath", flat, operation="NORMALIZE").outputs[0]


def _not_own_shadow(graph, radius):
    """0 for light on its way to a place no farther than the plant's own radius: its quads would
    shade one another, and the shade within the plant is in its picture."""
    path = graph.node("ShaderNodeLightPath")
    across = graph.node(
        "ShaderNodeVectorTransform",
        (radius, 0.0, 0.0),
        vector_type="VECTOR",
        convert_from="OBJECT",
        convert_to="WORLD",
    ).outputs[0]
    length = graph.node("ShaderNodeVectorMath", across, operation="LENGTH").outputs["Value"]
    near = graph.math("LESS_THAN", path.outputs["Ray Length"], length)
    own = graph.math("MULTIPLY", near, path.outputs["Is Shadow Ray"])
    return graph.math("SUBTRACT", 1.0, own)
