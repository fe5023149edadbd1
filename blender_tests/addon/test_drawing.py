"""Maps drawn in the scene: grease pencil of this Blender's generation, and empties."""

RING = [(-20.0, -30.0), (25.0, -28.0), (30.0, 20.0), (5.0, 36.0), (-24.0, 22.0)]  # km
RIVER = [(2.0, 10.0), (10.0, 2.0), (22.0, -4.0), (34.0, -6.0)]


def new_drawing(name):
    """A grease-pencil object."""
    import bpy

    pencils = getattr(bpy.data, "grease_pencils_v3", bpy.data.grease_pencils)
    ob = bpy.data.objects.new(name, pencils.new(name))
    bpy.context.scene.collection.objects.link(ob)
    return ob


def add_stroke(ob, layer_name, points, cyclic=False):
    """Draws points (world, with z) through the inverse of what the layer does to them."""
    import bpy
    import numpy as np

    flat = np.array(points, np.float32).ravel()
    if ob.type == "GPENCIL":
        layer = next((a for a in ob.data.layers if a.info == layer_name), None)
        layer = layer or ob.data.layers.new(layer_name)
        frame = layer.frames[0] if len(layer.frames) else layer.frames.new(1)
        stroke = frame.strokes.new()
        stroke.points.add(len(points))
        stroke.points.foreach_set("co", flat)
        stroke.use_cyclic = cyclic
    else:
        layer = next((a for a in ob.data.layers if a.name == layer_name), None)
        layer = layer or ob.data.layers.new(layer_name)
        frame = layer.frames[0] if len(layer.frames) else layer.frames.new(1)
        drawing = frame.drawing
        before = len(drawing.attributes["position"].data) if len(drawing.strokes) else 0
        drawing.add_strokes([len(points)])
        for i, point in enumerate(points):
            drawing.attributes["position"].data[before + i].vector = point
        drawing.strokes[-1].cyclic = cyclic
    bpy.context.view_layer.update()
    return layer


def add_empty(name, location, parent=None):
    import bpy

    ob = bpy.data.objects.new(name, None)
    ob.location, ob.parent = location, parent
    bpy.context.scene.collection.objects.link(ob)
    return ob


def exact(location, rotation, scale=(1, 1, 1)):
    """A transform in double precision; the rotation is an XYZ Euler."""
    import numpy as np

    sine, cosine = np.sin(rotation), np.cos(rotation)
    x = [[1, 0, 0], [0, cosine[0], -sine[0]], [0, sine[0], cosine[0]]]
    y = [[cosine[1], 0, sine[1]], [0, 1, 0], [-sine[1], 0, cosine[1]]]
    z = [[cosine[2], -sine[2], 0], [sine[2], cosine[2], 0], [0, 0, 1]]
    matrix = np.eye(4)
    matrix[:3, :3] = np.array(z) @ y @ x @ np.diag(scale)
    matrix[:3, 3] = location
    return matrix


def test_strokes_are_read_through_all_transforms():
    """To 1e-5 in the world: object, its parent, the layer's own transform, the layer's parent."""
    import bpy
    import numpy as np
    import steps

    points = np.array([(1, 2, 3), (4, -5, 6), (0, 1, 0)], float)

    def assert_read(matrix):
        bpy.context.view_layer.update()
        (stroke,) = read_strokes(ob, 1)
        expected = points @ matrix[:3, :3].T + matrix[:3, 3]
        assert np.abs(stroke.points - expected).max() < 1e-5
        return stroke

    read_strokes = steps.addon("scene.strokes").read_strokes
    ob = new_drawing("Map")
    ob.location, ob.rotation_euler, ob.scale = (3, -2, 1), (0.1, 0.2, 0.7), (2, 2, 2)
    world = exact((3, -2, 1), (0.1, 0.2, 0.7), (2, 2, 2))
    layer = add_stroke(ob, "Coast", points, cyclic=True)
    layer.rotation, layer.scale = (0.3, 0.0, 0.4), (1.5, 1.0, 0.5)
    setattr(layer, "location" if ob.type == "GPENCIL" else "translation", (5, 6, 7))
    own = exact((5, 6, 7), (0.3, 0.0, 0.4), (1.5, 1.0, 0.5))
    stroke = assert_read(world @ own)
    assert stroke.layer == "Coast" and stroke.cyclic

    carrier = add_empty("Carrier", (0, 4, -1))
    carrier.rotation_euler = (0.0, 0.6, 0.0)
    ob.parent = carrier
    world = exact((0, 4, -1), (0.0, 0.6, 0.0)) @ world
    assert_read(world @ own)

    parent = add_empty("Parent", (10, 0, 0))
    parent.rotation_euler = (0, 0, 1.0)
    layer.parent = parent
    bpy.context.view_layer.update()
    placed = exact((10, 0, 0), (0, 0, 1.0))
    if ob.type == "GPENCIL":
        inverse = np.array(layer.matrix_inverse, float)
        matrix = world @ own @ np.linalg.inv(world) @ placed @ inverse
    else:
        matrix = placed @ np.array(layer.matrix_parent_inverse, float) @ own
    assert_read(matrix)
    layer.hide = True
    assert read_strokes(ob, 1) == []


