"""A .blend with terrains goes through a Blender that has no Orogen, and nothing is lost."""

import subprocess
import sys

WITHOUT = """
import bpy, os, sys
bpy.ops.wm.open_mainfile(filepath=sys.argv[1])
assert not hasattr(bpy.types.Object, "orogen")
assert not [name for name in sys.modules if name.endswith(".orogen")]
for ob in bpy.data.objects:
    ob.location.x += 1.0
bpy.ops.wm.save_as_mainfile(filepath=sys.argv[2])
sys.stdout.flush()
os._exit(0)
"""
SETTINGS = ("orogen", "orogen_feature", "orogen_spring")  # groups of an object's properties


def group_values(group):
    """All that a property group holds, in groups inside it too."""
    values = {}
    for prop in group.bl_rna.properties:
        name = prop.identifier
        if name == "rna_type" or prop.is_readonly and prop.type not in ("POINTER", "COLLECTION"):
            continue
        value = getattr(group, name)
        if prop.type == "COLLECTION":
            values[name] = [group_values(item) for item in value]
        elif prop.type == "POINTER":
            is_data = value is None or hasattr(value, "users")
            values[name] = value and value.name if is_data else group_values(value)
        else:
            values[name] = list(value) if getattr(prop, "is_array", False) else value
    return values


def own_data(block):
    """Custom properties, those of the extension's settings apart."""
    return {k: str(v) for k, v in block.items() if k not in SETTINGS}


def mesh_hashes(mesh):
    import hashlib

    import numpy as np

    found = {"faces": len(mesh.polygons), "edges": len(mesh.edges)}
    for attribute in mesh.attributes:
        shape = {"FLOAT": 1, "INT": 1, "FLOAT_VECTOR": 3, "FLOAT_COLOR": 4}.get(attribute.data_type)
        if not shape:
            continue
        key = {"FLOAT_VECTOR": "vector", "FLOAT_COLOR": "color"}.get(attribute.data_type, "value")
        kind = np.int32 if attribute.data_type == "INT" else np.float32
        values = np.empty(len(attribute.data) * shape, kind)
        attribute.data.foreach_get(key, values)
        found[attribute.name] = hashlib.sha256(values.tobytes()).hexdigest()
    return found


def look(material):
    """A material as text: its nodes, their values, their links."""
    tree = material.node_tree
    lines = [
        f"{node.name} {socket.identifier} {value_of(socket)}"
        for node in tree.nodes
        for socket in node.inputs
    ]
    for k in tree.links:
        ends = k.from_node.name, k.from_socket.identifier, k.to_node.name, k.to_socket.identifier
        lines.append(" ".join(ends))
    return sorted(lines)


def value_of(socket):
    value = getattr(socket, "default_value", None)
    return list(value) if hasattr(value, "__len__") else value


def everything():
    import bpy

    objects = {}
    for ob in bpy.data.objects:
        objects[ob.name] = {
            "settings": {name: group_values(getattr(ob, name)) for name in SETTINGS},
            "own": own_data(ob),
            "parent": ob.parent and ob.parent.name,
            "scale": list(ob.scale),
            "modifiers": [m.type for m in ob.modifiers],
        }
        if ob.type == "MESH":
            objects[ob.name]["mesh"] = mesh_hashes(ob.data)
            objects[ob.name]["mesh data"] = own_data(ob.data)
            objects[ob.name]["materials"] = [look(m) for m in ob.data.materials if m]
    collections = {c.name: sorted(o.name for o in c.objects) for c in bpy.data.collections}
    return objects, collections


def test_nothing_is_lost(tmp_path):
    import bpy
    import numpy as np
    import steps

    plain = steps.corsica(resolution=64, seed=7, vertical_exaggeration=2.5)
    plain.orogen.stages.folds.octaves = 3
    steps.grow()
    bpy.context.view_layer.objects.active = None
    rocks = steps.collision(tmp_path, resolution=48)
    rocks.orogen.strata = 0.25
    steps.grow()
    assert bpy.ops.orogen.add_block() == {"FINISHED"}
    drawing = bpy.data.collections.new("Drawing")
    bpy.context.scene.collection.children.link(drawing)
    peak = bpy.data.objects.new("Peak", None)
    drawing.objects.link(peak)
    drawn = steps.new_terrain(source="DRAWING", drawing=drawing, resolution=40)
    names = plain.name, rocks.name, drawn.name

    to_recipe = steps.addon("settings_recipe").to_recipe
    recipes = [to_recipe(bpy.data.objects[n], bpy.context.scene) for n in names[:2]]
    expected = everything()
    assert expected[0][names[2]]["settings"]["orogen"]["drawing"] == "Drawing"
    assert expected[0][names[1]]["materials"] and len(expected[0]) > 5

    here, there = str(tmp_path / "with.blend"), str(tmp_path / "without.blend")
    bpy.ops.wm.save_as_mainfile(filepath=here)
    command = [sys.executable, "-P", "-c", WITHOUT, here, there]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr

    bpy.ops.wm.open_mainfile(filepath=there)
    found = everything()
    for name, ob in expected[0].items():
        for what, value in ob.items():
            assert found[0][name][what] == value, (name, what)
    assert found == expected
    plain, rocks = (bpy.data.objects[n] for n in names[:2])
    assert [to_recipe(ob, bpy.context.scene) for ob in (plain, rocks)] == recipes
    before = steps.positions(plain)
    bpy.context.view_layer.objects.active = plain
    steps.grow()
    assert np.array_equal(steps.positions(plain), before)
