"""Orogen Water Surface: a terrain's rivers as ribbons along their beds, and a sea up to the coast.

A ribbon's middle lies above the bed and its sides below the ground, so that the ground cuts it off.
"""

from ..material import sea_material
from . import group

NAME = "Orogen Water Surface"


def ensure():
    return group.ensure(NAME, _build)


def _build(g):
    ground = g.geometry_of(g.input(group.TERRAIN, "Object"))
    area = g.field(g.input("Field", "String", "drainage_area"))
    least = g.input("Rivers from", "Float", 2e7)
    depth = g.input("Depth", "Float", 0.01, min_value=0.0)
    level = g.input("Sea level", "Float", 0.0)
    with_sea = g.input("Sea", "Bool", False)
    material = g.input("Material", "Material", sea_material.ensure())

    height = g.up("Position")
    above_sea = g.math("GREATER_THAN", height, level)
    wet = g.math("MULTIPLY", g.math("GREATER_THAN", area, least), above_sea)
    rivers = _without(g, ground, g.math("SUBTRACT", 1.0, wet))
    raised = g.math("MULTIPLY", g.math("MULTIPLY_ADD", wet, 2.0, -1.0), depth)
    rivers = _moved(g, rivers, "Offset", (0.0, 0.0, raised))

    sea = _without(g, ground, above_sea)
    place = g.node("GeometryNodeInputPosition").outputs[0]
    x, y, _ = g.node("ShaderNodeSeparateXYZ", place).outputs
    sea = _moved(g, sea, "Position", (x, y, level))
    shown = g.node("GeometryNodeSwitch", input_type="GEOMETRY")
    g.connect(shown.inputs["Switch"], with_sea)
    g.connect(shown.inputs["True"], sea)

    water = g.node("GeometryNodeJoinGeometry")
    for part in (rivers, shown.outputs[0]):
        g.connect(water.inputs[0], part)
    dressed = g.node("GeometryNodeSetMaterial", water.outputs[0])
    g.connect(dressed.inputs["Material"], material)
    g.finish(dressed.outputs[0])


def _without(g, geometry, dry):
    """The geometry less the faces all of whose corners are dry."""
    at_corners = g.node("GeometryNodeFieldOnDomain", dry, data_type="BOOLEAN", domain="POINT")
    node = g.node("GeometryNodeDeleteGeometry", geometry, domain="FACE")
    g.connect(node.inputs["Selection"], at_corners.outputs[0])
    return node.outputs[0]


def _moved(g, geometry, socket, vector):
    node = g.node("GeometryNodeSetPosition", geometry)
    g.connect(node.inputs[socket], g.node("ShaderNodeCombineXYZ", *vector).outputs[0])
    return node.outputs[0]
