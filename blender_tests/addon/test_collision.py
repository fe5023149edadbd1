"""Recipes of colliding plates: no map, stages of their own, strata in the mesh."""


def test_recipe_without_a_map_grows(tmp_path):
    import bpy
    import numpy as np
    import orogen
    import steps

    terrain = steps.collision(tmp_path, resolution=80)
    assert (terrain.orogen.seed, terrain.orogen.resolution) == (3, 80)
    steps.grow()
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    stages = [item["stage"] for item in recipe["stages"]]
    assert stages == orogen.schema()["collision_stages"]
    expected = orogen.generate(orogen.Recipe.from_dict(recipe))
    for name in expected.fields:
        if name != "strata_color":
            assert np.array_equal(steps.attribute(terrain, name), expected[name].ravel()), name
    assert terrain.data.attributes["rock_layer"].data_type == "INT"
    assert expected["elevation"].max() > 100


def test_example_of_plates_grows():
    import orogen
    import steps

    terrain = steps.new_terrain(source="EXAMPLE", example="folded_range", resolution=64)
    assert terrain.orogen.stages.mountain_growth.west_side == "closed"
    steps.grow()
    assert "strata_color" in terrain.data.attributes
    terrain.orogen.example = steps.CORSICA
    assert terrain.orogen.stage_names() == tuple(orogen.schema()["default_stages"])


def test_strata_colors_are_linear(tmp_path):
    import bpy
    import numpy as np
    import orogen
    import steps

    terrain = steps.collision(tmp_path)
    steps.grow()
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    packed = orogen.generate(orogen.Recipe.from_dict(recipe))["strata_color"].ravel()
    attribute = terrain.data.attributes["strata_color"]
    assert (attribute.data_type, attribute.domain) == ("FLOAT_COLOR", "POINT")
    linear = steps.colors(terrain.data, "strata_color")
    assert np.all(linear[:, 3] == 1)
    back = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    bytes_ = np.rint(255 * back[:, :3]).astype(int)
    assert np.array_equal(bytes_ @ [65536, 256, 1], packed)
    assert len(np.unique(packed)) > 3
    assert terrain["orogen_strata"] == 1
    terrain.orogen.strata = 0.25
    terrain.orogen.bare_rock = 1.0
    assert (terrain["orogen_strata"], terrain["orogen_bare_rock"]) == (0.25, 1.0)


def test_terrain_from_far_away_lies_on_its_object(tmp_path):
    import numpy as np
    import steps

    terrain = steps.collision(tmp_path)
    steps.grow()
    points = steps.positions(terrain)
    assert np.allclose(points[:, :2].min(axis=0), -points[:, :2].max(axis=0), atol=1e-4)
    assert abs(np.ptp(points[:, 0]) - 40 * 95 / 96) < 1e-3
    assert np.allclose(terrain.data["orogen_origin"], steps.COLLISION_ORIGIN)
    assert len(terrain.children) == 0, "there is no sea"


def test_panels_show_the_stages_of_what_is_picked(tmp_path):
    import bpy
    import orogen
    import steps

    def shown():
        panels = steps.addon("panels.stages").PANELS
        return {panel.stage.name for panel in panels if panel.poll(bpy.context)}

    schema = orogen.schema()
    with_parameters = {stage["name"] for stage in schema["stages"] if stage["parameters"]}
    maps = with_parameters & set(schema["default_stages"])
    plates = with_parameters & set(schema["collision_stages"])
    terrain = steps.collision(tmp_path)
    assert shown() == plates
    terrain.orogen.source = "EXAMPLE"
    assert shown() == maps
    terrain.orogen.source = "FILE"
    assert shown() == plates
    terrain.orogen.source = "DRAWING"
    assert shown() == maps
    few = [{"stage": "collision"}, {"stage": "fold_layers", "parameters": {}}]
    other = steps.collision(tmp_path, stages=few)
    assert other == terrain and terrain.orogen.source == "FILE"
    assert shown() <= {"collision", "fold_layers"}


def test_recipe_of_the_scene_is_the_recipe(tmp_path):
    import json

    import bpy
    import steps

    terrain = steps.collision(tmp_path)
    file = tmp_path / "saved.orogen.json"
    assert bpy.ops.orogen.save_recipe(filepath=str(file)) == {"FINISHED"}
    saved, recipe = json.loads(file.read_text()), json.loads(json.dumps(steps.collision_recipe()))
    assert all(saved[key] == value for key, value in recipe.items())
    assert "map" not in saved and terrain.name == "two plates"


def test_a_map_takes_the_strata_away(tmp_path):
    import steps

    terrain = steps.collision(tmp_path)
    steps.grow()
    terrain.orogen.source, terrain.orogen.example = "EXAMPLE", steps.CORSICA
    terrain.orogen.resolution = 64
    steps.grow()
    assert "strata_color" not in terrain.data.attributes
    assert terrain["orogen_strata"] == 0 and terrain.data["orogen_rocks"] == "[]"
