"""From a map to a mesh."""


def test_mesh_is_the_terrain_of_the_core():
    import bpy
    import numpy as np
    import orogen
    import steps

    terrain = steps.corsica(units_per_km=2.0, vertical_exaggeration=3.0)
    steps.grow()
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    expected = orogen.generate(orogen.Recipe.from_dict(recipe))
    grid, elevation = expected.grid, expected["elevation"]
    ny, nx = elevation.shape
    points = steps.positions(terrain).reshape(ny, nx, 3)
    cell = grid.cell_size * 0.002
    assert np.allclose(points[..., 2], elevation * 0.006, rtol=1e-6, atol=1e-7)
    assert np.allclose(np.diff(points[..., 0], axis=1), cell, rtol=1e-3)
    assert np.allclose(np.diff(points[..., 1], axis=0), cell, rtol=1e-3)
    assert np.allclose(points[..., :2].mean(axis=(0, 1)), 0, atol=1e-3 * nx * cell)
    for name in expected.fields:
        values = np.asarray(expected[name])
        assert np.array_equal(steps.attribute(terrain, name), values.ravel()), name
    assert set(expected.fields) == set(terrain.data["orogen_fields"])
    mesh = terrain.data
    assert len(mesh.polygons) == (nx - 1) * (ny - 1)
    assert len(mesh.edges) == nx * (ny - 1) + ny * (nx - 1)
    assert not mesh.validate()
    assert all(p.use_smooth for p in mesh.polygons[:10])
    assert min(p.normal.z for p in mesh.polygons) > 0


def test_growing_again_rewrites_in_place():
    import numpy as np
    import steps

    terrain = steps.corsica(seed=1)
    steps.grow()
    mesh, edges = terrain.data, len(terrain.data.edges)
    material, before = mesh.materials[0], steps.positions(terrain).copy()
    grid_mesh = steps.addon("mesh.grid_mesh")
    grid_mesh.build_topology = None  # must not be called
    terrain.orogen.seed = 2
    steps.grow()
    assert terrain.data == mesh and len(mesh.edges) == edges and mesh.materials[0] == material
    after = steps.positions(terrain)
    assert np.array_equal(after[:, :2], before[:, :2])
    assert not np.array_equal(after[:, 2], before[:, 2])
    assert len([c for c in terrain.children]) == 1


def test_another_resolution_rebuilds():
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    coarse = len(terrain.data.vertices)
    terrain.orogen.resolution = 96
    steps.grow()
    assert len(terrain.data.vertices) > 2 * coarse
    assert len(steps.attribute(terrain, "elevation")) == len(terrain.data.vertices)
    assert not terrain.data.validate()


def test_edited_mesh_is_rebuilt():
    import bmesh
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    count = len(terrain.data.vertices)
    edited = bmesh.new()
    edited.from_mesh(terrain.data)
    edited.verts.ensure_lookup_table()
    bmesh.ops.delete(edited, geom=edited.verts[:10], context="VERTS")
    edited.to_mesh(terrain.data)
    steps.grow()
    assert len(terrain.data.vertices) == count and not terrain.data.validate()


def test_exaggeration_moves_the_mesh_at_once():
    import numpy as np
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    before = steps.positions(terrain).copy()
    terrain.orogen.vertical_exaggeration = 2.5
    assert np.allclose(steps.positions(terrain) / [1, 1, 2.5], before, atol=1e-6)
    terrain.orogen.units_per_km = 0.1
    assert np.allclose(steps.positions(terrain) / [0.1, 0.1, 0.25], before, atol=1e-5)


def test_sea_lies_over_the_sea_floor():
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    (sea,) = terrain.children
    assert steps.attribute(terrain, "elevation").min() < 0
    points = steps.positions(terrain)
    xs = sorted({round(v.co.x, 3) for v in sea.data.vertices})
    assert abs(xs[0] - points[:, 0].min()) < 1e-2 and abs(xs[-1] - points[:, 0].max()) < 1e-2
    assert all(v.co.z == 0 for v in sea.data.vertices)


def test_recipe_of_the_scene_gives_the_same_terrain_elsewhere(tmp_path):
    import numpy as np
    import orogen
    import steps

    terrain = steps.corsica(resolution=96, seed=5)
    steps.grow()
    import bpy

    file = str(tmp_path / "scene.orogen.json")
    assert bpy.ops.orogen.save_recipe(filepath=file) == {"FINISHED"}
    elsewhere = orogen.generate(orogen.Recipe.load(file))
    assert np.array_equal(steps.attribute(terrain, "elevation"), elsewhere["elevation"].ravel())


def test_material_renders(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = steps.corsica(resolution=96)
    steps.grow()
    scene = bpy.context.scene
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(camera)
    camera.data.type, camera.data.ortho_scale = "ORTHO", max(terrain.dimensions)
    camera.location, scene.camera = (0, 0, 100), camera
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.data.energy, sun.rotation_euler = 3.0, (0.8, 0.0, 0.6)
    scene.collection.objects.link(sun)
    scene.render.engine, scene.cycles.samples = "CYCLES", 4
    scene.render.resolution_x, scene.render.resolution_y = 48, 96
    scene.render.filepath = str(tmp_path / "picture.png")
    scene.render.image_settings.file_format = "PNG"
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(scene.render.filepath)
    pixels = np.array(picture.pixels[:]).reshape(96, 48, 4)[..., :3]
    sea, middle = pixels[2:8, 2:8].mean(axis=(0, 1)), pixels[40:56, 20:28].mean(axis=(0, 1))
    assert sea[2] > 1.2 * sea[0], f"the sea is not blue: {sea}"
    assert middle[0] > middle[2], f"the land is not of earth's colours: {middle}"
    assert pixels[30:66, 16:32].std() > 0.02, "the land has no relief"
