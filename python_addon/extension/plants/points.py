"""Where plants stand: a mesh of points under a terrain, in metres, which nodes make plants of."""

import bpy
import numpy as np

from ..mesh import attributes, children
from ..nodes import group
from ..nodes import plants as nodes
from . import species, store

TITLES = {"trees": "Trees", "ground_cover": "Ground Cover"}


def write(context, terrain, layer, cloud, plants, **inputs):
    """Makes or rewrites a layer's points, and what they show.

    `cloud`: arrays as the worker has them; `plants`: kinds as it describes them; `inputs` of the
    node group by name.
    """
    title = TITLES[layer]
    (ob,) = children.renew(terrain, layer, [title], bpy.data.meshes.new).values()
    of_kind, meshes, pictures = choices(plants)
    fill(ob.data, cloud, of_kind)
    children.place(ob, terrain, terrain.data["orogen_offset"])
    modifier = ob.modifiers.get(nodes.NAME) or ob.modifiers.new(nodes.NAME, "NODES")
    modifier.node_group = nodes.ensure()
    name = f"{terrain.name} {title}"
    for socket, value in {
        "Meshes": store.fill(context.scene, f"{name} meshes", meshes),
        "Impostors": store.fill(context.scene, f"{name} impostors", pictures),
        "Camera": context.scene.camera,
        **inputs,
    }.items():
        group.set_input(modifier, socket, value)
    ob.update_tag()
    return ob


def choices(plants):
    """For each kind the numbers of its variants; the objects that the numbers count."""
    variants = {variant: plant["kind"] for plant in plants for variant in plant["variants"]}
    by_object = {species.find(variant): variant for variant in variants}
    meshes = store.order(by_object)
    of_kind = {}
    for number, ob in enumerate(meshes):
        of_kind.setdefault(variants[by_object[ob]], []).append(number)
    pictures = [species.find(by_object[ob], "picture") for ob in meshes]
    return of_kind, meshes, [ob for ob in pictures if ob]


def fill(mesh, cloud, of_kind):
    count = len(cloud["kinds"])
    mesh.clear_geometry()
    mesh.vertices.add(count)
    mesh.attributes["position"].data.foreach_set("vector", cloud["positions"].ravel())
    plant = np.zeros(count, np.int32)
    chosen = np.random.default_rng(0).random(count)
    for kind, numbers in of_kind.items():
        there = cloud["kinds"] == kind
        plant[there] = np.array(numbers)[(chosen[there] * len(numbers)).astype(int)]
    for name, values in (
        ("species", cloud["kinds"].astype(np.int32)),
        ("plant", plant),
        ("scale", cloud["scales"]),
        ("rotation", cloud["rotations"]),
    ):
        attributes.write_values(mesh, name, values, "POINT")
    mesh.update()
