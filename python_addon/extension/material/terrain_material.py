"""The ground's material: colours by height, steepness, sediment, snow and rivers.

It reads the terrain's attributes (elevation and sediment in metres) and the object's vertical
exaggeration, which therefore changes no colour. A missing attribute counts as 0.
"""

import bpy

from .graph import Graph

NAME = "Orogen Terrain"
EXAGGERATION = "orogen_vertical_exaggeration"  # custom property of the terrain object
SEA_FLOOR = (  # m, colour; what the water above does to the light is in it
    (-300.0, (0.006, 0.034, 0.070)),
    (-120.0, (0.009, 0.052, 0.095)),
    (-40.0, (0.018, 0.125, 0.170)),
    (-8.0, (0.070, 0.300, 0.300)),
    (0.0, (0.300, 0.330, 0.230)),
)
GROUND = (  # m, colour
    (0.0, (0.300, 0.240, 0.140)),
    (12.0, (0.110, 0.120, 0.042)),
    (300.0, (0.060, 0.088, 0.024)),
    (800.0, (0.028, 0.056, 0.015)),
    (1300.0, (0.042, 0.064, 0.021)),
    (1700.0, (0.150, 0.135, 0.068)),
    (2100.0, (0.230, 0.210, 0.170)),
    (2600.0, (0.260, 0.245, 0.225)),
)
ROCK_DARK, ROCK_LIGHT = (0.110, 0.095, 0.080), (0.270, 0.240, 0.205)
SEDIMENT = (0.130, 0.135, 0.050)
SNOW = (0.820, 0.850, 0.900)
RIVER = (0.030, 0.070, 0.062)


def ensure():
    """The material, made if the file has none of that name."""
    return bpy.data.materials.get(NAME) or _new()


def _new():
    material = bpy.data.materials.new(NAME)
    material.use_nodes = True
    material.diffuse_color = (0.20, 0.20, 0.12, 1.0)  # in solid view
    graph = Graph(material.node_tree)
    snow_line = graph.node("ShaderNodeValue", label="Snow line (m)").outputs[0]
    snow_line.default_value = 2250.0

    position = graph.node("ShaderNodeTexCoord").outputs["Object"]
    coarse = graph.math("SUBTRACT", graph.noise(position, 0.35, 2.0), 0.5)
    fine = graph.math("SUBTRACT", graph.noise(position, 5.0, 3.0, 0.65), 0.5)
    elevation = graph.attribute("elevation")
    steepness = _steepness(graph)

    colour = _land(graph, elevation, steepness, coarse, fine)
    snow = _snow(graph, elevation, steepness, snow_line, coarse, fine)
    colour = graph.mix(snow, colour, SNOW)
    river = _river(graph, elevation)
    colour = graph.mix(river, colour, RIVER)
    floor = graph.ramp(elevation, -300.0, 0.0, SEA_FLOOR)
    colour = graph.mix(graph.smooth(elevation, -1.0, 1.0), floor, colour)

    roughness = graph.math("MULTIPLY_ADD", river, -0.65, 0.92)
    surface = graph.node("ShaderNodeBsdfPrincipled")
    graph.connect(surface.inputs["Base Color"], colour)
    graph.connect(surface.inputs["Roughness"], roughness)
    surface.inputs["Specular IOR Level"].default_value = 0.2
    graph.node("ShaderNodeOutputMaterial", surface.outputs[0])
    graph.arrange()
    return material


def _steepness(graph):
    """Rise over run of the ground as it is."""
    normal = graph.node("ShaderNodeNewGeometry").outputs["Normal"]
    up = graph.node("ShaderNodeSeparateXYZ", normal).outputs["Z"]
    up = graph.math("MAXIMUM", up, 0.05)
    run = graph.math("SQRT", graph.math("SUBTRACT", 1.0, graph.math("MULTIPLY", up, up)))
    exaggeration = graph.math("MAXIMUM", graph.attribute(EXAGGERATION, of="OBJECT"), 0.01)
    return graph.math("DIVIDE", graph.math("DIVIDE", run, up), exaggeration)


def _land(graph, elevation, steepness, coarse, fine):
    wavering = graph.math("MULTIPLY_ADD", coarse, 900.0, elevation)
    wavering = graph.math("MULTIPLY_ADD", fine, 350.0, wavering)
    wavering = graph.math("MAXIMUM", wavering, graph.math("MINIMUM", elevation, 14.0))
    cover = graph.ramp(wavering, 0.0, 2600.0, GROUND)
    speckle = graph.smooth(fine, -0.25, 0.25)
    rock = graph.mix(speckle, ROCK_DARK, ROCK_LIGHT)
    bareness = graph.math("MULTIPLY_ADD", fine, 0.4, steepness)
    bareness = graph.math("MULTIPLY_ADD", elevation, 0.0001, bareness)
    colour = graph.mix(graph.smooth(bareness, 0.55, 1.0), cover, rock)
    laid_down = graph.math(
        "MAXIMUM", graph.attribute("deposition"), graph.attribute("sediment_thickness")
    )
    flat = graph.smooth(steepness, 0.16, 0.04)
    plain = graph.math("MULTIPLY", graph.smooth(laid_down, 0.5, 8.0), flat)
    plain = graph.math("MULTIPLY", plain, graph.smooth(coarse, -0.35, 0.3))
    return graph.mix(plain, colour, SEDIMENT)


def _snow(graph, elevation, steepness, snow_line, coarse, fine):
    height = graph.math("SUBTRACT", elevation, snow_line)
    height = graph.math("MULTIPLY_ADD", coarse, 500.0, height)
    height = graph.math("MULTIPLY_ADD", fine, 500.0, height)
    lies = graph.smooth(steepness, 0.85, 0.45)
    return graph.math("MULTIPLY", graph.smooth(height, -120.0, 160.0), lies)


def _river(graph, elevation):
    drawn = graph.smooth(graph.attribute("river"), 0.5, 1.0)
    large = graph.smooth(graph.attribute("drainage_area"), 60e6, 300e6)
    wet = graph.math("MAXIMUM", drawn, graph.math("MULTIPLY", large, 0.8))
    return graph.math("MULTIPLY", wet, graph.smooth(elevation, -2.0, 0.0))
