"""Lines of a drawing: joined strokes, curve objects, dots; what the map then says."""


def test_map_features_nest_and_thin():
    import numpy as np
    import steps

    features = steps.addon("map_features")

    def square(x, y, half):
        corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        return np.array([(x + half * a, y + half * b) for a, b in corners], float)

    island, lagoon, islet, other = (
        square(0, 0, 10),
        square(0, 0, 5),
        square(0, 0, 1),
        square(30, 0, 2),
    )
    polygons = features.nest([lagoon, other, islet, island])
    assert sorted(len(rings) for rings in polygons) == [1, 1, 2]
    assert any(rings[0] is island and rings[1] is lagoon for rings in polygons)
    line = np.array([(0, 0), (0, 0.001), (1, 0), (1, 0)])
    assert features.thin(line, 0.01).tolist() == [[0, 0], [1, 0]]
    collection = features.to_geojson(features.Drawing(coasts=[island]))
    assert collection["units"] == "m" and collection["frame"]["size_km"][0] > 0.02
    (ring,) = collection["features"][0]["geometry"]["coordinates"]
    assert ring[0] == ring[-1] and np.min(ring) > 0


def arcs(count, gap, radius=1000.0):
    """A circle in pieces, with gaps of so many degrees, in no order and either direction."""
    import numpy as np

    pieces = []
    for k in range(count):
        begin, end = 360.0 * k / count, 360.0 * (k + 1) / count - gap
        turn = np.radians(np.linspace(begin, end, 30))
        piece = radius * np.stack([np.cos(turn), np.sin(turn)], axis=-1)
        pieces.append(piece[::-1] if k % 2 else piece)
    return pieces[::2] + pieces[1::2]


def test_open_strokes_join_into_a_ring():
    import numpy as np
    import steps

    join = steps.addon("join_lines").join
    for count in (1, 2, 5, 8):
        joined = join(arcs(count, gap=1.0), tolerance=20.0)
        (ring,) = joined.rings
        assert len(ring) == 30 * count and joined.gaps == []
        steps_ = np.hypot(*(np.roll(ring, -1, axis=0) - ring).T)
        assert steps_.max() < 220 / count, "the pieces are not in order"
    far = join(arcs(3, gap=10.0), tolerance=20.0)
    assert len(far.rings) == 1 and len(far.gaps) == 3
    alone = join(arcs(3, gap=1.0), tolerance=0)
    assert len(alone.rings) == len(alone.gaps) == 3
    both = join(arcs(2, gap=1.0) + [p + 5000 for p in arcs(2, gap=1.0)], tolerance=20.0)
    assert len(both.rings) == 2 and not both.gaps


def test_coast_in_strokes_is_one_coast_and_a_gap_is_told():
    import bpy
    import numpy as np
    import steps
    from test_drawing import add_stroke, new_drawing

    pencil = new_drawing("Map")
    for piece in arcs(3, gap=1.0, radius=20.0):
        add_stroke(pencil, "Coast", [(x, y, 0) for x, y in piece])
    terrain = steps.new_terrain(source="DRAWING")
    read = steps.addon("scene.drawn_map").read_drawing
    drawing = read(terrain, bpy.context.scene)
    assert len(drawing.coasts) == 1 and drawing.problems == []
    terrain.orogen.input.join_tolerance = 0.001
    drawing = read(terrain, bpy.context.scene)
    assert len(drawing.coasts) == 1 and len(drawing.problems) == 3
    problem = drawing.problems[0]
    assert "open" in problem.text and abs(np.hypot(*problem.place) - 20e3) < 10


def new_curve(name, kind, points, cyclic=False, **settings):
    import bpy

    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new(kind)
    if kind == "BEZIER":
        spline.bezier_points.add(len(points) - 1)
        for knot, point in zip(spline.bezier_points, points, strict=True):
            knot.co, knot.handle_left_type, knot.handle_right_type = point, "AUTO", "AUTO"
    else:
        spline.points.add(len(points) - 1)
        for i, (knot, point) in enumerate(zip(spline.points, points, strict=True)):
            knot.co = (*point, 1.0 + 0.5 * (i % 2))
    spline.use_cyclic_u = cyclic
    for key, value in settings.items():
        setattr(spline, key, value)
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.update()
    return ob


CORNERS = [(0, 0, 0), (10, 2, 1), (14, 9, 0), (6, 14, 2), (-3, 8, 0), (-5, 3, 1)]


