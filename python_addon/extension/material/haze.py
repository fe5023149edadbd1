"""Air between the camera and the ground: far things fade into the colour of the sky behind them."""

import bpy

from . import sky
from .graph import Graph

NAME = "Orogen Haze"
THICKNESS = "Thickness"  # a unit of length of air takes this share of the light
SKYLINE = 0.03  # height over distance where the sky's colour is taken


def group():
    """The group of nodes; of no thickness if the file had none."""
    return bpy.data.node_groups.get(NAME) or _new()


def ensure(thickness):
    """The group of nodes; `thickness` a Blender unit."""
    tree = group()
    tree.nodes[THICKNESS].outputs[0].default_value = thickness
    return tree


def put_over(material, tree):
    """Lets a material's surface be seen through the air."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    output = next((node for node in nodes if node.type == "OUTPUT_MATERIAL"), None)
    if output is None or not output.inputs["Surface"].is_linked:
        return
    if any(node.type == "GROUP" and node.node_tree == tree for node in nodes):
        return
    air = nodes.new("ShaderNodeGroup")
    air.node_tree, air.location = tree, output.location
    output.location.x += 200
    links.new(output.inputs["Surface"].links[0].from_socket, air.inputs[0])
    links.new(air.outputs[0], output.inputs["Surface"])
    material.cycles.emission_sampling = "NONE"  # it is no lamp


def _new():
    tree = bpy.data.node_groups.new(NAME, "ShaderNodeTree")
    for way in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Surface", in_out=way, socket_type="NodeSocketShader")
    graph = Graph(tree)
    thickness = graph.node("ShaderNodeValue", name=THICKNESS, label=THICKNESS).outputs[0]
    thickness.default_value = 0.0
    distance = graph.node("ShaderNodeCameraData").outputs["View Distance"]
    depth = graph.math("MULTIPLY", graph.math("MULTIPLY", distance, thickness), -1.0)
    share = graph.math("SUBTRACT", 1.0, graph.math("EXPONENT", depth))
    seen = graph.node("ShaderNodeLightPath").outputs["Is Camera Ray"]
    share = graph.math("MULTIPLY", share, seen)
    colour = graph.node("ShaderNodeGroup", node_tree=sky.ensure())
    graph.connect(colour.inputs[0], _skyline(graph))
    air = graph.node("ShaderNodeEmission", colour.outputs[0]).outputs[0]
    surface = graph.node("NodeGroupInput").outputs[0]
    graph.node("NodeGroupOutput", graph.node("ShaderNodeMixShader", share, surface, air).outputs[0])
    graph.arrange()
    return tree


def _skyline(graph):
    """The direction to the skyline behind a point."""
    back = graph.node("ShaderNodeNewGeometry").outputs["Incoming"]
    x, y, _ = graph.node("ShaderNodeSeparateXYZ", back).outputs
    x, y = (graph.math("MULTIPLY", value, -1.0) for value in (x, y))
    flat = graph.node("ShaderNodeCombineXYZ", x, y, SKYLINE).outputs[0]
    return graph.node("ShaderNodeVectorMath", flat, operation="NORMALIZE").outputs[0]
