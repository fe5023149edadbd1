"""The materials of a species: bark, leaves, petals, in Cycles and EEVEE."""

import bpy

from ..material.graph import Graph
from . import colors, fade

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


def _ensure(name, part, palette):
    full_name = f"Orogen {name} {colors.NAMES[part]}"
    made = bpy.data.materials.get(full_name)
    stamp = str(sorted(palette.items()))
    if made and made.get("orogen_made_from") == stamp:
        return made
    made, graph = new(full_name, (0.05, 0.10, 0.03) if part else (0.10, 0.07, 0.05))
    colour = colors.varied(graph, colors.albedo(graph, part, palette))
    surface = lit(graph, colour, through=THROUGH if part else 0.0)
    fade.put(graph, surface, fade.of_mesh(graph))
    graph.arrange()
    made["orogen_made_from"] = stamp
    return made
