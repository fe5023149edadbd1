"""The materials of a species: bark, leaves, petals, in Cycles and EEVEE."""

import functools
import math

import bpy

from ..material.graph import Graph
from . import colors, fade

APART = 0.01  # m: how far a quad of an impostor stands before the one seen from behind
REACH = 15.0  # m, from its axis: no plant is wider
FADES = 0.2  # of the fade: there impostors are seen enough for their light to matter
THROUGH = 0.35  # share of the light on a leaf that comes out at its other side


def ensure(name, palette):
    """Materials of the parts of a plant, in the core's order; rebuilt when colours change."""
    return [_ensure(name, part, palette) for part in colors.parts(palette)]


def lit(graph, colour, normal=None, through=THROUGH):
    """Light from both sides, `through` of it through."""
    before = graph.node("ShaderNodeBsdfDiffuse", colour)
    behind = graph.node("ShaderNodeBsdfTranslucent", colour)
    for node in (before, behind):
        graph.connect(node.inputs["Normal"], normal)
    return graph.node("ShaderNodeMixShader", through, before.outputs[0], behind.outputs[0]).outputs[
        0
    ]


def new(name, viewport):
    """The material of that name, emptied; `viewport`: its colour in solid view."""
    material = bpy.data.materials.get(name) or bpy.data.materials.new(name)
    material.use_nodes = True
    material.diffuse_color = (*viewport, 1.0)
    material.cycles.emission_sampling = "NONE"  # the air over it glows, but is no lamp
    if hasattr(material, "surface_render_method"):
        material.surface_render_method = "DITHERED"
    return material, Graph(material.node_tree)


def _shades(graph):
    """0 for light on its way to the plant's own impostor, which the mesh would darken while the one
    fades into the other: what lies on the planes of its quads. In Cycles alone."""
    path = graph.node("ShaderNodeLightPath")
    geometry = graph.node("ShaderNodeNewGeometry")
    back = graph.scaled(geometry.outputs["Incoming"], path.outputs["Ray Length"])
    lit = graph.node("ShaderNodeVectorMath", geometry.outputs["Position"], back, operation="ADD")
    local = graph.node(
        "ShaderNodeVectorTransform",
        lit.outputs[0],
        vector_type="POINT",
        convert_from="WORLD",
        convert_to="OBJECT",
    ).outputs[0]
    x, y, _ = graph.node("ShaderNodeSeparateXYZ", local).outputs
    away = [graph.math("ABSOLUTE", value) for value in (x, y)]
    for operation in ("ADD", "SUBTRACT"):
        slanted = graph.math("ABSOLUTE", graph.math(operation, x, y))
        away.append(graph.math("MULTIPLY", slanted, math.sqrt(0.5)))
    nearest = functools.reduce(lambda a, b: graph.math("MINIMUM", a, b), away)
    own = graph.math("LESS_THAN", nearest, 2.0 * APART)
    farther = graph.math("MAXIMUM", away[0], away[1])
    for condition in (
        graph.math("LESS_THAN", farther, REACH),
        graph.smooth(graph.attribute(fade.FADE, of="INSTANCER"), 0.0, FADES),
        path.outputs["Is Shadow Ray"],
    ):
        own = graph.math("MULTIPLY", own, condition)
    return graph.math("SUBTRACT", 1.0, own)


def _ensure(name, part, palette):
    full_name = f"Orogen {name} {colors.NAMES[part]}"
    made = bpy.data.materials.get(full_name)
    stamp = str(sorted(palette.items()))
    if made and made.get("orogen_made_from") == stamp:
        return made
    made, graph = new(full_name, (0.05, 0.10, 0.03) if part else (0.10, 0.07, 0.05))
    colour = colors.varied(graph, colors.albedo(graph, part, palette))
    surface = lit(graph, colour, through=THROUGH if part else 0.0)
    fade.put(graph, surface, graph.math("MULTIPLY", fade.of_mesh(graph), _shades(graph)))
    graph.arrange()
    made["orogen_made_from"] = stamp
    return made
