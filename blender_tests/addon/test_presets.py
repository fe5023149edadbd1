"""Presets of terrains: those that ship, and one of the user's own."""

NAMES = ["Corsica", "Digne", "Jura", "Rift", "Southern Alps", "Volcanic Island", "Zagros"]


def shipped():
    from pathlib import Path

    import bpy
    import steps

    package = Path(steps.addon().__file__).parent
    paths = [p for p in bpy.utils.preset_paths("orogen/terrain") if Path(p).is_relative_to(package)]
    return {bpy.path.display_name(p.name): p for path in paths for p in Path(path).glob("*.py")}


def test_every_preset_grows():
    import bpy
    import steps

    presets = shipped()
    assert sorted(name.title() for name in presets) == NAMES
    for name, path in presets.items():
        terrain = steps.new_terrain()
        assert bpy.ops.orogen.load_preset(filepath=str(path)) == {"FINISHED"}
        terrain.orogen.resolution = 96
        steps.grow()
        heights = steps.attribute(terrain, "elevation")
        assert 500 < heights.max() < 5000, (name, heights.max())
        below = (heights < 0).mean()
        assert (below > 0.05) == (name.title() in ("Corsica", "Rift", "Volcanic Island")), name


def test_preset_is_for_the_terrain_of_its_child():
    import bpy
    import steps

    bpy.ops.orogen.add_terrain(start="DRAWING")
    terrain = bpy.context.object
    steps.addon("terrains").activate(bpy.context, terrain.orogen.drawing.objects[0])
    path = next(path for name, path in shipped().items() if name.lower() == "zagros")
    bpy.ops.orogen.load_preset(filepath=str(path))
    assert (terrain.orogen.source, terrain.orogen.example) == ("EXAMPLE", "zagros")
    message = steps.refused(bpy.ops.orogen.load_preset, filepath="/nowhere.py")
    assert "nowhere" in message


def test_own_preset_keeps_what_was_set():
    import bpy
    import steps

    terrain = steps.new_terrain(source="EXAMPLE", example="zagros", seed=77)
    terrain.orogen.vertical_exaggeration = 1.25
    terrain.orogen.input.frame_km = (33, 44)
    terrain.orogen.stages.mountain_growth.soft_erodibility = 2.5
    terrain.orogen.column.use_layers = True
    terrain.orogen.column.layers[0].thickness = 321
    assert bpy.ops.orogen.add_terrain_preset(name="Mine") == {"FINISHED"}
    (folder,) = {p for p in bpy.utils.preset_paths("orogen/terrain") if "extensions" not in p}
    other = steps.new_terrain()
    bpy.ops.orogen.load_preset(filepath=f"{folder}/Mine.py")
    assert (other.orogen.example, other.orogen.seed) == ("zagros", 77)
    assert other.orogen.vertical_exaggeration == 1.25
    assert tuple(other.orogen.input.frame_km) == (33, 44)
    assert other.orogen.stages.mountain_growth.soft_erodibility == 2.5
    assert other.orogen.stages.mountain_growth.west_side == "closed"
    assert other.orogen.column.document == terrain.orogen.column.document
    assert [layer.thickness for layer in other.orogen.column.layers][:2] == [321, 900]


def test_presets_have_pictures_that_are_freed():
    import bpy
    import steps

    files = steps.addon("preset_files")
    own = [file for file in files.found() if file.parent == files.OWN]
    assert len(own) == 7
    sizes = [file.with_suffix(".jpg").stat().st_size for file in own]
    assert sum(sizes) < 200_000
    for file in own:
        files.icon(file)  # a number only where there is a window
        assert list(files._pictures[str(file)].image_size) == [256, 256]
    bpy.ops.preferences.addon_disable(module=steps.ADDON)
    assert files._pictures is None
    bpy.ops.preferences.addon_enable(module=steps.ADDON)


def test_a_terrain_is_added_from_a_preset():
    import bpy
    import steps

    path = next(path for name, path in shipped().items() if name.lower() == "zagros")
    assert bpy.ops.orogen.add_from_preset(filepath=str(path)) == {"FINISHED"}
    terrain = bpy.context.object
    assert (terrain.name, terrain.orogen.example) == ("Zagros", "zagros")
    assert "nowhere" in steps.refused(bpy.ops.orogen.add_from_preset, filepath="/nowhere.py")
