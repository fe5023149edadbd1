"""Orogen Plants: the vertices of a mesh become instances of plants: of meshes near the camera, of
impostors afar, of both where the one fades into the other.

Vertices have the attributes `scale`, `rotation` and `plant`, which counts the objects of a
collection by name; the collections of meshes and of impostors go by the same order.
"""

from ..plants.colors import SHADE
from ..plants.fade import FADE
from . import group

NAME = "Orogen Plants"


def ensure():
    return group.ensure(NAME, _build)


def _build(g):
    points = g.input("Geometry", "Geometry")
    meshes, pictures = g.input("Meshes", "Collection"), g.input("Impostors", "Collection")
    camera = g.input("Camera", "Object")
    near = g.input("Fade Near", "Float", 80.0, min_value=0.0)
    far = g.input("Fade Far", "Float", 160.0, min_value=0.0)
    in_view = g.input("Viewport Share", "Float", 1.0, min_value=0.0, max_value=1.0)
    in_picture = g.input("Render Share", "Float", 1.0, min_value=0.0, max_value=1.0)
    seed = g.input("Seed", "Int", 0)

    share = g.node("GeometryNodeSwitch", input_type="FLOAT")
    g.connect(share.inputs["Switch"], g.node("GeometryNodeIsViewport").outputs[0])
    g.connect(share.inputs["False"], in_picture)
    g.connect(share.inputs["True"], in_view)
    grows = g.math("LESS_THAN", g.random(0.0, 1.0, seed), share.outputs[0])
    points = g.stored(points, SHADE, g.random(0.0, 1.0, g.math("ADD", seed, 1)))
    points = g.stored(points, FADE, _fade(g, camera, near, far))

    fade = g.field(FADE)
    seen_near = g.math("MULTIPLY", grows, g.math("LESS_THAN", fade, 1.0))
    seen_far = g.math("MULTIPLY", grows, g.math("GREATER_THAN", fade, 0.0))
    plants = g.node("GeometryNodeJoinGeometry")
    for collection, seen in ((meshes, seen_near), (pictures, seen_far)):
        g.connect(plants.inputs[0], _instances(g, points, collection, seen))
    g.finish(plants.outputs[0])


def _fade(g, camera, near, far):
    """0 at the distance `near` of the camera, 1 at `far`."""
    eye = g.node("GeometryNodeObjectInfo", camera, transform_space="RELATIVE").outputs["Location"]
    place = g.node("GeometryNodeInputPosition").outputs[0]
    distance = g.node("ShaderNodeVectorMath", place, eye, operation="DISTANCE").outputs["Value"]
    return g.node("ShaderNodeMapRange", distance, near, far, 0.0, 1.0).outputs[0]


def _instances(g, points, collection, selection):
    kinds = g.node("GeometryNodeCollectionInfo", collection)
    kinds.inputs["Separate Children"].default_value = True
    kinds.inputs["Reset Children"].default_value = True
    turn = g.node("ShaderNodeCombineXYZ", 0.0, 0.0, g.field("rotation")).outputs[0]
    placed = g.node("GeometryNodeInstanceOnPoints", points)
    placed.inputs["Pick Instance"].default_value = True
    for name, value in (
        ("Selection", selection),
        ("Instance", kinds.outputs[0]),
        ("Instance Index", g.field("plant")),
        ("Rotation", g.node("FunctionNodeEulerToRotation", turn).outputs[0]),
        ("Scale", g.field("scale")),
    ):
        g.connect(placed.inputs[name], value)
    return placed.outputs[0]
