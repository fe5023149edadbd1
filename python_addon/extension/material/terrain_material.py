"""The ground's material: colours by height, steepness, strata, sediment, snow and rivers.

Height is where the ground is, so that colours follow a terrain that grows. The other fields are
attributes of the mesh. What the object's scales and settings are it is told by custom properties,
which play without the extension. A missing attribute or property counts as 0.
"""

import bpy

from . import biome_colors
from .graph import Graph

NAME = "Orogen Terrain"
# Custom properties of the terrain object.
EXAGGERATION = "orogen_vertical_exaggeration"
METRES_PER_UNIT = "orogen_metres_per_unit"  # of height
STRATA = "orogen_strata"  # 0 to 1: the share of the strata's colours in the rock's
SEA = "orogen_sea"  # 0 or 1: whether low ground lies by a sea
BIOMES = "orogen_biomes"  # 0 to 1: the share of the biomes' colours in the cover's
BARE_ROCK = "orogen_bare_rock"  # 0 to 1: the share of the cover that is taken off
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
INLAND = 150.0  # m: as low as ground looks where there is no sea, and so no beach
ROCK_DARK, ROCK_LIGHT = (0.110, 0.095, 0.080), (0.270, 0.240, 0.205)
ROUGHNESS = 16.0  # m, between the lowest and the highest of it
DAMP_ROCK = 0.55  # how bright it is where things grow, with moss and lichen
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
    height = graph.node("ShaderNodeSeparateXYZ", position).outputs["Z"]
    elevation = graph.math("MULTIPLY", height, _metres_per_unit(graph))
    steepness = _steepness(graph)
    bare = graph.attribute(BARE_ROCK, of="OBJECT")
    inland = graph.math("SUBTRACT", 1.0, graph.attribute(SEA, of="OBJECT"))

    colour = _land(graph, elevation, steepness, inland, bare, coarse, fine)
    grain = graph.noise(position, 35.0, 8.0, 0.66)
    colour = graph.scaled(colour, graph.math("MULTIPLY_ADD", grain, 0.9, 0.55))
    snow = _snow(graph, elevation, steepness, snow_line, coarse, fine)
    snow = graph.math("MULTIPLY", snow, graph.math("SUBTRACT", 1.0, bare))
    colour = graph.mix(snow, colour, SNOW)
    above_sea = graph.math("MAXIMUM", graph.smooth(elevation, -1.0, 1.0), inland)
    river = _river(graph, graph.math("MAXIMUM", elevation, inland))
    colour = graph.mix(river, colour, RIVER)
    floor = graph.ramp(elevation, -300.0, 0.0, SEA_FLOOR)
    colour = graph.mix(above_sea, floor, colour)

    roughness = graph.math("MULTIPLY_ADD", river, -0.65, 0.92)
    surface = graph.node("ShaderNodeBsdfPrincipled")
    graph.connect(surface.inputs["Base Color"], colour)
    graph.connect(surface.inputs["Roughness"], roughness)
    surface.inputs["Specular IOR Level"].default_value = 0.2
    graph.connect(surface.inputs["Normal"], _rough(graph, grain))
    graph.node("ShaderNodeOutputMaterial", surface.outputs[0])
    graph.arrange()
    return material


def _rough(graph, grain):
    """Normals of ground whose stones and hummocks the mesh is too coarse for."""
    metre = graph.math("DIVIDE", 1.0, graph.math("MAXIMUM", _metres_per_unit(graph), 1e-6))
    bump = graph.node("ShaderNodeBump")
    bump.inputs["Strength"].default_value = 0.7
    graph.connect(bump.inputs["Distance"], graph.math("MULTIPLY", metre, ROUGHNESS))
    graph.connect(bump.inputs["Height"], grain)
    return bump.outputs[0]


def _metres_per_unit(graph):
    return graph.attribute(METRES_PER_UNIT, of="OBJECT")


def _steepness(graph):
    """Rise over run of the ground as it is."""
    normal = graph.node("ShaderNodeNewGeometry").outputs["Normal"]
    up = graph.node("ShaderNodeSeparateXYZ", normal).outputs["Z"]
    up = graph.math("MAXIMUM", up, 0.05)
    run = graph.math("SQRT", graph.math("SUBTRACT", 1.0, graph.math("MULTIPLY", up, up)))
    exaggeration = graph.math("MAXIMUM", graph.attribute(EXAGGERATION, of="OBJECT"), 0.01)
    return graph.math("DIVIDE", graph.math("DIVIDE", run, up), exaggeration)


def _land(graph, elevation, steepness, inland, bare, coarse, fine):
    wavering = graph.math("MULTIPLY_ADD", coarse, 900.0, elevation)
    wavering = graph.math("MULTIPLY_ADD", fine, 350.0, wavering)
    wavering = graph.math("MAXIMUM", wavering, graph.math("MINIMUM", elevation, 14.0))
    wavering = graph.math("MAXIMUM", wavering, graph.math("MULTIPLY", inland, INLAND))
    cover = graph.ramp(wavering, 0.0, 2600.0, GROUND)
    mottled = graph.math("MULTIPLY_ADD", graph.math("ADD", coarse, fine), 0.9, 1.0)
    biomes = graph.attribute(BIOMES, of="OBJECT")
    of_biomes = graph.scaled(graph.color(biome_colors.ATTRIBUTE), mottled)
    cover = graph.mix(biomes, cover, of_biomes)
    strata = graph.attribute(STRATA, of="OBJECT")
    bareness = graph.math("MULTIPLY_ADD", fine, 0.4, steepness)
    bareness = graph.math("MULTIPLY_ADD", elevation, 0.0001, bareness)
    bareness = graph.math("MULTIPLY_ADD", strata, 0.1, bareness)
    shown = graph.math("MAXIMUM", graph.smooth(bareness, 0.55, 1.0), bare)
    laid_down = graph.math(
        "MAXIMUM", graph.attribute("deposition"), graph.attribute("sediment_thickness")
    )
    flat = graph.smooth(steepness, 0.16, 0.04)
    plain = graph.math("MULTIPLY", graph.smooth(laid_down, 0.5, 8.0), flat)
    plain = graph.math("MULTIPLY", plain, graph.smooth(coarse, -0.35, 0.3))
    cover = graph.mix(plain, cover, SEDIMENT)
    rock = _rock(graph, strata, bare, fine)
    rock = graph.scaled(rock, graph.math("MULTIPLY_ADD", biomes, DAMP_ROCK - 1.0, 1.0))
    return graph.mix(shown, cover, rock)


def _rock(graph, strata, bare, fine):
    """Weathered rock; of the colour of its layer where the strata are shown. Cliffs are darker than
    fresh rock, which a bare terrain shows as it is."""
    speckle = graph.smooth(fine, -0.25, 0.25)
    plain = graph.mix(speckle, ROCK_DARK, ROCK_LIGHT)
    weathering = graph.math("MULTIPLY_ADD", speckle, 0.10, 0.32)
    weathering = graph.math("MULTIPLY_ADD", bare, 0.5, weathering)
    layer = graph.scaled(graph.color("strata_color"), weathering)
    return graph.mix(strata, plain, layer)


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
