"""The material of a volume of rock: each sub-layer's colour, by its number."""

import bpy

from ..mesh import colors
from .graph import Graph

MOST_STOPS = 32  # of a colour ramp


def new(name, rocks):
    """`rocks`: dictionaries with the `number` of a sub-layer and its `color` (sRGB bytes)."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    graph = Graph(material.node_tree)
    number = graph.attribute("rock")
    shown = rocks[:MOST_STOPS]
    linear = colors.to_linear([item["color"] for item in shown])[:, :3].tolist()
    stops = [(item["number"] - 0.5, tuple(c)) for item, c in zip(shown, linear, strict=True)]
    colour = graph.ramp(number, 0.0, stops[-1][0] + 1.0, stops, interpolation="CONSTANT")
    density = graph.math("MULTIPLY", graph.math("GREATER_THAN", number, 0.5), 20.0)
    rock = graph.node("ShaderNodeVolumePrincipled")
    graph.connect(rock.inputs["Color"], colour)
    graph.connect(rock.inputs["Density"], density)
    output = graph.node("ShaderNodeOutputMaterial")
    graph.connect(output.inputs["Volume"], rock.outputs[0])
    graph.arrange()
    return material
