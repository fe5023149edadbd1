"""The sky: a group of nodes that gives its colour in a direction, for the world and the haze."""

import bpy

from .graph import Graph

NAME = "Orogen Sky"
STRENGTH = 0.085
DUST = 0.3  # of Blender's usual: clear air
KINDS = ("SINGLE_SCATTERING", "NISHITA")  # one model: its name from Blender 5.0 on, and before


def ensure():
    return bpy.data.node_groups.get(NAME) or _new_group()


def world():
    return bpy.data.worlds.get(NAME) or _new_world()


def point(elevation, azimuth):
    """Where the sun stands (radians; clockwise from north)."""
    node = next(node for node in ensure().nodes if node.type == "TEX_SKY")
    node.sun_elevation, node.sun_rotation = elevation, azimuth


def _new_group():
    tree = bpy.data.node_groups.new(NAME, "ShaderNodeTree")
    tree.interface.new_socket("Direction", in_out="INPUT", socket_type="NodeSocketVector")
    tree.interface.new_socket("Color", in_out="OUTPUT", socket_type="NodeSocketColor")
    graph = Graph(tree)
    node = graph.node("ShaderNodeTexSky", sun_disc=False)
    kinds = [item.identifier for item in node.bl_rna.properties["sky_type"].enum_items]
    node.sky_type = next(kind for kind in KINDS if kind in kinds)
    setattr(node, "dust_density" if hasattr(node, "dust_density") else "aerosol_density", DUST)
    graph.connect(node.inputs["Vector"], graph.node("NodeGroupInput").outputs[0])
    strength = graph.node("ShaderNodeValue", label="Strength").outputs[0]
    strength.default_value = STRENGTH
    graph.node("NodeGroupOutput", graph.scaled(node.outputs[0], strength))
    graph.arrange()
    return tree


def _new_world():
    made = bpy.data.worlds.new(NAME)
    made.use_nodes = True
    graph = Graph(made.node_tree)
    direction = graph.node("ShaderNodeTexCoord").outputs["Generated"]
    colour = graph.node("ShaderNodeGroup", node_tree=ensure())
    graph.connect(colour.inputs[0], direction)
    light = graph.node("ShaderNodeBackground", colour.outputs[0]).outputs[0]
    graph.node("ShaderNodeOutputWorld", light)
    graph.arrange()
    return made
