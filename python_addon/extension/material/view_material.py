"""The material of a ground that shows a field: the colours of an attribute, dull."""

import bpy

from .graph import Graph

NAME = "Orogen View"
KEY = "orogen_view"  # custom property that tells the material, whatever it is called


def ensure():
    return next(filter(is_it, bpy.data.materials), None) or _new()


def is_it(material):
    return material is not None and KEY in material and not material.library


def _new():
    material = bpy.data.materials.new(NAME)
    material[KEY] = True
    material.use_nodes = True
    graph = Graph(material.node_tree)
    surface = graph.node("ShaderNodeBsdfPrincipled")
    graph.connect(surface.inputs["Base Color"], graph.color(KEY))
    surface.inputs["Roughness"].default_value = 1.0
    surface.inputs["Specular IOR Level"].default_value = 0.0
    graph.node("ShaderNodeOutputMaterial", surface.outputs[0])
    graph.arrange()
    return material
