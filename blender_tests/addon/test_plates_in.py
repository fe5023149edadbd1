"""Moving plates from the scene: collections of arrows, arrow strokes, keys."""


def plates_terrain(**settings):
    import bpy

    bpy.ops.orogen.add_terrain(start="PLATES")
    terrain = bpy.context.object
    for name, value in settings.items():
        setattr(terrain.orogen, name, value)
    return terrain


def recipe_of(terrain):
    import bpy
    import steps

    bpy.context.view_layer.update()
    return steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)


def arrows(terrain, plate):
    collection = next(c for c in terrain.orogen.drawing.children if c.name == plate)
    return sorted(collection.objects, key=lambda ob: ob.name)


def test_two_plates_grow_at_once():
    import json

    import numpy as np
    import orogen
    import steps

    terrain = plates_terrain(resolution=96, seed=1)
    recipe = recipe_of(terrain)
    south, north = recipe["phases"][0]["plates"]
    assert recipe["extent"] == {"origin": [-45e3, -30e3], "size": [90e3, 60e3]}
    assert np.allclose(south["arrows"], [(0, 9000)] * 4, atol=0.02)
    assert np.allclose(north["arrows"], 0, atol=0.02) and north["stable"]
    assert np.isclose(max(y for _, y in south["points"]), -32e3, atol=0.02)
    steps.grow()
    points = steps.positions(terrain)
    assert points[:, 2].max() > 1.0
    assert abs(points[:, 0].min() + 45 - 45 / 96) < 1e-3
    shipped = json.loads(steps.addon("examples").path_of("folded_range").read_text())
    plain = orogen.generate(orogen.Recipe.from_dict(shipped), resolution=96)
    rate = steps.attribute(terrain, "uplift_rate")
    same = np.corrcoef(plain["uplift_rate"].ravel(), rate)[0, 1]
    assert same > 0.85, "cutting the plates off beyond the frame changes the range"


def test_arrows_are_read_as_they_stand():
    import bpy
    import numpy as np
    import steps

    terrain = plates_terrain(units_per_km=0.5)
    terrain.location, terrain.rotation_euler = (100, -20, 3), (0, 0, 0.4)
    first = arrows(terrain, "South")[0]
    first.location, first.empty_display_size = (5, 6, 0), 2.0
    first.rotation_euler, first.scale = (0, np.pi / 2, 0), (1, 1, 1.5)  # to the east
    plate = recipe_of(terrain)["phases"][0]["plates"][0]
    assert np.allclose(plate["points"][0], (10e3, 12e3), atol=0.02)
    assert np.allclose(plate["arrows"][0], (6e3, 0), atol=0.02)
    first.rotation_euler = (0, np.pi / 4, 0)  # half up: its shadow on the plane counts
    plate = recipe_of(terrain)["phases"][0]["plates"][0]
    assert np.allclose(plate["arrows"][0], (6e3 * 0.5**0.5, 0), atol=0.02)
    loose = bpy.data.objects.new("Loose", None)
    loose.empty_display_type = "SINGLE_ARROW"
    loose.location = terrain.matrix_world.translation
    bpy.context.scene.collection.objects.link(loose)
    arrows(terrain, "South")[0].users_collection[0].objects.link(loose)
    bpy.context.view_layer.update()
    plates = recipe_of(terrain)["phases"][0]["plates"]
    assert len(plates[0]["points"]) == 5
    assert np.allclose(sorted(map(abs, plates[0]["points"][-1])), 0, atol=0.02)
    terrain.orogen.source = "DRAWING"
    drawing = steps.addon("scene.drawn_map").read_drawing(terrain, bpy.context.scene)
    assert drawing.peaks == [], "arrows are no peaks"


def test_plates_tell_crust_and_stability():
    terrain = plates_terrain()
    south, north = (c.orogen_plate for c in terrain.orogen.drawing.children)
    south.crust, south.stable, north.stable = "oceanic", True, False
    plates = recipe_of(terrain)["phases"][0]["plates"]
    assert (plates[0]["crust"], plates[0]["stable"]) == ("oceanic", True)
    assert "crust" not in plates[1] and "stable" not in plates[1]
    terrain.orogen.input.column_preset = "jura"
    terrain.orogen.input.phase_years = 3.3e6
    recipe = recipe_of(terrain)
    assert recipe["column"] == {"preset": "jura"} and recipe["phases"][0]["years"] == 3.3e6


