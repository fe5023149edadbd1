"""Plants: meshes, impostors that look like them, the fade from the one to the other."""

SPECIES = (
    "european_beech",
    "norway_spruce",
    "black_oak",
    "scots_pine",
    "coconut_palm",
    "hazel_bush",
    "umbrella_acacia",
)


def test_impostors_have_the_outline_and_light_of_the_mesh(tmp_path):
    import numpy as np
    import plant_scenes

    plant_scenes.light()
    for name in SPECIES:
        described = plant_scenes.plant(name)
        ob = plant_scenes.eight_views(described, pixels=96)
        plant_scenes.fade(ob, 1e6, 2e6)
        mesh = plant_scenes.picture(tmp_path)
        plant_scenes.fade(ob, 0.1, 0.2)
        impostor = plant_scenes.picture(tmp_path)
        both = np.stack([mesh, impostor]).reshape(2, mesh.shape[0], 8, -1, 4)
        covered = both[..., 3] > 0.5
        either, shared = covered.any(axis=0), covered.all(axis=0)
        overlap = shared.sum(axis=(0, 2)) / either.sum(axis=(0, 2))
        brightness = [
            (both[i, ..., :3].mean(axis=-1) * shared).sum(axis=(0, 2)) / shared.sum(axis=(0, 2))
            for i in range(2)
        ]
        ratio = brightness[1] / brightness[0]
        print(name, "overlap", overlap.min().round(3), "light", ratio.round(2))
        assert overlap.min() >= 0.85, name
        assert 0.7 < ratio.min() and ratio.max() < 1.4, name
        import bpy

        bpy.data.objects.remove(ob)


def test_nothing_pops_at_the_fade(tmp_path):
    import bpy
    import numpy as np
    import plant_scenes

    plant_scenes.light()
    described = plant_scenes.plant("european_beech", quality=0.02)
    ob = plant_scenes.eight_views(described, pixels=24)
    plant_scenes.fade(ob, 200.0, 400.0)
    camera = bpy.context.scene.camera
    frames = []
    for distance in np.linspace(200.0, 400.0, 17):
        camera.location.y = -distance
        frames.append(plant_scenes.picture(tmp_path, samples=64))
    blocks = np.stack(frames)[:, :32].reshape(17, 4, 8, 24, 8, 4).mean(axis=(2, 4))
    step = np.abs(np.diff(blocks, axis=0)).max()
    cover = blocks[..., 3].mean(axis=(1, 2))
    mean = blocks[..., :3].mean(axis=(1, 2, 3)) / cover
    print("step", step, "mean", mean.round(4), "cover", cover.round(4))
    assert step < 0.03, "of 1, of what is a third of a tree's width across"
    assert np.abs(np.diff(mean)).max() < 0.06 * mean[0]
    assert mean.min() > 0.82 * mean.max(), "darker than mesh and picture are in light"
    assert np.abs(cover / cover[0] - 1.0).max() < 0.005


def test_a_million_trees_are_instances():
    import resource
    import time

    import bpy
    import numpy as np
    import plant_scenes

    count, rng = 1_000_000, np.random.default_rng(1)
    described = plant_scenes.plant("dead_snag")
    side = np.arange(1000) * 5.0
    places = np.stack([*np.meshgrid(side, side), np.zeros((1000, 1000))], axis=-1).reshape(-1, 3)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start = time.monotonic()
    ob = plant_scenes.stand(described, places, rng.random(count) * 6.28)
    bpy.context.scene.camera.location = (2500.0, 2500.0, 1.7)
    plant_scenes.fade(ob, 150.0, 250.0)
    bpy.context.view_layer.update()
    shown = bpy.context.evaluated_depsgraph_get()
    seconds = time.monotonic() - start
    pictures = meshes = 0
    for item in shown.object_instances:
        if item.is_instance:
            pictures += "picture" in item.object.name
            meshes += "picture" not in item.object.name
    memory = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
    distance = np.hypot(places[:, 0] - 2500.0, places[:, 1] - 2500.0)
    print(f"{seconds:.1f} s, {memory:.0f} MB, {meshes} meshes, {pictures} pictures")
    assert abs(meshes - (distance < 250.0).sum()) < 200
    assert abs(pictures - (distance > 150.0).sum()) < 200
    assert seconds < 30.0 and memory < 2000.0


