"""Geometry-node groups that ship: they evaluate, and make what they say."""


def evaluated():
    import bpy

    bpy.context.view_layer.update()
    return bpy.context.evaluated_depsgraph_get()


def instances_of(child):
    """World positions of what a child's nodes place."""
    found = evaluated().object_instances
    return [
        item.matrix_world.translation.copy()
        for item in found
        if item.is_instance and item.parent and item.parent.original == child
    ]


def child_with(terrain, role):
    (child,) = (ob for ob in terrain.children if ob.get("orogen_role") == role)
    return child


def grown(**settings):
    import steps

    terrain = steps.corsica(resolution=96, **settings)
    steps.grow()
    return terrain


def test_scatter_stands_where_the_field_says():
    import bpy
    import numpy as np
    import steps

    terrain = grown()
    terrain.location = (5, 6, 0)
    count = len(bpy.data.objects)
    assert bpy.ops.orogen.add_scatter(field="elevation", low=200.0, high=900.0, density=2.0) == {
        "FINISHED"
    }
    child = child_with(terrain, "scatter")
    places = np.array(instances_of(child))
    assert len(places) > 500
    heights = places[:, 2] * 1000
    assert heights.min() > 199.9 and heights.max() < 900.1
    modifier = child.modifiers[0]
    set_input = steps.addon("nodes.group").set_input
    set_input(modifier, "Density", 4.0)
    child.update_tag()
    assert 1.7 < len(instances_of(child)) / len(places) < 2.3
    set_input(modifier, "Steepest", 0.0)
    child.update_tag()
    assert not instances_of(child)
    assert len(bpy.data.objects) == count + 2


def test_scatter_takes_the_other_selected_object():
    import bpy

    terrain = grown()
    other = bpy.data.objects.new("Stone", bpy.data.meshes.new("Stone"))
    other.data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    bpy.context.scene.collection.objects.link(other)
    other.select_set(True)
    bpy.ops.orogen.add_scatter(field="elevation", low=10.0, density=1.0)
    bpy.ops.orogen.add_scatter(field="elevation", low=10.0, density=1.0)
    children = [ob for ob in terrain.children if ob.get("orogen_role") == "scatter"]
    assert len(children) == 2
    names = {
        item.object.name
        for item in evaluated().object_instances
        if item.is_instance and item.parent.original in children
    }
    assert names == {"Stone"} and "Orogen Cone" not in bpy.data.objects
    assert len([g for g in bpy.data.node_groups if g.name.startswith("Orogen Scatter")]) == 1


def test_water_lies_in_the_valleys():
    import bpy
    import numpy as np
    import steps

    terrain = grown()
    assert bpy.ops.orogen.add_water(least_area=20.0, depth=10.0) == {"FINISHED"}
    child = child_with(terrain, "water")
    mesh = child.evaluated_get(evaluated()).data
    points = np.array([vertex.co for vertex in mesh.vertices])
    assert len(points) > 50
    area, ground = steps.attribute(terrain, "drainage_area"), steps.positions(terrain)
    cell = terrain.data["orogen_cell_size"] / 1000
    wet = ground[(area > 20e6) & (ground[:, 2] > 0), :2]

    def cells(places):
        return {tuple(c) for c in np.rint((places - ground[0, :2]) / cell).astype(int).tolist()}

    assert cells(wet) <= cells(points[:, :2])
    assert "Orogen Sea" in [m.name for m in mesh.materials if m], list(mesh.materials)
    modifier = child.modifiers[0]
    steps.addon("nodes.group").set_input(modifier, "Sea", True)
    child.update_tag()
    with_sea = child.evaluated_get(evaluated()).data
    heights = np.array([vertex.co.z for vertex in with_sea.vertices])
    assert (heights == 0).sum() > 1000
