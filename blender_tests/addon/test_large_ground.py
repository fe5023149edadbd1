"""Ground with too many cells for one mesh, in tiles. Small tiles stand for large ones."""


def small_tiles():
    import steps

    large = steps.addon("mesh.large_ground")
    large.MOST_CELLS, large.TILE, large.COARSE = 10_000, 50, 60
    return large


def tiles(terrain):
    return {
        ob["orogen_part"]: ob for ob in terrain.children if ob.get("orogen_role") == "ground tile"
    }


def test_tiles_are_the_ground_to_the_bit_and_share_their_borders():
    import numpy as np
    import steps

    whole = steps.corsica(160)
    steps.grow()
    nx, ny = whole.data["orogen_grid"]
    wanted = steps.positions(whole).reshape(ny, nx, 3).copy()
    area = steps.attribute(whole, "drainage_area").reshape(ny, nx)
    small_tiles()
    terrain = steps.corsica(160)
    steps.grow()
    parts = tiles(terrain)
    assert len(parts) == -(-(nx - 1) // 50) * -(-(ny - 1) // 50)
    seen = np.zeros((ny, nx), int)
    for part, ob in parts.items():
        _, i, j = part.split()
        columns, rows = ob.data["orogen_grid"]
        place = np.s_[50 * int(i) :, 50 * int(j) :]
        got = steps.positions(ob).reshape(rows, columns, 3)
        assert np.array_equal(got, wanted[place][:rows, :columns])
        assert np.array_equal(
            steps.attribute(ob, "drainage_area").reshape(rows, columns),
            area[place][:rows, :columns],
        )
        assert ob.data.materials[0] == terrain.data.materials[0]
        seen[place][:rows, :columns] += 1
    assert seen.min() == 1 and set(np.unique(seen)) == {1, 2, 4}  # borders belong to both


def test_the_terrain_keeps_a_coarse_mesh_at_the_same_place():
    import bpy
    import numpy as np
    import steps

    large = small_tiles()
    terrain = steps.corsica(160)
    steps.grow()
    assert max(terrain.data["orogen_grid"]) <= large.COARSE
    assert terrain.hide_render and terrain.display_type == "BOUNDS"
    fine = np.concatenate([steps.positions(ob) for ob in tiles(terrain).values()])
    coarse = {tuple(place) for place in np.round(steps.positions(terrain), 4)}
    assert coarse <= {tuple(place) for place in np.round(fine, 4)}
    assert "orogen_recipe" in terrain.data
    before = max(fine[:, 2])
    terrain.orogen.vertical_exaggeration = 2.0
    bpy.context.view_layer.update()
    assert all(abs(ob.scale.z - 2.0) < 1e-6 for ob in tiles(terrain).values())
    steps.grow()
    fine = np.concatenate([steps.positions(ob) for ob in tiles(terrain).values()])
    assert abs(max(fine[:, 2]) - 2 * before) < 1e-4
    assert all(abs(ob.scale.z - 1.0) < 1e-6 for ob in tiles(terrain).values())


def test_smaller_ground_is_one_mesh_again():
    import bpy
    import steps

    small_tiles()
    terrain = steps.corsica(160)
    steps.grow()
    meshes = len(bpy.data.meshes)
    steps.grow()
    assert len(bpy.data.meshes) == meshes, "older tiles are gone"
    terrain.orogen.resolution = 96
    steps.grow()
    assert not tiles(terrain) and not terrain.hide_render and terrain.display_type == "TEXTURED"
    assert max(terrain.data["orogen_grid"]) == 96


def test_what_is_given_up_leaves_the_terrain_as_it_was():
    import bpy
    import steps

    small_tiles()
    terrain = steps.corsica(96)
    steps.grow()
    before, meshes = steps.positions(terrain), len(bpy.data.meshes)
    jobs = steps.addon("worker.jobs").jobs
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    job = jobs.wait(jobs.start(recipe, resolution=160))
    work = steps.addon("mesh.terrain_mesh").write_large(terrain, job.result, recipe)
    next(work)
    next(work)
    assert len(bpy.data.meshes) == meshes + 2
    work.close()
    job.result.close()
    assert len(bpy.data.meshes) == meshes and not tiles(terrain)
    assert (steps.positions(terrain) == before).all()


def colours(ob):
    import numpy as np

    rgba = np.empty((len(ob.data.vertices), 4), np.float32)
    ob.data.attributes["orogen_view"].data.foreach_get("color", rgba.ravel())
    return rgba


def test_tiles_show_the_field_as_the_coarse_mesh_does():
    import numpy as np
    import steps

    small_tiles()
    terrain = steps.corsica(160)
    terrain.orogen.view.field = "drainage_area"
    steps.grow()
    of_place = {
        tuple(place): rgba
        for ob in tiles(terrain).values()
        for place, rgba in zip(np.round(steps.positions(ob), 4), colours(ob), strict=True)
    }
    for place, rgba in zip(np.round(steps.positions(terrain), 4), colours(terrain), strict=True):
        assert np.array_equal(of_place[tuple(place)], rgba)
    a_tile = tiles(terrain)["ground 0 0"]
    assert a_tile.material_slots[0].material.name == "Orogen View"
    before = colours(a_tile)
    terrain.orogen.view.field = "land"
    assert not np.array_equal(colours(a_tile), before)
    terrain.orogen.view.field = "slope"
    assert len(np.unique(colours(a_tile), axis=0)) > 20
    terrain.orogen.view.field = "MATERIAL"
    assert "orogen_view" not in a_tile.data.attributes
    assert a_tile.material_slots[0].material == terrain.data.materials[0]


def test_what_wants_one_mesh_says_so():
    import bpy
    import steps

    small_tiles()
    terrain = steps.corsica(160)
    steps.grow()
    for operator in (bpy.ops.orogen.add_solid, bpy.ops.orogen.add_water, bpy.ops.orogen.add_uv):
        assert "in tiles is too large" in steps.refused(operator)
    terrain.orogen.paints.keep.method = "VERTEX"
    bpy.ops.orogen.paint(layer="keep")
    assert terrain.display_type == "TEXTURED" and terrain.hide_render
    assert all(ob.hide_viewport for ob in tiles(terrain).values())
    mesh = terrain.data
    mesh.attributes["orogen_paint_keep"].data.foreach_set("color", [1.0] * 4 * len(mesh.vertices))
    assert bpy.ops.orogen.end_painting() == {"FINISHED"}
    assert terrain.mode == "OBJECT" and terrain.display_type == "BOUNDS"
    assert not any(ob.hide_viewport for ob in tiles(terrain).values())
    terrain.orogen.paints.freeze = True
    assert "Freeze" in steps.refused(bpy.ops.orogen.grow)


def test_files_have_all_cells(tmp_path):
    import bpy
    import steps
    import tifffile

    small_tiles()
    steps.corsica(160)
    steps.grow()
    bpy.ops.orogen.export_terrain(filepath=str(tmp_path / "x.tif"), format="tif", field="elevation")
    assert max(tifffile.imread(tmp_path / "x.tif").shape) == 160