def test_strokes_are_arrows():
    import bpy
    import numpy as np
    import steps
    from test_drawing import add_stroke, new_drawing

    pencil = new_drawing("Gestures")
    for x in (-20, 20):
        add_stroke(pencil, "Plate South", [(x, -15, 0), (x, -12, 0), (x + 1, -10, 0)])
        add_stroke(pencil, "plate.north", [(x, 15, 0)])
    terrain = steps.new_terrain(source="PLATES", resolution=64)
    plates = {plate["name"]: plate for plate in recipe_of(terrain)["phases"][0]["plates"]}
    assert set(plates) == {"Plate South", "plate.north"}
    assert np.allclose(plates["Plate South"]["points"], [(-20e3, -15e3), (20e3, -15e3)], atol=0.02)
    assert np.allclose(plates["Plate South"]["arrows"], [(1e3, 5e3)] * 2, atol=0.02)
    assert np.allclose(plates["plate.north"]["arrows"], 0)
    extent = recipe_of(terrain)["extent"]
    assert extent["origin"][0] < -20e3 and extent["size"][0] > 40e3
    terrain.orogen.input.use_frame = True
    steps.grow()
    assert bpy.context.object == terrain


def test_keys_make_phases():
    import bpy
    import numpy as np

    terrain, scene = plates_terrain(), bpy.context.scene
    scene.frame_set(7)
    first, second = arrows(terrain, "South")[:2]
    x = first.location.x
    first.keyframe_insert("location", frame=1)
    first.location.x = x + 4
    first.keyframe_insert("location", frame=21)
    second.keyframe_insert("rotation_euler", frame=31)
    terrain.orogen.input.years_per_frame = 2e5
    phases = recipe_of(terrain)["phases"]
    assert [phase["years"] for phase in phases] == [4e6, 2e6]
    where = [phase["plates"][0]["points"][0][0] for phase in phases]
    assert np.allclose(where, [1e3 * x, 1e3 * (x + 4)], atol=0.02)
    assert scene.frame_current == 7 and scene.frame_subframe == 0


def test_one_key_is_one_phase_and_moves_no_frame():
    import bpy

    terrain, seen = plates_terrain(), []
    note = lambda scene, *_: seen.append(scene.frame_current)  # noqa: E731
    bpy.app.handlers.frame_change_pre.append(note)
    arrows(terrain, "South")[0].keyframe_insert("location", frame=30)
    (phase,) = recipe_of(terrain)["phases"]
    bpy.app.handlers.frame_change_pre.remove(note)
    assert phase["years"] == 5e6 and seen == []


def test_plates_and_arrows_come_and_go():
    import bpy
    import numpy as np

    terrain = plates_terrain()
    assert bpy.ops.orogen.add_plate() == {"FINISHED"}
    plates = recipe_of(terrain)["phases"][0]["plates"]
    assert len(plates) == 3 and np.allclose(plates[2]["arrows"], [(0, 9e3)] * 4, atol=0.02)
    bpy.context.scene.cursor.location = (10, 5, 0)
    assert bpy.ops.orogen.add_arrow() == {"FINISHED"}
    plates = recipe_of(terrain)["phases"][0]["plates"]
    assert np.allclose(plates[2]["points"][4], (10e3, 5e3), atol=0.02)
    assert np.allclose(plates[2]["arrows"][4], (0, 9e3), atol=0.02)
    assert bpy.context.object.name.startswith("Plate")
    count = len(bpy.data.objects)
    assert bpy.ops.orogen.remove_plate() == {"FINISHED"}
    assert len(recipe_of(terrain)["phases"][0]["plates"]) == 2
    assert len(bpy.data.objects) == count - 5 and bpy.context.object == terrain


def test_all_plates_away_is_said():
    import bpy
    import steps

    terrain = plates_terrain()
    while bpy.ops.orogen.remove_plate.poll():
        bpy.ops.orogen.remove_plate()
    assert list(terrain.orogen.drawing.children) == []
    assert "no plate" in steps.refused(bpy.ops.orogen.grow)
    assert bpy.ops.orogen.add_inputs() == {"FINISHED"}
    assert len(terrain.orogen.drawing.children) == 2
