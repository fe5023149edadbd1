"""The sea's material: a rippled surface that mirrors the sky, seen through from above.

The depth's colour is the ground's business (terrain_material): it knows how deep it lies.
"""

import bpy

from .graph import Graph

NAME = "Orogen Sea"


def ensure():
    return bpy.data.materials.get(NAME) or _new()


def _new():
    material = bpy.data.materials.new(NAME)
    material.use_nodes = True
    material.diffuse_color = (0.05, 0.16, 0.24, 0.6)
    if hasattr(material, "surface_render_method"):
        material.surface_render_method = "BLENDED"  # EEVEE: no refraction pass
    graph = Graph(material.node_tree)
    position = graph.node("ShaderNodeTexCoord").outputs["Object"]
    waves = graph.node("ShaderNodeBump")
    waves.inputs["Strength"].default_value = 0.12
    waves.inputs["Distance"].default_value = 0.02
    graph.connect(waves.inputs["Height"], graph.noise(position, 9.0, 2.0, 0.6))
    mirror = graph.node("ShaderNodeBsdfGlossy", (0.9, 0.95, 1.0), 0.12)
    graph.connect(mirror.inputs["Normal"], waves.outputs[0])
    through = graph.node("ShaderNodeBsdfTransparent", (0.80, 0.93, 0.96))
    share = graph.node("ShaderNodeFresnel", 1.33)
    graph.connect(share.inputs["Normal"], waves.outputs[0])
    surface = graph.node(
        "ShaderNodeMixShader", share.outputs[0], through.outputs[0], mirror.outputs[0]
    )
    graph.node("ShaderNodeOutputMaterial", surface.outputs[0])
    graph.arrange()
    return material
