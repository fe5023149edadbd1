"""Objects of species: meshes that every terrain shares."""

import bpy

from . import materials, plant_mesh

PLANT = "orogen_plant"  # property of an object: the variant that it shows
MADE_FROM = "orogen_made_from"  # property of an object: what it was made from


def find(variant, kind="mesh"):
    return next((ob for ob in bpy.data.objects if ob.get(PLANT) == f"{variant} {kind}"), None)


def ensure(plant, meshes):
    """Objects of a plant's variants, made anew where the species is another than before.

    `plant`: as the worker describes it; `meshes`: arrays by variant.
    """
    return [_ensure(plant, variant, meshes[variant]) for variant in plant["variants"]]


def new(variant, kind, name, data):
    ob = bpy.data.objects.new(name, data)
    ob[PLANT] = f"{variant} {kind}"
    return ob


def _ensure(plant, variant, arrays):
    ob = find(variant)
    if ob is None:
        name = f"Orogen {variant}"
        ob = new(variant, "mesh", name, bpy.data.meshes.new(name))
    if ob.get(MADE_FROM) != plant["fingerprint"]:
        ob.data.materials.clear()
        for material in materials.ensure(plant["name"], plant["colors"]):
            ob.data.materials.append(material)
        plant_mesh.write(ob.data, arrays)
        ob[MADE_FROM] = plant["fingerprint"]
    return ob