def test_only_the_frame_in_force_is_read():
    import steps

    ob = new_drawing("Map")
    layer = add_stroke(ob, "Rivers", [(0, 0, 0), (1, 0, 0)])
    read_strokes = steps.addon("scene.strokes").read_strokes
    layer.frames.new(10)
    assert len(read_strokes(ob, 9)) == 1
    assert len(read_strokes(ob, 10)) == 0
    assert len(read_strokes(ob, 0)) == 0


def test_drawing_is_read_in_metres_of_the_terrain():
    import bpy
    import numpy as np
    import steps

    terrain = steps.new_terrain(source="DRAWING", units_per_km=0.5, vertical_exaggeration=2.0)
    terrain.location, terrain.rotation_euler = (7, 8, 9), (0, 0, 0.3)
    bpy.context.view_layer.update()
    world = terrain.matrix_world

    def placed(x_km, y_km, z_km=0.0):
        from mathutils import Vector

        return world @ Vector((0.5 * x_km, 0.5 * y_km, z_km))  # 0.5 units a km, twice as tall

    ob = new_drawing("Map")
    add_stroke(ob, "Coast", [placed(*p) for p in RING], cyclic=True)
    add_stroke(ob, "Rivers", [placed(*p) for p in RIVER])
    add_stroke(ob, "Notes", [placed(*p) for p in RIVER])
    add_empty("High", placed(-5, 10, 2.5))
    add_empty("Unknown", placed(5, -10, -1.0))
    bpy.context.view_layer.update()
    drawing = steps.addon("scene.drawn_map").read_drawing(terrain, bpy.context.scene)
    assert np.allclose(drawing.coasts[0], np.array(RING) * 1000, atol=0.1)
    assert len(drawing.rivers) == 1
    assert np.allclose(drawing.rivers[0], np.array(RIVER) * 1000, atol=0.1)
    peaks = {peak.name: peak for peak in drawing.peaks}
    assert np.allclose(peaks["High"].position, (-5000, 10000), atol=0.1)
    assert abs(peaks["High"].height - 2500) < 0.1
    assert peaks["Unknown"].height is None


def test_drawn_island_grows_where_it_was_drawn():
    import bpy
    import numpy as np
    import steps

    ob = new_drawing("Map")
    add_stroke(ob, "Coast", [(x, y, 0) for x, y in RING], cyclic=True)
    add_stroke(ob, "Rivers", [(x, y, 0) for x, y in RIVER])
    for i, (x, y, z) in enumerate([(-5, 10, 2.0), (-4, 2, 2.3), (-2, -8, 1.8)]):
        add_empty(f"Peak {i}", (x, y, z))
    terrain = steps.new_terrain(source="DRAWING", resolution=160)
    steps.grow()
    points = steps.positions(terrain)
    inside = steps.addon("map_features").contains
    sample = points[::37]
    drawn = np.array([inside(np.array(RING), p[:2]) for p in sample])
    assert np.mean(drawn == (sample[:, 2] > 0)) > 0.97
    for ob in bpy.data.objects:
        if ob.type == "EMPTY":
            near = np.hypot(*(points[:, :2] - ob.location[:2]).T) < 0.6
            assert abs(points[near, 2].max() - ob.location.z) < 0.15 * ob.location.z


def test_only_the_chosen_collection_is_read():
    import bpy
    import steps

    chosen = bpy.data.collections.new("Map")
    bpy.context.scene.collection.children.link(chosen)
    chosen.objects.link(add_empty("Peak", (0, 0, 1)))
    add_empty("Other", (5, 5, 1))
    terrain = steps.new_terrain(source="DRAWING", drawing=chosen)
    drawing = steps.addon("scene.drawn_map").read_drawing(terrain, bpy.context.scene)
    assert [peak.name for peak in drawing.peaks] == ["Peak"]


def test_nothing_drawn_is_said():
    import bpy
    import steps

    steps.new_terrain(source="DRAWING")
    assert "Nothing is drawn" in steps.refused(bpy.ops.orogen.grow)
