"""How a mesh fades into its picture with distance (paper B, VII-C2, Fig. 13).

Every instance has the attribute `orogen_fade`: 0 near, where the mesh is seen alone, 1 far, where
the picture is. Between, a number at random for each place of the image is compared with it: where
one of the two is transparent the other is not, so that both together always cover what the tree
does, and samples of a pixel average to a blend of both.
"""

from ..material import haze

FADE = "orogen_fade"
GRAIN = 8191.0  # cells of the random pattern across the image


def of_mesh(graph):
    """1 where the mesh is to be seen, else 0."""
    return graph.math("GREATER_THAN", _threshold(graph), _fade(graph))


def of_picture(graph):
    return graph.math("SUBTRACT", 1.0, of_mesh(graph))


def put(graph, surface, alpha):
    """The material's surface, behind the air, seen where `alpha` says."""
    air = graph.node("ShaderNodeGroup", node_tree=haze.group())
    graph.connect(air.inputs[0], surface)
    clear = graph.node("ShaderNodeBsdfTransparent").outputs[0]
    mixed = graph.node("ShaderNodeMixShader", alpha, clear, air.outputs[0]).outputs[0]
    graph.node("ShaderNodeOutputMaterial", mixed)


def _fade(graph):
    return graph.attribute(FADE, of="INSTANCER")


def _threshold(graph):
    """Above 0, at most 1: what does not fade is seen wholly."""
    window = graph.node("ShaderNodeTexCoord").outputs["Window"]
    place = graph.node("ShaderNodeVectorMath", window, operation="SCALE")
    place.inputs["Scale"].default_value = GRAIN
    cell = graph.node("ShaderNodeVectorMath", place.outputs[0], operation="FLOOR").outputs[0]
    noise = graph.node("ShaderNodeTexWhiteNoise", noise_dimensions="2D")
    graph.connect(noise.inputs["Vector"], cell)
    value = next(socket for socket in noise.outputs if socket.type == "VALUE")
    return graph.math("MULTIPLY_ADD", value, 0.9999, 0.00005)
