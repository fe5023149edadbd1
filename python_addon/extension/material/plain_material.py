"""Materials of one colour, for lines."""

import bpy


def ensure(name, colour):
    """The material "Orogen Name", made in the colour (linear) if the file has none."""
    full_name = f"Orogen {name.capitalize()}"
    return bpy.data.materials.get(full_name) or _new(full_name, colour)


def _new(name, colour):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.diffuse_color = (*colour, 1.0)
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Roughness"].default_value = 0.6
    return material
