"""The extension comes and goes without a trace, and needs no native code for it."""


def test_disabling_removes_everything():
    import bpy

    bpy.ops.preferences.addon_disable(module="bl_ext.user_default.orogen")
    assert not hasattr(bpy.types.Object, "orogen")
    assert not hasattr(bpy.types.WindowManager, "orogen")
    assert not [name for name in dir(bpy.types) if "OROGEN" in name]
    handlers = [getattr(bpy.app.handlers, name) for name in dir(bpy.app.handlers)]
    lists = [found for found in handlers if isinstance(found, list)]
    assert not [f for found in lists for f in found if "orogen" in getattr(f, "__module__", "")]
    bpy.ops.preferences.addon_enable(module="bl_ext.user_default.orogen")
    assert hasattr(bpy.types.Object, "orogen")


def test_enabling_loads_no_core():
    import sys

    import steps

    steps.corsica()
    assert "orogen" not in sys.modules and "orogen._core" not in sys.modules


def test_search_path_is_left_alone():
    import sys

    import bpy

    before = list(sys.path)
    bpy.ops.preferences.addon_disable(module="bl_ext.user_default.orogen")
    bpy.ops.preferences.addon_enable(module="bl_ext.user_default.orogen")
    assert [p for p in sys.path if p not in before] == []


def test_parameters_equal_the_declarations():
    import bpy
    import orogen
    import pytest
    import steps

    terrain = steps.new_terrain()
    declared = orogen.schema()["stages"]
    stages = steps.addon("declarations").STAGES
    assert [stage.name for stage in stages] == [stage["name"] for stage in declared]
    value_of = steps.addon("properties.stages").value_of
    for stage, item in zip(stages, declared, strict=True):
        group = getattr(terrain.orogen.stages, stage.name)
        shown = group.bl_rna.properties
        names = [parameter["name"] for parameter in item["parameters"]]
        assert [p.identifier for p in shown if p.identifier not in ("rna_type", "name")] == names
        for parameter, known in zip(stage.parameters, item["parameters"], strict=True):
            prop = shown[known["name"]]
            place = f"{item['name']}.{known['name']}"
            assert value_of(group, parameter) == known["default"], place
            assert prop.description.startswith(known["description"].rstrip(".")), place
            if known["type"] in ("int", "float"):
                scale = parameter.scale
                assert prop.hard_min * scale == pytest.approx(known["min"], rel=1e-6), place
                assert prop.hard_max * scale == pytest.approx(known["max"], rel=1e-6), place
                unit = known["unit"]
                assert unit in ("", "1") or unit in prop.name, place
            if known["type"] == "choice":
                assert [i.identifier for i in prop.enum_items] == known["choices"], place
    assert bpy.ops.orogen.reset_parameters() == {"FINISHED"}


def test_values_reach_the_recipe_as_typed():
    import bpy
    import orogen
    import steps

    terrain = steps.corsica()
    to_recipe = steps.addon("settings_recipe").to_recipe
    set_value = steps.addon("properties.stages").set_value
    untouched = to_recipe(terrain, bpy.context.scene)["stages"]
    assert [item["stage"] for item in untouched] == orogen.schema()["default_stages"]
    assert not any(item["parameters"] for item in untouched)
    for stage in steps.addon("declarations").STAGES:
        for p in stage.parameters:
            if p.type != "float":
                continue
            wanted = float(f"{p.min + 0.37 * (p.max - p.min):.4g}")
            set_value(getattr(terrain.orogen.stages, stage.name), p, wanted)
            recipe = to_recipe(terrain, bpy.context.scene)
            got = {item["stage"]: item["parameters"] for item in recipe["stages"]}
            if stage.name not in got:
                continue
            assert got[stage.name].get(p.name, p.default) == wanted, (stage.name, p.name)
