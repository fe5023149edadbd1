"""Layers of rock as a list: what it holds is the recipe's column."""

MARL = {"lithology": "marl"}


def plates():
    import bpy

    bpy.ops.orogen.add_terrain(start="PLATES")
    terrain = bpy.context.object
    terrain.orogen.resolution = 96
    return terrain, terrain.orogen.column


def column_of(terrain):
    import bpy
    import steps

    return steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)["column"]


def test_every_preset_comes_back_as_it_was():
    import bpy
    import orogen

    terrain, column = plates()
    assert column_of(terrain) == {"preset": terrain.orogen.input.column_preset}
    column.use_layers = True
    for name in orogen.schema()["columns"]:
        assert bpy.ops.orogen.copy_column(preset=name) == {"FINISHED"}
        made, expected = column_of(terrain), orogen.strata.preset_column(name)
        assert [layer["name"] for layer in made["layers"]] == [
            layer.name for layer in reversed(column.layers)
        ]
        for layer, wanted in zip(
            [made["basement"], *made["layers"]],
            [expected["basement"], *expected["layers"]],
            strict=True,
        ):
            assert layer == wanted, name


def test_a_list_that_was_not_touched_grows_the_preset():
    import numpy as np
    import steps

    terrain, column = plates()
    steps.grow()
    before = steps.attribute(terrain, "elevation")
    column.use_layers = True
    assert len(column.layers) == 4
    steps.grow()
    assert np.array_equal(steps.attribute(terrain, "elevation"), before)


def test_buttons():
    import bpy

    terrain, column = plates()
    for operator in (bpy.ops.orogen.add_layer, bpy.ops.orogen.remove_layer):
        assert not operator.poll()
    column.use_layers = True
    names = [layer.name for layer in column.layers]
    assert names[0] == "Molasse"  # the top first
    column.active_layer = 1
    assert bpy.ops.orogen.add_layer() == {"FINISHED"}
    assert [layer.name for layer in column.layers] == [names[0], "Layer", *names[1:]]
    assert column.active().name == "Layer"
    assert bpy.ops.orogen.move_layer(direction="UP") == {"FINISHED"}
    assert bpy.ops.orogen.move_layer(direction="UP") == {"CANCELLED"}
    assert column.active_layer == 0 and column.active().name == "Layer"
    assert bpy.ops.orogen.move_layer(direction="DOWN") == {"FINISHED"}
    assert bpy.ops.orogen.remove_layer() == {"FINISHED"}
    assert [layer.name for layer in column.layers] == names
    for _ in names:
        assert bpy.ops.orogen.remove_layer() == {"FINISHED"}
    assert not bpy.ops.orogen.remove_layer.poll()
    assert bpy.ops.orogen.add_layer() == {"FINISHED"}
    assert column_of(terrain)["layers"] == [
        {
            "name": "Layer",
            "thickness": 1000.0,
            "viscosity": 1e20,
            "fold_wavelength": 0.0,
            "fold_share": 0.1,
            "sub_layers": [{"share": 1.0, "lithology": "limestone"}],
        }
    ]


def test_numbers_rock_and_colour():
    import orogen
    import pytest

    terrain, column = plates()
    column.use_layers = True
    layer = column.layers[1]
    known = {item["name"]: item for item in orogen.schema()["lithologies"]}
    declared = {item["name"]: item for item in orogen.schema()["layer"]}
    for name, item in declared.items():
        prop = layer.bl_rna.properties[name]
        scale = 1e20 if name == "viscosity" else 1.0
        assert prop.hard_max * scale == pytest.approx(item["max"], rel=1e-6)
        assert prop.description.startswith(item["description"].rstrip("."))
    layer.viscosity, layer.fold_share, layer.lithology = 2.5, 0.35, "granite"
    assert layer.resistance == known["granite"]["resistance"] == 1.0
    red = (known["granite"]["natural"] >> 16 & 255) / 255
    assert layer.color[0] == pytest.approx(((red + 0.055) / 1.055) ** 2.4, abs=1e-5)
    terrain.orogen.stages.outcrop.palette = "map"
    assert layer.color[0] > 0.8
    layer.resistance = 0.7
    made = column_of(terrain)["layers"][-2]
    assert made["viscosity"] == 2.5e20 and made["fold_share"] == 0.35
    beds = made["sub_layers"]
    assert len(beds) == 8  # of the preset; the others stay
    assert {"lithology": "granite", "share": 1.0, "resistance": 0.7} in beds
    assert {bed["lithology"] for bed in beds} == {"granite", "shale", "sandstone"}
    orogen.Recipe.from_dict(recipe_of(terrain))