def test_plants_stand_on_the_triangles_of_the_ground():
    import bpy
    import numpy as np
    import steps

    points, grid_mesh = steps.addon("plants.points"), steps.addon("mesh.grid_mesh")
    rng = np.random.default_rng(3)
    nx, ny = 17, 12
    elevation = rng.normal(scale=1.0, size=(ny, nx)).astype(np.float32)
    ground = bpy.data.objects.new("Ground", bpy.data.meshes.new("Ground"))
    bpy.context.scene.collection.objects.link(ground)
    grid_mesh.build_topology(ground.data, nx, ny)
    places = grid_mesh.positions({"cell_size": 1.0}, (0.0, 0.0), elevation, (1.0, 1.0))
    grid_mesh.set_positions(ground.data, places)
    bpy.context.view_layer.update()
    at = rng.uniform(0.0, 1.0, (400, 2)) * (nx - 1, ny - 1)
    found = points.heights(elevation, at, 1.0)
    for (x, y), z in zip(at + 0.5, found, strict=True):
        hit, place, *_ = ground.ray_cast((x, y, 100.0), (0.0, 0.0, -1.0))
        assert hit and abs(place.z - z) < 1e-4
    beyond = points.heights(elevation, np.array([[-5.0, -1.0], [nx + 3.0, ny + 1.0]]), 1.0)
    assert np.allclose(beyond, elevation[[0, -1], [0, -1]], atol=1e-5)


def test_plants_follow_the_ground_that_grows_anew():
    import numpy as np
    import steps

    points, grid = steps.addon("plants.points"), {"nx": 40, "ny": 30, "cell_size": 10.0}
    terrain = steps.new_terrain(source="EXAMPLE")
    (ob,) = steps.addon("mesh.children").renew(terrain, "trees", ["Trees"], bpy_mesh).values()
    rng = np.random.default_rng(8)
    places = rng.uniform(5.0, 290.0, (50, 3)).astype(np.float32)
    kinds = np.zeros(50, np.uint8)
    cloud = {"positions": places, "kinds": kinds, "scales": places[:, 0], "rotations": kinds}
    points.fill(ob.data, cloud, {0: [0]})
    ob["orogen_offset"] = steps.addon("mesh.terrain_mesh").offset_of(terrain, grid)
    x = (np.arange(40) + 0.5) * 10.0
    points.settle(terrain, grid, np.tile(0.5 * x, (30, 1)))
    after = steps.positions(ob)
    assert np.array_equal(after[:, :2], places[:, :2])
    assert np.abs(after[:, 2] - 0.5 * places[:, 0]).max() < 1e-3


def bpy_mesh(name):
    import bpy

    return bpy.data.meshes.new(name)


