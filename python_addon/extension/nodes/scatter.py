"""Orogen Scatter by Field: instances of an object on a terrain's ground, where a named attribute
lies within bounds and the ground is not too steep."""

import math

from . import group

NAME = "Orogen Scatter by Field"


def ensure():
    return group.ensure(NAME, _build)


def _build(g):
    ground = g.geometry_of(g.input(group.TERRAIN, "Object"))
    instance = g.geometry_of(g.input("Object", "Object"), as_instance=True)
    value = g.field(g.input("Field", "String", "elevation"))
    low, high = g.input("From", "Float", 0.0), g.input("To", "Float", 1e9)
    density = g.input("Density", "Float", 20.0, min_value=0.0)
    steepest = g.input("Steepest", "Float", math.radians(35.0), min_value=0.0, subtype="ANGLE")
    smallest = g.input("Smallest", "Float", 0.7, min_value=0.0)
    largest = g.input("Largest", "Float", 1.3, min_value=0.0)
    seed = g.input("Seed", "Int", 0)

    points = g.node("GeometryNodeDistributePointsOnFaces", ground, distribute_method="RANDOM")
    g.connect(points.inputs["Density"], density)
    g.connect(points.inputs["Seed"], seed)
    up = g.node("ShaderNodeSeparateXYZ", points.outputs["Normal"]).outputs["Z"]
    outside = g.math("GREATER_THAN", g.math("ARCCOSINE", up), steepest)
    for operation, bound in (("LESS_THAN", low), ("GREATER_THAN", high)):
        outside = g.math("MAXIMUM", outside, g.math(operation, value, bound))
    kept = g.node("GeometryNodeDeleteGeometry", points.outputs["Points"], outside).outputs[0]
    turn = g.node("ShaderNodeCombineXYZ", 0.0, 0.0, g.random(0.0, math.tau, seed)).outputs[0]
    placed = g.node("GeometryNodeInstanceOnPoints", kept)
    g.connect(placed.inputs["Instance"], instance)
    g.connect(placed.inputs["Rotation"], g.node("FunctionNodeEulerToRotation", turn).outputs[0])
    g.connect(placed.inputs["Scale"], g.random(smallest, largest, g.math("ADD", seed, 1)))
    g.finish(placed.outputs[0])
