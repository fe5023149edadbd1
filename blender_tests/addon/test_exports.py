"""Files for other programs: read back, they are the terrain. Blender reads them here, which did not
write them; blender_tests/module/test_files.py reads them with GDAL and others."""


def grown(resolution=80):
    import steps

    terrain = steps.corsica(resolution=resolution, units_per_km=3.0)
    steps.grow()
    return terrain


def pixels_of(file, data=True):
    """The first channel of a picture, its lower row first."""
    import bpy
    import numpy as np

    image = bpy.data.images.load(str(file))
    image.colorspace_settings.name = "Non-Color"
    values = np.array(image.pixels[:], np.float32)
    return values.reshape(image.size[1], image.size[0], -1)[..., 0], image


def heights(terrain):
    import steps

    nx, ny = terrain.data["orogen_grid"]
    return steps.attribute(terrain, "elevation").reshape(ny, nx)


def export(folder, name, **arguments):
    import bpy

    file = folder / name
    assert bpy.ops.orogen.export_terrain(filepath=str(file), **arguments) == {"FINISHED"}
    assert sorted(p.name for p in folder.iterdir() if p.name.startswith(".orogen")) == []
    return file


def test_float_pictures_read_back_exactly(tmp_path):
    import numpy as np

    terrain = grown()
    for name, format_ in (("heights.exr", "exr"), ("heights.tif", "tif")):
        file = export(tmp_path, name, format=format_)
        values, image = pixels_of(file)
        assert image.is_float
        assert np.array_equal(values, heights(terrain)), name
    area, _ = pixels_of(export(tmp_path, "area.exr", format="exr", field="drainage_area"))
    import steps

    assert np.array_equal(area.ravel(), steps.attribute(terrain, "drainage_area"))


def test_png_with_its_scale(tmp_path):
    import json

    import bpy
    import numpy as np

    terrain = grown()
    file = export(tmp_path, "heights.png", format="png16")
    scale = json.loads((tmp_path / "heights.png.json").read_text())
    image = bpy.data.images.load(str(file))
    assert image.depth in (16, 32, 64)  # Blender counts channels as it likes
    values, _ = pixels_of(file)
    back = values * 65535 * scale["metres_per_unit"] + scale["offset"]
    assert np.abs(back - heights(terrain)).max() < 0.6 * scale["metres_per_unit"] + 1e-2


def test_arrays_and_level_set(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = grown()
    with np.load(export(tmp_path, "all.npz", format="npz")) as archive:
        for name in terrain.data["orogen_fields"]:
            assert np.array_equal(archive[name].ravel(), steps.attribute(terrain, name)), name
    volume = bpy.data.volumes.new("Ground")
    volume.filepath = str(export(tmp_path, "ground.vdb", format="vdb"))
    assert volume.grids.load() and volume.grids[0].name == "ground"
    assert set(p.name for p in tmp_path.iterdir()) == {"all.npz", "ground.vdb"}


def test_triangles_and_folds(tmp_path):
    import json

    import bpy
    import orogen
    import steps

    out = tmp_path / "out"
    out.mkdir()
    terrain = steps.collision(tmp_path, resolution=64)
    steps.grow()
    terrain.orogen.seed = 77  # what is written is the ground that is seen
    grown_terrain = orogen.generate(json.loads(terrain.data["orogen_recipe"]))
    assert grown_terrain.seed == 3
    assert bpy.ops.wm.ply_import(filepath=str(export(out, "tin.ply", format="tin"))) == {"FINISHED"}
    assert len(bpy.context.object.data.vertices) == len(grown_terrain.tin)
    bpy.context.view_layer.objects.active = terrain
    folds = json.loads(export(out, "folds.geojson", format="folds").read_text())
    skeletons = [fold["skeleton"] for fold in grown_terrain.folds]
    assert len(folds["features"]) == sum(len(s.top) + len(s.bottom) for s in skeletons)


def test_what_cannot_be_written_is_said(tmp_path):
    import bpy
    import steps

    terrain = grown(48)
    before = set(tmp_path.iterdir())
    for arguments, word in (
        ({"format": "tin"}, "mountain_growth"),
        ({"format": "folds"}, "fold_layers"),
        ({"format": "tif", "field": "age"}, "age"),
    ):
        file = str(tmp_path / "x.dat")
        assert word in steps.refused(bpy.ops.orogen.export_terrain, filepath=file, **arguments)
    missing = str(tmp_path / "none/x.tif")
    assert "no folder" in steps.refused(bpy.ops.orogen.export_terrain, filepath=missing)
    assert set(tmp_path.iterdir()) == before
    terrain.data.pop("orogen_recipe")
    assert not bpy.ops.orogen.export_terrain.poll()


def test_the_name_follows_the_format():
    import steps

    operator = steps.addon("operators.export_terrain")
    check = operator.OROGEN_OT_export_terrain.check

    class Stub:
        filepath, format = "/tmp/a.b.tif", "exr"
        filename_ext = ".exr"

    stub = Stub()
    assert check(stub, None) and stub.filepath == "/tmp/a.b.exr"
    assert not check(stub, None)
    stub.filepath = "/tmp/heights"
    assert check(stub, None) and stub.filepath == "/tmp/heights.exr"


def test_a_drawn_map_is_saved(tmp_path):
    import json

    import bpy
    import steps
    from test_drawing import RING, add_empty, add_stroke, new_drawing

    add_stroke(new_drawing("Map"), "Coast", [(x, y, 0.0) for x, y in RING], cyclic=True)
    add_empty("Summit", (0.0, 0.0, 1.5))
    terrain = steps.new_terrain(source="DRAWING", resolution=48)
    file = tmp_path / "map.geojson"
    assert bpy.ops.orogen.save_map(filepath=str(file)) == {"FINISHED"}
    steps.grow()
    before = heights(terrain)
    kinds = [f["properties"]["kind"] for f in json.loads(file.read_text())["features"]]
    assert sorted(kinds) == ["coast", "peak"]
    other = steps.new_terrain(source="FILE", path=str(file), resolution=48)
    steps.grow()
    assert (heights(other) == before).all()
    steps.collision(tmp_path)
    assert "no map" in steps.refused(bpy.ops.orogen.save_map, filepath=str(file))


def test_a_dropped_file_is_loaded(tmp_path):
    import json

    import bpy
    import steps

    handler = bpy.types.OROGEN_FH_map
    assert handler.bl_import_operator == "orogen.load_map"
    file = tmp_path / "plates.orogen.json"
    file.write_text(json.dumps(steps.collision_recipe()))
    assert any(str(file).endswith(suffix) for suffix in handler.bl_file_extensions.split(";"))
    found = bpy.ops.orogen.load_map("INVOKE_DEFAULT", filepath=str(file))
    assert found == {"FINISHED"} and bpy.context.object.orogen.path == str(file)
