"""Objects of species: meshes that every terrain shares."""

import bpy

from ..mesh.terrain_mesh import NotNow
from . import materials, plant_mesh

PLANT = "orogen_plant"  # property of an object: the variant that it shows
MADE_FROM = "orogen_made_from"  # property of an object: what it was made from


def find(variant, kind="mesh"):
    return next((ob for ob in bpy.data.objects if ob.get(PLANT) == f"{variant} {kind}"), None)


def get(variant, kind="mesh"):
    """The same; NotNow where an undo took it away."""
    if (ob := find(variant, kind)) is None:
        raise NotNow("Plants were taken away while they were made")
    return ob


def is_made(variant, kind, made_from):
    ob = find(variant, kind)
    return ob is not None and ob.get(MADE_FROM) == made_from


def ensure(plant, meshes):
    """Objects of a plant's variants, made anew where the species is another than before.

    `plant`: as the worker describes it; `meshes`: arrays by variant.
    """
    for variant in plant["variants"]:
        if not is_made(variant, "mesh", plant["fingerprint"]):
            _make(plant, variant, meshes[variant])


def new(variant, kind, name, data):
    ob = bpy.data.objects.new(name, data)
    ob[PLANT] = f"{variant} {kind}"
    return ob


def _make(plant, variant, arrays):
    ob = find(variant)
    if ob is None:
        name = f"Orogen {variant}"
        ob = new(variant, "mesh", name, bpy.data.meshes.new(name))
    ob.data.materials.clear()
    for material in materials.ensure(plant["name"], plant["colors"]):
        ob.data.materials.append(material)
    plant_mesh.write(ob.data, arrays)
    ob[MADE_FROM] = plant["fingerprint"]