def test_curves_are_read_as_blender_draws_them():
    import bpy
    import numpy as np
    import steps

    read_curves = steps.addon("scene.curves").read_curves
    kinds = [
        ("POLY", {}),
        ("BEZIER", {}),
        ("NURBS", {"order_u": 4, "use_endpoint_u": False}),
        ("NURBS", {"order_u": 3, "use_endpoint_u": True}),
        ("NURBS", {"order_u": 5, "use_endpoint_u": True}),
    ]
    for kind, settings in kinds:
        # What the end points of a closed curve do has changed from one Blender to the next.
        for cyclic in (False, True) if not settings.get("use_endpoint_u") else (False,):
            ob = new_curve("Coast", kind, CORNERS, cyclic, **settings)
            ob.location, ob.rotation_euler, ob.scale = (1, 2, 3), (0.1, 0.2, 0.3), (2, 1, 1)
            ob.data.resolution_u = 16
            bpy.context.view_layer.update()
            mesh = ob.to_mesh()
            drawn = np.array([tuple(ob.matrix_world @ vertex.co) for vertex in mesh.vertices])
            ob.to_mesh_clear()
            ob.data.bevel_depth = 0.5
            (stroke,) = read_curves(ob)
            assert stroke.cyclic == cyclic and stroke.layer.startswith("Coast")
            far = np.linalg.norm(stroke.points[:, None] - drawn, axis=2)
            step = max(
                np.linalg.norm(np.diff(line, axis=0), axis=1).max()
                for line in (drawn, stroke.points)
            )
            place = (kind, settings, cyclic)
            assert far.min(axis=0).max() < 0.55 * step + 1e-4, place
            assert far.min(axis=1).max() < 0.55 * step + 1e-4, place
            if not cyclic:
                assert np.allclose(stroke.points[[0, -1]], drawn[[0, -1]], atol=1e-4), place


def test_curves_make_a_map():
    import bpy
    import steps

    new_curve("Coast of the island", "BEZIER", CORNERS, cyclic=True)
    new_curve("River.001", "POLY", [(5, 7, 0), (8, 6, 0), (13, 6, 0)])
    new_curve("Path", "POLY", CORNERS)["orogen_kind"] = "Lake"
    new_curve("Other", "POLY", CORNERS)
    terrain = steps.new_terrain(source="DRAWING")
    drawing = steps.addon("scene.drawn_map").read_drawing(terrain, bpy.context.scene)
    assert [len(part) for part in (drawing.coasts, drawing.rivers, drawing.lakes)] == [1, 1, 1]
    assert len(drawing.coasts[0]) == 16 * len(CORNERS)


def test_dots_and_empties_are_peaks():
    import bpy
    import numpy as np
    import steps
    from test_drawing import add_empty, add_stroke, new_drawing

    pencil = new_drawing("Map")
    add_stroke(pencil, "Peaks", [(3, 4, 0)])
    add_stroke(pencil, "Peaks", [(7, 8, 1.2), (7.2, 8, 1.2)])
    add_stroke(pencil, "Volcanoes", [(1, 1, 0)])
    add_empty("Volcano Etna", (0, 9, 3.3))
    add_empty("Tracing Paper", (0, 0, 2)).empty_display_type = "IMAGE"
    terrain = steps.new_terrain(source="DRAWING")
    drawing = steps.addon("scene.drawn_map").read_drawing(terrain, bpy.context.scene)
    found = sorted((*peak.position, peak.height or 0, peak.volcano) for peak in drawing.peaks)
    expected = [
        (0, 9000, 3300, True),
        (1000, 1000, 0, True),
        (3000, 4000, 0, False),
        (7100, 8000, 1200, False),
    ]
    assert np.allclose(found, expected, atol=0.01)
    terrain.orogen.input.use_frame = True
    map_ = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)["map"]
    said = [feature["properties"] for feature in map_["features"]]
    assert sum(item.get("volcano", False) for item in said) == 2
    assert sum("height_m" in item for item in said) == 2


def test_the_frame_is_the_map():
    import bpy
    import steps
    from test_drawing import RING, add_stroke, new_drawing

    pencil = new_drawing("Map")
    add_stroke(pencil, "Coast", [(x, y, 0) for x, y in RING], cyclic=True)
    terrain = steps.new_terrain(source="DRAWING", resolution=80)
    terrain.orogen.input.use_frame, terrain.orogen.input.frame_km = True, (80, 50)
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    assert recipe["map"]["frame"] == {"origin_m": [-40e3, -25e3], "size_km": [80, 50]}
    (coast,) = recipe["map"]["features"]
    assert coast["properties"]["clipped"], "the coast leaves the frame in the north and south"
    steps.grow()
    points = steps.positions(terrain)
    assert abs(points[:, 0].min() + 39.5) < 1e-3 and abs(points[:, 1].max() - 24.5) < 1e-3
    southern = points[points[:, 1] < -24]
    assert southern[abs(southern[:, 0]) < 10, 2].min() > 0, "land does not go on beyond the frame"
    terrain.orogen.input.frame_km = (80, 80)
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    assert "clipped" not in recipe["map"]["features"][0]["properties"]
