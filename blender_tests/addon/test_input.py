"""What is loaded, and what is refused."""


def test_bad_map_is_reported_and_changes_nothing(tmp_path):
    import json

    import bpy
    import numpy as np
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    before = steps.positions(terrain).copy()
    bad = {
        "broken.geojson": "{not json",
        "empty.geojson": json.dumps({"type": "FeatureCollection", "features": []}),
        "list.geojson": "[1, 2]",
    }
    for name, text in bad.items():
        (tmp_path / name).write_text(text)
        terrain.orogen.source, terrain.orogen.path = "FILE", str(tmp_path / name)
        message = steps.refused(bpy.ops.orogen.grow)
        session = bpy.context.window_manager.orogen
        assert session.is_error and session.message and session.message in message
        assert np.array_equal(steps.positions(terrain), before)
    terrain.orogen.path = str(tmp_path / "missing.geojson")
    assert "missing.geojson" in steps.refused(bpy.ops.orogen.grow)
    terrain.orogen.path = ""
    assert "No map" in steps.refused(bpy.ops.orogen.grow)


def test_load_map_makes_a_terrain(tmp_path):
    import json

    import bpy
    import numpy as np
    import steps

    features = steps.addon("map_features")
    ring = np.array([(0, 0), (60e3, 5e3), (55e3, 40e3), (-5e3, 35e3)])
    peaks = [features.Peak((20e3 + 5e3 * i, 20e3), 1000.0 + 100 * i) for i in range(3)]
    island = features.to_geojson(features.Drawing(coasts=[ring], peaks=peaks))
    file = str(tmp_path / "island.geojson")
    (tmp_path / "island.geojson").write_text(json.dumps(island))
    assert bpy.ops.orogen.load_map(filepath=file) == {"FINISHED"}
    terrain = bpy.context.object
    assert terrain.orogen.is_terrain and terrain.name == "island"
    terrain.orogen.resolution = 64
    steps.grow()
    assert len(terrain.data.vertices) > 1000


def test_recipe_that_properties_cannot_hold_is_refused(tmp_path):
    import json

    import bpy
    import steps

    stage = next(s for s in steps.addon("declarations").STAGES if s.parameters)
    parameter = next(p for p in stage.parameters if p.type == "float")
    example = {"file": str(steps.addon("examples").path_of(steps.CORSICA))}
    file = tmp_path / "bad.orogen.json"
    terrain = steps.new_terrain(source="FILE")
    for parameters in ({"no_such_name": 1}, {parameter.name: parameter.max * 1.5 + 1}):
        stages = [{"stage": stage.name, "parameters": parameters}]
        file.write_text(json.dumps({"orogen": 1, "map": example, "stages": stages}))
        terrain.orogen.path = str(file)
        assert "stages[0].parameters" in bpy.context.window_manager.orogen.message
        assert "stages[0].parameters" in steps.refused(bpy.ops.orogen.grow)


def test_recipe_sets_the_parameters(tmp_path):
    import json

    import bpy
    import orogen
    import steps

    stage = next(s for s in orogen.schema()["stages"] if s["parameters"])
    parameter = next(p for p in stage["parameters"] if p["type"] == "float")
    chosen = stage["name"]
    value = float(f"{0.5 * (parameter['min'] + parameter['max']):.4g}")
    example = steps.addon("examples").path_of(steps.CORSICA)
    recipe = {
        "orogen": 1,
        "name": "mine",
        "seed": 11,
        "resolution": 77,
        "map": {"file": str(example)},
        "stages": [
            {"stage": name, "parameters": {parameter["name"]: value} if name == chosen else {}}
            for name in orogen.schema()["default_stages"]
        ],
    }
    (tmp_path / "mine.orogen.json").write_text(json.dumps(recipe))
    bpy.ops.orogen.load_map(filepath=str(tmp_path / "mine.orogen.json"))
    settings = bpy.context.object.orogen
    assert (settings.seed, settings.resolution) == (11, 77)
    back = steps.addon("settings_recipe").to_recipe(bpy.context.object, bpy.context.scene)
    got = {item["stage"]: item["parameters"] for item in back["stages"]}
    assert got[stage["name"]] == {parameter["name"]: value}
    bpy.ops.orogen.reset_parameters(stage=stage["name"])
    back = steps.addon("settings_recipe").to_recipe(bpy.context.object, bpy.context.scene)
    assert not any(item["parameters"] for item in back["stages"])


def test_settings_survive_saving(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = steps.corsica(resolution=64, seed=9, vertical_exaggeration=1.5)
    stage = next(s for s in steps.addon("declarations").STAGES if s.parameters)
    parameter = next(p for p in stage.parameters if p.type == "float")
    value = float(f"{0.5 * (parameter.min + parameter.max):.3g}")
    set_value = steps.addon("properties.stages").set_value
    set_value(getattr(terrain.orogen.stages, stage.name), parameter, value)
    steps.grow()
    name, points = terrain.name, steps.positions(terrain).copy()
    file = str(tmp_path / "scene.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=file)
    terrain = bpy.data.objects[name]
    settings = terrain.orogen
    assert (settings.seed, settings.resolution, settings.example) == (9, 64, steps.CORSICA)
    assert settings.vertical_exaggeration == 1.5
    value_of = steps.addon("properties.stages").value_of
    assert value_of(getattr(settings.stages, stage.name), parameter) == value
    assert np.array_equal(steps.positions(terrain), points)
    bpy.context.view_layer.objects.active = terrain
    steps.grow()
    assert np.array_equal(steps.positions(terrain), points)


def test_older_settings_are_migrated(tmp_path):
    import bpy
    import steps

    migration = steps.addon("properties.migration")
    steps.new_terrain(version=0)
    file = str(tmp_path / "old.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    migration.STEPS[0] = lambda settings: setattr(settings, "seed", 123)
    bpy.ops.wm.open_mainfile(filepath=file)
    (settings,) = [ob.orogen for ob in bpy.data.objects]
    assert (settings.version, settings.seed) == (migration.VERSION, 123)
    assert settings.input.join_tolerance == 0.0, "each open coast was a ring of its own"


def test_warnings_of_the_map_are_listed():
    import bpy
    import orogen
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    expected = orogen.generate(orogen.Recipe.from_dict(recipe)).warnings
    assert [warning.text for warning in terrain.orogen.problems] == list(expected)
