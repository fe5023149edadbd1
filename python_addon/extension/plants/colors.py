"""What bark, leaves and petals look like: nodes that give a colour, lit or not."""

import numpy as np

from ..mesh.colors import to_linear

STEM, LEAF, PETAL, CENTRE = range(4)  # as the core counts materials of plants
NAMES = ("bark", "leaf", "petal", "centre")
POLLEN = 0xD9A520
SATURATION = 0.8
SHADE = "orogen_shade"  # attribute of an instance: 0 to 1 at random


def parts(palette):
    """The parts that a plant of these colours has."""
    return range(CENTRE + 1 if "petal_color" in palette else LEAF + 1)


def albedo(graph, part, colors):
    """The colour of a part of a plant. `colors`: sRGB 0xRRGGBB by name, as the core has them."""
    if part == LEAF:
        return _leaf(graph, _linear(colors["leaf_color"]), _linear(colors["other_leaf_color"]))
    if part == STEM:
        return _bark(graph, _linear(colors.get("bark_color", colors.get("stem_color"))))
    return _linear(colors["petal_color"] if part == PETAL else POLLEN)


def varied(graph, colour):
    """Each instance a little brighter or darker than the others; less green than the species' list,
    whose colours are those of single leaves by daylight."""
    shade = graph.attribute(SHADE, of="INSTANCER")
    node = graph.node("ShaderNodeHueSaturation")
    node.inputs["Saturation"].default_value = SATURATION
    graph.connect(node.inputs["Value"], graph.math("MULTIPLY_ADD", shade, 0.5, 0.9))
    graph.connect(node.inputs["Color"], colour)
    return node.outputs[0]


def _leaf(graph, first, second):
    """Two greens in turn about the crown; the midrib and the foot of a leaf are darker."""
    place = graph.node("ShaderNodeTexCoord").outputs["Object"]
    share = graph.smooth(graph.noise(place, 2.5, 2.0), 0.3, 0.7)
    u, v, _ = graph.node("ShaderNodeSeparateXYZ", graph.node("ShaderNodeUVMap").outputs[0]).outputs
    aside = graph.math("ABSOLUTE", graph.math("SUBTRACT", u, 0.5))
    light = graph.math("MULTIPLY_ADD", graph.smooth(aside, 0.0, 0.12), 0.15, 0.8)
    light = graph.math("MULTIPLY_ADD", v, 0.1, light)
    return graph.scaled(graph.mix(share, first, second), light)


def _bark(graph, colour):
    """Cracks along the stem: u runs once around, v counts circumferences."""
    uv = graph.node("ShaderNodeUVMap").outputs[0]
    around, along, _ = graph.node("ShaderNodeSeparateXYZ", uv).outputs
    turn = graph.math("MULTIPLY", around, 2.0 * np.pi)
    place = graph.node(
        "ShaderNodeCombineXYZ",
        graph.math("COSINE", turn),
        graph.math("SINE", turn),
        graph.math("MULTIPLY", along, 1.2),
    ).outputs[0]
    crack = graph.smooth(graph.noise(place, 4.0, 3.0, 0.65), 0.35, 0.65)
    return graph.scaled(colour, graph.math("MULTIPLY_ADD", crack, 0.7, 0.45))


def _linear(packed):
    rgb = np.array([[packed >> shift & 255 for shift in (16, 8, 0)]], np.uint8)
    return tuple(float(value) for value in to_linear(rgb)[0, :3])
