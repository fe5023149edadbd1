"""Feature curves drawn in the scene: curve objects, grease pencil, their numbers and outlines."""


def island(resolution=96):
    import bpy

    assert bpy.ops.orogen.add_terrain(start="ISLAND") == {"FINISHED"}
    terrain = bpy.context.object
    terrain.orogen.resolution = resolution
    return terrain


def activate(ob):
    import bpy
    import steps

    steps.addon("terrains").activate(bpy.context, ob)


def add(terrain, kind):
    import bpy

    activate(terrain)
    assert bpy.ops.orogen.add_feature_curve(kind=kind) == {"FINISHED"}
    bpy.context.view_layer.update()
    return bpy.context.object


def recipe(terrain):
    import bpy
    import steps

    return steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)


def heights(terrain):
    import steps

    nx, ny = terrain.data["orogen_grid"]
    return steps.attribute(terrain, "elevation").reshape(ny, nx)


def at(terrain, places):
    import steps

    return steps.addon("mesh.relief").Relief(terrain).at(places)


def smooth_island(resolution=192):
    """A grown island, without erosion, so that ground is as curves want it."""
    import steps

    terrain = island(resolution)
    terrain.orogen.stages.hydraulic_erosion.duration = 0
    steps.grow()
    return terrain


def test_a_ridge_bends_the_ground_to_its_height():
    import numpy as np
    import steps

    terrain = smooth_island()
    before = heights(terrain).copy()
    ob = add(terrain, "RIDGE")
    assert ob.parent == terrain and len(recipe(terrain)["features"]) == 1
    for point in ob.data.splines[0].bezier_points:
        point.co.z = point.handle_left.z = point.handle_right.z = 2.5
    ob.orogen_feature.plateau = 1500
    activate(terrain)
    steps.grow()
    (curve,) = recipe(terrain)["features"]
    places = np.array([point["position"] for point in curve["points"]])
    assert np.abs(places[:, 2] - 2500).max() < 1
    assert np.abs(at(terrain, places[:, :2]) - 2500).max() < 50  # 2 %
    changed = heights(terrain) != before
    assert 0.02 < changed.mean() < 0.5 and not changed[0].any() and not changed[-1].any()


def test_kinds_differ_in_what_they_make():
    import numpy as np
    import steps

    terrain = smooth_island()
    plain = heights(terrain).copy()
    curves = {kind: add(terrain, kind) for kind in ("RIDGE", "VALLEY", "CLIFF", "RIVER_BED")}
    activate(terrain)
    change = {}
    for kind, ob in curves.items():
        for other in curves.values():
            other.hide_viewport = other != ob
        steps.grow()
        change[kind] = heights(terrain) - plain
    assert change["RIDGE"].mean() > 1.0 and change["VALLEY"].mean() < -1.0
    assert change["RIVER_BED"].mean() < 0.0
    assert np.abs(change["RIVER_BED"]).sum() < np.abs(change["VALLEY"]).sum()
    assert change["CLIFF"].max() > 100 and change["CLIFF"].min() < -100


def test_splines_of_all_kinds_are_read_as_they_are_drawn():
    """A straight line of each kind, moved and turned with its object."""
    import bpy
    import numpy as np

    terrain = island()
    for kind in ("POLY", "NURBS", "BEZIER"):
        data = bpy.data.curves.new(kind, "CURVE")
        data.dimensions = "3D"
        spline = data.splines.new(kind)
        points = spline.bezier_points if kind == "BEZIER" else spline.points
        points.add(3)
        for x, point in enumerate(points):
            point.co = (x, 0, 0.5) if kind == "BEZIER" else (x, 0, 0.5, 1)
        if kind == "BEZIER":
            for point in points:
                point.handle_left_type = point.handle_right_type = "VECTOR"
        else:
            spline.use_endpoint_u, spline.order_u = True, 3
        ob = bpy.data.objects.new(kind, data)
        ob.location, ob.rotation_euler.z = (2, 1, 0), np.pi / 2
        bpy.context.scene.collection.objects.link(ob)
        ob.orogen_feature.is_feature = True
    bpy.context.view_layer.update()
    features = recipe(terrain)["features"]
    assert {curve["name"] for curve in features} == {"POLY", "NURBS", "BEZIER"}
    for curve in features:
        places = np.array([point["position"] for point in curve["points"]])
        assert np.abs(places[:, 0] - 2000).max() < 0.5 and np.abs(places[:, 2] - 500).max() < 0.5
        assert np.abs(places[[0, -1], 1] - (1000, 4000)).max() < 0.5
        assert (np.diff(places[:, 1]) > 0).all() and len(places) > 20


