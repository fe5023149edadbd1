"""The material of blocks, sections and horizons: the colour of each layer, dull."""

import bpy

from .graph import Graph

NAME = "Orogen Strata"


def ensure():
    return bpy.data.materials.get(NAME) or _new()


def _new():
    material = bpy.data.materials.new(NAME)
    material.use_nodes = True
    material.diffuse_color = (0.45, 0.38, 0.30, 1.0)
    graph = Graph(material.node_tree)
    surface = graph.node("ShaderNodeBsdfPrincipled")
    graph.connect(surface.inputs["Base Color"], graph.color("strata_color"))
    surface.inputs["Roughness"].default_value = 0.9
    surface.inputs["Specular IOR Level"].default_value = 0.2
    graph.node("ShaderNodeOutputMaterial", surface.outputs[0])
    graph.arrange()
    return material
