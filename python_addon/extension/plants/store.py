"""Where plants are kept: a collection that no view layer shows, with one for each use in it."""

import bpy

NAME = "Orogen Plants"


def ensure(scene):
    """The hidden collection, linked to the scene."""
    kept = bpy.data.collections.get(NAME) or bpy.data.collections.new(NAME)
    if kept.name not in scene.collection.children:
        scene.collection.children.link(kept)
    for layer in scene.view_layers:
        found = layer.layer_collection.children.get(kept.name)
        if found:
            found.exclude = True
    return kept


def fill(scene, name, objects):
    """The collection of that name within, which holds just these objects."""
    kept = ensure(scene)
    part = kept.children.get(name)
    if part is None:
        part = bpy.data.collections.new(name)
        kept.children.link(part)
    for ob in set(part.objects) - set(objects):
        part.objects.unlink(ob)
    for ob in set(objects) - set(part.objects):
        part.objects.link(ob)
    return part


def order(objects):
    """Objects as geometry nodes count a collection's children: by name."""
    return sorted(objects, key=lambda ob: ob.name.lower())