def test_radius_tilt_and_lists_are_numbers_of_points():
    import numpy as np

    terrain = island()
    ob = add(terrain, "RIDGE")
    settings = ob.orogen_feature
    settings.plateau, settings.slope_size_left, settings.slope_angle_left = 100, 800, 20
    points = ob.data.splines[0].bezier_points
    points[0].radius, points[2].tilt = 2.0, np.radians(10)
    ob["envelope_left"] = [float("nan"), 4000.0, *[float("nan")] * 5]
    ob["elevation"] = [1, 0, 0, 0, 0, 0, 0]
    settings.envelope_left = 1000
    (curve,) = recipe(terrain)["features"]
    first, middle, last = (curve["points"][i] for i in (0, 16, 32))
    assert (first["plateau"], middle["plateau"], last["plateau"]) == (200, 100, 100)
    assert first["left"]["slope_size"] == 1600 and first["right"] == first["left"]
    assert last["left"]["slope_angle_deg"] == 30 and last["right"]["slope_angle_deg"] == 10
    assert first["left"]["envelope"] == 2000 and middle["left"]["envelope"] == 4000
    assert middle["right"]["envelope"] == 1000
    assert [p["elevation"] for p in (first, middle, last)] == [True, False, False]
    assert curve["points"][8]["plateau"] == 150


def test_selected_points_are_set_in_edit_mode():
    import bpy

    terrain = island()
    ob = add(terrain, "RIDGE")
    ob.orogen_feature.plateau = 100
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.curve.select_all(action="DESELECT")
    ob.data.splines[0].bezier_points[1].select_control_point = True
    points = ob.orogen_feature.points
    assert points.plateau == 100
    points.plateau, points.elevation = 700, False
    assert points.plateau == 700 and not points.elevation
    bpy.ops.object.mode_set(mode="OBJECT")
    (curve,) = recipe(terrain)["features"]
    assert [p["plateau"] for p in curve["points"][:33:16]] == [100, 700, 100]
    assert not curve["points"][16]["elevation"] and curve["points"][0]["elevation"]
    assert bpy.ops.orogen.forget_point_values() == {"FINISHED"}
    (curve,) = recipe(terrain)["features"]
    assert {p["plateau"] for p in curve["points"]} == {100}


def test_a_curve_drawn_flat_becomes_one_on_the_ground():
    import bpy
    import numpy as np
    import steps

    terrain = smooth_island()
    bpy.ops.curve.primitive_bezier_curve_add(radius=8)
    ob = bpy.context.object
    ob.name = "River of mine"
    assert "features" not in recipe(terrain)
    assert bpy.ops.orogen.set_feature_kind(kind="RIVER_BED") == {"FINISHED"}
    lift = steps.addon("feature_curves").KINDS["RIVER_BED"].lift * 90e3
    ends = [np.array(point.co) * 1000 for point in ob.data.splines[0].bezier_points]
    for x, y, z in ends:
        assert abs(z - lift - at(terrain, [(x, y)])[0]) < 1
    assert bpy.ops.orogen.lay_feature_curve(lift=300) == {"FINISHED"}
    (curve,) = recipe(terrain)["features"]
    x, y, z = curve["points"][0]["position"]
    assert abs(z - 300 - at(terrain, [(x, y)])[0]) < 1
    assert not steps.addon("scene.drawn_map").read_drawing(terrain, bpy.context.scene).rivers


