"""The browser of seeds."""


def browsed(count=3, **settings):
    import bpy
    import steps

    terrain = steps.corsica(resolution=64, seed=17, **settings)
    assert bpy.ops.orogen.browse_seeds(count=count) == {"FINISHED"}
    return terrain


def variations(terrain):
    return [child for child in terrain.children if child.get("orogen_role") == "variation"]


def test_variations_stand_side_by_side():
    import bpy
    import numpy as np
    import steps
    from orogen.preview import generate_preview

    terrain = browsed(count=5, units_per_km=2.0, vertical_exaggeration=1.5)
    found = variations(terrain)
    assert [ob.name for ob in found] == [f"Seed {seed}" for seed in range(17, 22)]
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    bpy.context.view_layer.update()
    boxes = []
    for ob in found:
        expected = generate_preview(recipe, seed=ob["orogen_seed"])["elevation"]
        assert np.array_equal(steps.attribute(ob, "elevation"), expected.ravel())
        points = steps.positions(ob)
        assert np.allclose(points[:, 2], expected.ravel() * 0.003, rtol=1e-6, atol=1e-7)
        points = points @ np.array(ob.matrix_world)[:3, :3].T + ob.matrix_world.translation
        boxes.append((points[:, :2].min(axis=0), points[:, :2].max(axis=0)))
    for i, (low, high) in enumerate(boxes):
        for other_low, other_high in boxes[:i]:
            assert (low > other_high).any() or (high < other_low).any(), "they overlap"
    west = min(low[0] for low, _ in boxes)
    steps.grow()
    assert steps.positions(terrain)[:, 0].max() < west
    terrain.orogen.units_per_km = 1.0
    bpy.context.view_layer.update()
    assert np.allclose(found[0].matrix_world.to_scale(), 0.5)


def test_picking_takes_the_seed_and_removes_the_rest():
    import bpy

    terrain = browsed()
    meshes = {ob.data.name for ob in variations(terrain)}
    bpy.context.view_layer.objects.active = variations(terrain)[1]
    assert bpy.ops.orogen.pick_seed() == {"FINISHED"}
    assert terrain.orogen.seed == 18 and not variations(terrain)
    assert not meshes & set(bpy.data.meshes.keys())
    assert bpy.context.object == terrain and terrain.select_get()


def test_picking_by_number_and_none_at_all():
    import bpy
    import steps

    terrain = browsed()
    assert "active" in steps.refused(bpy.ops.orogen.pick_seed)
    assert len(variations(terrain)) == 3
    assert bpy.ops.orogen.pick_seed(seed=19) == {"FINISHED"}
    assert terrain.orogen.seed == 19


def test_browsing_again_shows_others_and_clearing_keeps_the_seed():
    import bpy

    terrain = browsed()
    bpy.ops.orogen.browse_seeds(count=2)
    assert [ob.name for ob in variations(terrain)] == ["Seed 20", "Seed 21"]
    bpy.context.view_layer.objects.active = variations(terrain)[0]
    assert bpy.ops.orogen.clear_seeds() == {"FINISHED"}
    assert terrain.orogen.seed == 17 and not variations(terrain)
    assert not bpy.ops.orogen.clear_seeds.poll()


def test_seeds_end_where_numbers_do():
    import bpy

    terrain = browsed(count=1)
    terrain.orogen.seed = 2**31 - 1
    bpy.ops.orogen.clear_seeds()
    bpy.ops.orogen.browse_seeds(count=2)
    assert [ob["orogen_seed"] for ob in variations(terrain)] == [2**31 - 2, 2**31 - 1]
