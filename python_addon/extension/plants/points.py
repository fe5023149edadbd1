"""Where plants stand: a mesh of points under a terrain, in metres, which nodes make plants of."""

import bpy
import numpy as np

from ..mesh import attributes, children, terrain_mesh
from ..mesh.roles import with_role
from ..nodes import group
from ..nodes import plants as nodes
from . import species, store

TITLES = {"trees": "Trees", "ground_cover": "Ground Cover"}


def write(context, terrain, layer, cloud, offset, plants, **inputs):
    """Makes or rewrites a layer's points, and what they show.

    `cloud`: arrays as the worker has them; `offset`: of their origin (m); `plants`: kinds as it
    describes them; `inputs` of the node group by name.
    """
    title = TITLES[layer]
    (ob,) = children.renew(terrain, layer, [title], bpy.data.meshes.new).values()
    of_kind, meshes, pictures = choices(plants)
    fill(ob.data, cloud, of_kind)
    children.place(ob, terrain, offset)
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


def settle(terrain, grid, elevation):
    """Puts the plants of a terrain onto its ground, where they stand."""
    cell, offset = grid["cell_size"], terrain_mesh.offset_of(terrain, grid)
    across, up = terrain.orogen.local_scale()
    for layer in TITLES:
        for ob in with_role(terrain, layer):
            position = ob.data.attributes["position"]
            points = np.empty((len(position.data), 3), np.float32)
            position.data.foreach_get("vector", points.ravel())
            place = points[:, :2] + np.subtract(ob[children.OFFSET], offset)
            points[:, 2] = heights(elevation, place / cell - 0.5, cell * across / up)
            position.data.foreach_set("vector", points.ravel())
            ob.data.update()


def heights(elevation, at, cell):
    """Of the two triangles that Blender makes of a cell between four heights; a smooth surface is
    metres off them where cells are large. It cuts from south-west to north-east but where that
    would fold the cell. `at`: (n, 2) columns and rows, beyond the border those of the border;
    `cell`: its size, as high as heights are drawn."""
    last = np.array(elevation.shape)[::-1] - 1
    at = np.clip(at, 0, last)
    low = np.minimum(at.astype(int), last - 1)
    (column, row), (x, y) = low.T, (at - low).T
    base = elevation[row, column]
    east, north, both = (
        elevation[row + down, column + right] - base for down, right in ((0, 1), (1, 0), (1, 1))
    )
    far, near = np.maximum(x, y), np.minimum(x, y)
    beside = np.where(x > y, east, north)
    usual = far * beside + near * (both - beside)
    southwest = x * east + y * north
    northeast = both + (1.0 - x) * (north - both) + (1.0 - y) * (east - both)
    other = np.where(x + y < 1.0, southwest, northeast)
    folds = 2.0 * east * north - both * (east + north) > cell * cell
    return base + np.where(folds, other, usual)


def choices(plants):
    """For each kind the numbers of its variants; the objects that the numbers count."""
    variants = {variant: plant["kind"] for plant in plants for variant in plant["variants"]}
    by_object = {species.get(variant): variant for variant in variants}
    meshes = store.order(by_object)
    of_kind = {}
    for number, ob in enumerate(meshes):
        of_kind.setdefault(variants[by_object[ob]], []).append(number)
    return of_kind, meshes, [species.get(by_object[ob], "picture") for ob in meshes]


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