def test_grease_pencil_is_read_by_its_layers():
    import bpy
    import numpy as np
    import steps

    terrain = smooth_island()
    plain = heights(terrain).copy()
    for layer in ("Ridges", "Valleys"):
        assert bpy.ops.orogen.draw(layer=layer) == {"FINISHED"}
        bpy.ops.object.mode_set(mode="OBJECT")
        ob = bpy.context.object
        line = np.column_stack([np.linspace(-10, 10, 60), np.full(60, 4.0)])
        line[:, 1] *= 1 if layer == "Ridges" else -1
        steps.addon("scene.pencil").add_strokes(ob, layer, [line], 1)
    ridge, valley = recipe(terrain)["features"]
    assert ridge["name"].endswith("Ridges") and not ridge["points"][0]["elevation"]
    assert [c["points"][0]["left"]["slope_angle_deg"] for c in (ridge, valley)] == [25, -16]
    activate(terrain)
    steps.grow()
    change = heights(terrain) - plain
    south, north = np.split(change, 2)
    assert north.max() > 400 and north.sum() > 0
    assert south.min() < -100 and south.sum() < 0
    if ob.type == "GREASEPENCIL":
        drawing = ob.data.layers["Ridges"].frames[0].drawing
        values = drawing.attributes.new("plateau", "FLOAT", "POINT").data
        values.foreach_set("value", np.full(len(values), 321.0, np.float32))
        assert {p["plateau"] for p in recipe(terrain)["features"][0]["points"]} == {321}


def test_any_terrain_takes_curves_where_they_lie():
    """A recipe with a map far from 0, centred on its object."""
    import numpy as np
    import steps

    terrain = steps.corsica(128)
    add(terrain, "RIDGE")
    assert "features" not in recipe(terrain)  # where the map lies is not known yet
    activate(terrain)
    steps.grow()
    asked = recipe(terrain)
    names = [item["stage"] for item in asked["stages"]]
    assert names.index("feature_curves") < names.index("map_law")
    steps.grow()
    assert recipe(terrain) == asked  # nothing runs in circles
    terrain.orogen.resolution = 100
    steps.grow()
    assert recipe(terrain)["features"] == asked["features"]
    places = np.array([p["position"] for p in asked["features"][0]["points"]])
    middle = np.array(terrain.data["orogen_middle"])
    assert (np.abs(places[:, :2] - middle).max(axis=0) < 40e3).all()


def test_another_terrains_curves_are_its_own():
    first = island()
    add(first, "RIDGE")

    activate(first)
    second = island()
    assert len(recipe(first)["features"]) == 1 and "features" not in recipe(second)


def test_what_is_wrong_is_marked_where_it_is():
    import bpy
    import numpy as np
    import steps

    terrain = smooth_island(64)
    ob = add(terrain, "CLIFF")
    ob["plateau"] = [1.0, 2.0]
    activate(terrain)
    steps.grow()
    (problem,) = terrain.orogen.problems
    assert problem.has_place and "'plateau' is no list of 7 numbers" in problem.text
    del ob["plateau"]
    ob.data.splines[0].bezier_points[2].tilt = np.radians(-40)
    assert "slope_angle" in steps.refused(bpy.ops.orogen.grow)
    (problem,) = terrain.orogen.problems
    assert problem.is_error and problem.text.startswith("Cliff: ")
    end = np.array(ob.matrix_world @ ob.data.splines[0].bezier_points[2].co)[:2] * 1000
    assert np.hypot(*(np.array(problem.place) - end)) < 12e3