def recipe_of(terrain):
    import bpy
    import steps

    return steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)


def test_thickness_maps():
    import bpy
    import numpy as np
    import steps

    terrain, column = plates()
    column.use_layers = True
    layer = column.layers[2]
    image = bpy.data.images.new("Thick", 300, 200, float_buffer=True)
    grey = np.linspace(0.25, 1.0, 200)  # the south is thin
    pixels = np.repeat(grey, 300 * 4).astype(np.float32)
    image.pixels.foreach_set(pixels)
    layer.thickness_map, layer.thickness = image, 2000
    rows = np.array(column_of(terrain)["layers"][-3]["thickness_map"])
    assert rows.shape == (128, 128)
    assert abs(rows[0] - 500).max() < 0.2 and abs(rows[-1] - 2000).max() < 0.2
    steps.grow()
    assert "strata_color" in terrain.data.attributes


def test_recipes_with_a_column_become_editable(tmp_path):
    import bpy
    import numpy as np
    import orogen
    import steps

    for name in ("one_fold_layer", "two_fold_layers_15_3"):
        terrain = steps.new_terrain(source="EXAMPLE", example=name, resolution=64)
        shipped = recipe_of(terrain)
        assert bpy.ops.orogen.edit_recipe() == {"FINISHED"}
        assert terrain.orogen.source == "PLATES" and terrain.orogen.column.use_layers
        grown = [orogen.generate(recipe).rocks.column for recipe in (recipe_of(terrain), shipped)]
        assert grown[0] == grown[1], name
    jura = orogen.strata.preset_column("jura")
    jura["layers"][1]["thickness_map"] = [[100, 200, 400], [300, 800, 500]]
    terrain = steps.collision(tmp_path, column=jura)
    assert bpy.ops.orogen.edit_recipe() == {"FINISHED"}
    made = column_of(terrain)["layers"][1]
    assert np.allclose(made["thickness_map"], jura["layers"][1]["thickness_map"], atol=0.2)
    assert made["thickness"] == 800


def test_bad_columns_are_told(tmp_path):
    import bpy
    import steps

    rock = {"sub_layers": [MARL]}
    for column, says in [
        (7, "column"),
        ({"preset": "mars"}, "no column 'mars'"),
        ({"layers": 3}, "column.layers"),
        ({"layers": [], "basement": 3}, "column.basement.sub_layers"),
        ({"layers": [{"sub_layers": [{"lithology": "cheese"}]}], "basement": rock}, "'cheese'"),
        ({"layers": [{**rock, "thickness": -5}], "basement": rock}, "layers[0].thickness: -5"),
        ({"layers": [], "basement": {**rock, "thickness_map": [[1], [2, 3]]}}, "thickness_map"),
        ({"layers": [], "basement": {"sub_layers": [{"lithology": ["marl"]}]}}, "no rock"),
        ({"layers": [], "basement": {"sub_layers": [{**MARL, "share": "1"}]}}, "share"),
    ]:
        terrain = steps.collision(tmp_path, column=column)
        assert says in bpy.context.window_manager.orogen.message
        assert says in steps.refused(bpy.ops.orogen.edit_recipe), column
        assert terrain.orogen.source == "FILE"
        bpy.data.objects.remove(terrain)


def test_layers_are_saved(tmp_path):
    import bpy

    terrain, column = plates()
    column.use_layers = True
    column.layers[0].name, column.layers[0].thickness = "Loess", 123
    bpy.ops.orogen.move_layer(direction="DOWN")
    before, name, file = column_of(terrain), terrain.name, str(tmp_path / "layers.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=file)
    assert column_of(bpy.data.objects[name]) == before