def test_grass_afar_is_two_crossed_quads():
    import bpy
    import numpy as np
    import plant_scenes

    described = plant_scenes.plant("meadow_grass")
    picture = bpy.data.objects["Orogen meadow_grass 0 picture"]
    tuft = bpy.data.objects["Orogen meadow_grass 0"]
    assert len(picture.data.polygons) == 2 and described["layer"] == "ground_cover"
    first, second = (polygon.normal for polygon in picture.data.polygons)
    assert abs(first.dot(second)) < 1e-6 and abs(first.z) < 1e-6
    assert np.allclose(picture.dimensions.z, tuft.dimensions.z, rtol=0.15)
    assert 0.6 * max(tuft.dimensions[:2]) < picture.dimensions.x < 1.3 * max(tuft.dimensions[:2])
    (colour,) = (image for image in bpy.data.images if image.name.endswith("picture colour"))
    alpha = np.array(colour.pixels[:]).reshape(colour.size[1], colour.size[0], 4)[..., 3]
    low, high = alpha[: len(alpha) // 4], alpha[-len(alpha) // 4 :]
    assert 0.05 < alpha.mean() < 0.8 and low.mean() > 1.5 * high.mean()


def test_why_no_picture_could_be_rendered_is_told(tmp_path):
    import sys
    import time

    import bpy
    import pytest
    import steps

    pictures, terrain_mesh = steps.addon("plants.pictures"), steps.addon("mesh.terrain_mesh")
    bpy.context.preferences.filepaths.temporary_directory = str(tmp_path)
    failing = "raise RuntimeError('no memory'); print('Blender quit')"
    pictures._blender = lambda: [sys.executable, "-c", failing]
    files = set(tmp_path.rglob("*"))
    with pytest.raises(terrain_mesh.NotNow, match="rendered: RuntimeError: no memory"):
        with pictures.PictureProcess([]) as process:
            assert set(tmp_path.rglob("*")) > files
            while process.picture(0) is None:
                time.sleep(0.01)
    assert set(tmp_path.rglob("*")) == files


def test_the_scene_is_ready():
    import bpy
    import numpy as np
    import steps

    terrain = steps.corsica(resolution=96)
    steps.grow()
    wishes = {
        "reach": 1500.0,
        "variants": 1,
        "quality": 0.01,
        "cover_reach": 30.0,
        "picture_size": 16,
    }
    assert bpy.ops.orogen.make_ready_scene(**wishes) == {"FINISHED"}
    scene = bpy.context.scene
    assert scene.camera and scene.world.name == "Orogen Sky"
    kept = bpy.context.view_layer.layer_collection.children["Orogen Plants"]
    assert kept.exclude
    (trees,) = (ob for ob in terrain.children if ob["orogen_role"] == "trees")
    mesh = trees.data
    assert len(mesh.vertices) > 1000 and not mesh.polygons
    ground = steps.attribute(terrain, "biome")
    assert terrain["orogen_biomes"] == 1.0 and 0 <= ground.min() <= ground.max() < 16
    points = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.attributes["position"].data.foreach_get("vector", points)
    local = points.reshape(-1, 3) * trees.scale + trees.location
    assert (np.linalg.norm((local - scene.camera.location)[:, :2], axis=1) > 0.013).all()
    heights = steps.positions(terrain)[:, 2]
    assert local[:, 2].min() > 0.0 and local[:, 2].max() < heights.max()
    for ob in bpy.data.objects:
        if ob.get("orogen_plant", "").endswith("picture"):
            (picture, normals) = {
                node.image
                for node in ob.data.materials[0].node_tree.nodes
                if node.type == "TEX_IMAGE"
            }
            assert picture.packed_file and normals.packed_file

    count = len(bpy.data.objects), len(bpy.data.images), len(bpy.data.materials)
    made = {ob.name: ob.data.session_uid for ob in kept.collection.all_objects}
    assert bpy.ops.orogen.make_ready_scene(keep_camera=True, **wishes) == {"FINISHED"}
    assert (len(bpy.data.objects), len(bpy.data.images), len(bpy.data.materials)) == count
    assert made == {ob.name: ob.data.session_uid for ob in kept.collection.all_objects}


def test_quads_are_cut_to_what_they_show():
    import numpy as np
    import steps

    outline = steps.addon("plants.impostors").outline
    rng = np.random.default_rng(6)
    for _ in range(50):
        rows, columns = rng.integers(6, 40, 2)
        alpha = np.zeros((rows, columns), np.float32)
        y, x = rng.integers(0, rows, 9), rng.integers(0, columns, 9)
        alpha[y, x] = rng.uniform(0.1, 1.0, 9)
        hull = outline(alpha) * (columns, rows)
        after = np.roll(hull, -1, axis=0)
        side, inward = after - hull, np.stack([-(after - hull)[:, 1], (after - hull)[:, 0]], axis=1)
        assert (np.linalg.norm(side, axis=1) > 0.0).all()
        for corner in ((0, 0), (1, 0), (1, 1), (0, 1)):  # of each pixel that shows something
            away = (np.stack([x, y], axis=1) + corner)[:, None] - hull[None]
            assert ((away * inward[None]).sum(axis=-1) > -1e-4).all()
        assert (hull.min(axis=0) >= (x.min() - 0.51, y.min() - 0.51)).all()
        assert (hull.max(axis=0) <= (x.max() + 1.51, y.max() + 1.51)).all()