def test_curves_survive_saving_and_undo_of_the_panel(tmp_path):
    import bpy

    terrain = island()
    ob = add(terrain, "VALLEY")
    ob["plateau"] = [10.0, 20.0, 30.0, 40.0, 30.0, 20.0, 10.0]
    before = recipe(terrain)["features"]
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "a.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "a.blend"))
    terrain = next(ob for ob in bpy.data.objects if ob.orogen.is_terrain)
    assert recipe(terrain)["features"] == before


def test_curves_of_a_recipe_become_editable(tmp_path):
    """And ask for the same ground again."""
    import json

    import bpy
    import numpy as np
    import steps

    terrain = island()
    ob = add(terrain, "CLIFF")
    ob.data.splines[0].bezier_points[2].radius = 3.0
    before = recipe(terrain)
    extent = {"origin": [5e5, 4e6], "size": before["extent"]["size"]}
    move = np.array([5e5 + 45e3, 4e6 + 30e3, 0.0])
    for point in before["features"][0]["points"]:
        point["position"] = (np.array(point["position"]) + move).tolist()
    file = tmp_path / "cliff.orogen.json"
    file.write_text(json.dumps({**before, "extent": extent}))
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = None
    assert bpy.ops.orogen.load_map(filepath=str(file)) == {"FINISHED"}
    assert bpy.ops.orogen.edit_recipe() == {"FINISHED"}
    terrain = steps.addon("terrains").active(bpy.context)
    assert terrain.orogen.source == "ISLAND"
    (after,) = recipe(terrain)["features"]
    (wanted,) = before["features"]
    assert after["name"].startswith("Cliff")
    for name in ("plateau", "elevation"):
        assert after["points"][32][name] == wanted["points"][2][name]
    first, last = after["points"][0], after["points"][-1]
    assert first["right"] == wanted["points"][0]["right"]
    for mine, theirs in ((first, 0), (last, -1)):
        place = np.array(wanted["points"][theirs]["position"]) - move
        assert np.abs(np.array(mine["position"]) - place).max() < 0.5


def test_the_outline_has_the_asked_sizes():
    """Of a straight curve along x, at z = 900."""
    import numpy as np
    import steps

    curves, shapes = steps.addon("feature_curves"), steps.addon("feature_shape")
    x = np.linspace(0, 10e3, 41)
    points = np.column_stack([x, np.zeros(41), np.full(41, 900.0)])
    sizes = {"plateau": 100, "slope_size_left": 400, "slope_size_right": 0}
    sizes |= {"slope_angle_left": 45, "slope_angle_right": 0}
    sizes |= {"envelope_left": 500, "envelope_right": 300}
    numbers = {name: np.full(41, float(value)) for name, value in sizes.items()}
    shape = shapes.shape(curves.FeatureCurve("a", points, numbers, np.ones(41, bool)))
    assert set(np.unique(shape.rims[:, 1])) == {-100, 100}
    assert np.allclose(shape.feet[:, 1:], (500, 500))  # 400 m down at 45 degrees
    starts, ends = shape.normals[::2], shape.normals[1::2]
    assert np.allclose(ends - starts, (0, 400, -400)) and 8 <= len(starts) <= 48
    assert np.allclose(shape.border.max(axis=0)[1], 1000)
    assert np.allclose(shape.border.min(axis=0)[1], -400)
    assert shape.border[:, 0].min() < -400 and shape.border[:, 0].max() > 10.4e3
    # A hairpin: no part of the border lies inside the reach of another place.
    turn = np.linspace(0, np.pi, 60)
    points = np.column_stack([300 * np.cos(turn), 300 * np.sin(turn), np.zeros(60)])
    numbers = {name: np.full(60, 0.0) for name in sizes} | {
        "envelope_left": np.full(60, 900.0),
        "envelope_right": np.full(60, 900.0),
    }
    shape = shapes.shape(curves.FeatureCurve("b", points, numbers, np.ones(60, bool)))
    gaps = np.hypot(*(shape.border[:, None] - points[:, :2]).transpose(2, 0, 1)).min(axis=1)
    assert (gaps > 0.99 * 900).all() and (gaps < 1.01 * 900).all()
