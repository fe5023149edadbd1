"""Starting from heights of the scene or of a file; paint; ground that stays."""


def cone(height=2.0, radius=8.0):
    """A cone in scene units: of kilometres."""
    import bpy

    bpy.ops.mesh.primitive_cone_add(vertices=64, radius1=radius, radius2=0, depth=height)
    ob = bpy.context.object
    ob.location.z = height / 2
    bpy.context.view_layer.update()
    return ob


def smooth_ground(terrain):
    """Without what is added to heights and worn off them."""
    terrain.orogen.stages.given_elevation.roughness = 0
    terrain.orogen.stages.river_erosion.years = 0
    terrain.orogen.stages.river_erosion.creep_length = 0


def heights(terrain):
    """(ny, nx) in metres."""
    import steps

    nx, ny = terrain.data["orogen_grid"]
    return steps.attribute(terrain, "elevation").reshape(ny, nx)


def test_a_mesh_is_the_start():
    import bpy
    import numpy as np
    import steps

    ob = cone()
    bpy.ops.orogen.add_terrain(start="HEIGHTS")
    terrain = bpy.context.object
    assert terrain.orogen.ground.object == ob
    terrain.orogen.resolution = 128
    smooth_ground(terrain)
    steps.grow()
    z = heights(terrain)
    assert z.shape == (128, 128)
    x, y, up = steps.positions(terrain).T
    wanted = 2.0 * np.maximum(0.0, 1.0 - np.hypot(x, y) / 8.0)
    assert np.abs(up - wanted).max() < 0.06 and abs(z.max() - 2000) < 60
    terrain.orogen.stages.property_unset("river_erosion")
    terrain.orogen.stages.river_erosion.property_unset("years")
    steps.grow()
    assert heights(terrain).mean() < z.mean()


def test_a_moved_and_turned_terrain_reads_the_mesh_below_it():
    import bpy
    import numpy as np
    import steps

    cone().location.x = 30
    bpy.ops.orogen.add_terrain(start="HEIGHTS")
    terrain = bpy.context.object
    terrain.location, terrain.rotation_euler.z = (25, 3, 0), 0.7
    terrain.orogen.resolution, terrain.orogen.units_per_km = 96, 2.0
    bpy.context.view_layer.update()
    smooth_ground(terrain)
    steps.grow()
    matrix = np.array(terrain.matrix_world)
    world = steps.positions(terrain) @ matrix[:3, :3].T + matrix[:3, 3]
    wanted = 2.0 * np.maximum(0.0, 1.0 - np.hypot(world[:, 0] - 30, world[:, 1]) / 8.0)
    assert np.abs(world[:, 2] - wanted).max() < 0.1


def test_an_image_is_the_start():
    import bpy
    import numpy as np
    import steps

    grey = np.linspace(0, 1, 32)[None, :] * np.ones((16, 1))
    image = bpy.data.images.new("heights", 32, 16, float_buffer=True, is_data=True)
    image.pixels.foreach_set(np.repeat(grey[..., None], 4, -1).astype(np.float32).ravel())
    terrain = steps.new_terrain(source="HEIGHTS", resolution=64)
    given = terrain.orogen.ground
    given.kind, given.image, given.black, given.white = "IMAGE", image, -100, 900
    terrain.orogen.input.frame_km = (20, 10)
    smooth_ground(terrain)
    steps.grow()
    z = heights(terrain)
    assert z.shape == (32, 64)
    assert abs(z[:, 0] + 100).max() < 1e-3 and abs(z[:, -1] - 900).max() < 1e-3
    assert (np.diff(z.mean(axis=0)) > -1e-3).all()


def test_what_is_missing_is_said():
    import bpy
    import steps

    terrain = steps.new_terrain(source="HEIGHTS")
    assert "Pick a mesh" in steps.refused(bpy.ops.orogen.grow)
    terrain.orogen.ground.kind = "IMAGE"
    assert "Pick an image" in steps.refused(bpy.ops.orogen.grow)


def test_an_elevation_model_is_loaded(tmp_path):
    import bpy
    import numpy as np
    import steps

    values = 500 + 300 * np.sin(np.arange(41) / 5)[:, None] * np.ones((1, 41))
    (tmp_path / "N42E009.hgt").write_bytes(values[::-1].astype(">i2").tobytes())
    assert bpy.ops.orogen.load_map(filepath=str(tmp_path / "N42E009.hgt")) == {"FINISHED"}
    terrain = bpy.context.object
    terrain.orogen.resolution = 64
    smooth_ground(terrain)
    steps.grow()
    assert terrain.name == "N42E009"
    z = heights(terrain)
    assert 480 < z.mean() < 600 and 180 < z.min() < 230 and 770 < z.max() < 810


def test_frozen_ground_stays_while_the_rest_grows_anew():
    import bpy
    import numpy as np
    import steps

    terrain = steps.corsica(96)
    steps.grow()
    before = heights(terrain).copy()
    bpy.ops.mesh.primitive_cylinder_add(radius=20, depth=50)
    area = bpy.context.object
    steps.addon("terrains").activate(bpy.context, terrain)
    paints = terrain.orogen.paints
    paints.keep_object, paints.freeze = area, True
    terrain.orogen.stages.keep_region.margin = 5000
    for seed in (5, 6):
        terrain.orogen.seed = seed
        steps.grow()
        z = heights(terrain)
        x, y, _ = steps.positions(terrain).T
        far = np.hypot(x, y).reshape(z.shape)
        assert (z[far < 19] == before[far < 19]).all()
        land = (far > 30) & (before > 0)
        assert (z[land] != before[land]).mean() > 0.5
    paints.freeze = False
    steps.grow()
    assert (heights(terrain) != before).mean() > 0.3


def test_paint_on_vertices_raises_the_ground_and_survives_another_size():
    import bpy
    import numpy as np
    import steps

    terrain = steps.corsica(96)
    steps.grow()
    plain = heights(terrain).copy()
    terrain.orogen.paints.uplift.method = "VERTEX"
    assert bpy.ops.orogen.paint(layer="uplift") == {"FINISHED"}
    assert terrain.mode == "VERTEX_PAINT"
    bpy.ops.object.mode_set(mode="OBJECT")
    steps.grow()
    assert (heights(terrain) == plain).all()  # grey changes nothing
    ny, nx = plain.shape
    colors = np.full((ny, nx, 4), 0.5, np.float32)
    colors[: ny // 2, :, :3] = 0.0
    name = "orogen_paint_uplift"
    terrain.data.attributes[name].data.foreach_set("color", colors.ravel())
    steps.grow()
    share = heights(terrain).clip(0) / plain.clip(0).mean()
    before = plain.clip(0) / plain.clip(0).mean()
    assert share[: ny // 2].mean() < 0.9 * before[: ny // 2].mean()
    assert share[ny // 2 :].mean() > 0.9 * before[ny // 2 :].mean()
    terrain.orogen.resolution = 64
    steps.grow()
    again = steps.colors(terrain.data, name)
    assert len(again) == len(terrain.data.vertices)
    assert abs(again[0, 0]) < 1e-6 and abs(again[-1, 0] - 0.5) < 1e-6


def test_paint_on_an_image_is_saved_with_the_file(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = steps.collision(tmp_path)
    steps.grow()
    plain = heights(terrain).copy()
    assert bpy.ops.orogen.paint(layer="hardness") == {"FINISHED"}
    assert terrain.mode == "TEXTURE_PAINT"
    image = terrain.orogen.paints.hardness.image
    pixels = np.full((image.size[1], image.size[0], 4), 0.5, np.float32)
    pixels[:, : image.size[0] // 2, :3] = 0.0
    image.pixels.foreach_set(pixels.ravel())
    image.update()
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "a.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "a.blend"))
    terrain = bpy.context.object
    steps.grow()
    z, half = heights(terrain), plain.shape[1] // 2
    assert z[:, :half].mean() < 0.9 * plain[:, :half].mean()
    assert z[:, half:].mean() > 0.9 * plain[:, half:].mean()
    assert bpy.ops.orogen.clear_paint(layer="hardness") == {"FINISHED"}
    steps.grow()
    assert (heights(terrain) == plain).all()


def test_heights_are_grown_towards(tmp_path):
    import bpy
    import numpy as np
    import steps

    y, x = np.mgrid[0:96, 0:96] / 95
    dome = (1800 * np.exp(-((x - 0.6) ** 2 + (y - 0.5) ** 2) / 0.06) - 80).astype(np.float32)
    np.save(tmp_path / "dome.npy", dome[::-1])
    terrain = steps.new_terrain(source="FILE", path=str(tmp_path / "dome.npy"), resolution=96)
    terrain.orogen.ground.use = "TOWARDS"
    assert terrain.orogen.stage_names()[-1] == "fitted_growth"
    terrain.orogen.stages.fitted_growth.fit_radius = 300.0
    steps.grow()
    grown = steps.attribute(terrain, "elevation").reshape(96, 96)
    assert np.corrcoef(grown.ravel(), dome.ravel())[0, 1] > 0.9
    assert (grown != dome).mean() > 0.5 and "uplift_rate" in terrain.data.attributes
    terrain.orogen.ground.use = "START"
    assert terrain.orogen.stage_names()[-1] == "river_erosion"
    # A mesh of the scene, too.
    bpy.ops.mesh.primitive_cone_add(radius1=15.0, depth=2.0, location=(0.0, 0.0, 1.0))
    bpy.ops.orogen.add_terrain(start="HEIGHTS")
    terrain = bpy.context.object
    terrain.orogen.resolution, terrain.orogen.ground.use = 96, "TOWARDS"
    assert terrain.orogen.stage_names()[-1] == "fitted_growth"
    steps.grow()
    assert 800 < steps.attribute(terrain, "elevation").max() < 2600


def test_biomes_are_painted_in_their_colours_and_stay(tmp_path):
    import bpy
    import numpy as np
    import steps

    biomes = steps.addon("declarations").BIOMES
    number = {biome.name: i for i, biome in enumerate(biomes)}
    bpy.ops.orogen.add_terrain(start="ISLAND")
    terrain = bpy.context.object
    terrain.orogen.resolution, terrain.orogen.living = 64, True
    assert terrain.orogen.stage_names()[-3:] == ("lakes", "biomes", "vegetation")
    steps.grow()
    assert bpy.ops.orogen.paint(layer="biome") == {"FINISHED"}
    image = terrain.orogen.paints.biome.image
    rgb = steps.addon("mesh.biome_paint").rgb
    pixels = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(pixels)
    pixels = pixels.reshape(image.size[1], image.size[0], 4)
    half = image.size[0] // 2
    pixels[:, :half, :3] = rgb(biomes[number["scorched"]].color)
    soft = np.linspace(0, 1, 24)[:, None]  # a soft edge to no paint, over colours of others
    edge = (1 - soft) * rgb(biomes[number["scorched"]].color) + soft * 128 / 255
    pixels[:, half - 12 : half + 12, :3] = edge
    image.pixels.foreach_set(pixels.ravel())
    assert bpy.ops.orogen.end_painting() == {"FINISHED"}
    steps.grow()
    shape = heights(terrain).shape
    found = steps.attribute(terrain, "biome").reshape(shape)
    dry = found < number["lake"]
    middle = shape[1] // 2
    assert (found[:, : middle - 1][dry[:, : middle - 1]] == number["scorched"]).all()
    assert (found[:, middle + 1 :][dry[:, middle + 1 :]] != number["scorched"]).all()
    assert dry[:, : middle - 1].any() and (found == number["ocean"]).any()
    file = str(tmp_path / "biomes.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    terrain = bpy.context.object
    steps.grow()
    again = steps.attribute(terrain, "biome").reshape(shape)
    assert (again == found).all()


def test_an_islands_climate_and_heights_are_painted():
    import bpy
    import numpy as np
    import steps

    assert bpy.ops.orogen.add_terrain(start="ISLAND") == {"FINISHED"}
    terrain = bpy.context.object
    terrain.orogen.resolution = 64
    steps.grow()
    before = heights(terrain)
    assert before[2, 2] < 0
    paints = terrain.orogen.paints
    for layer, left in (("moisture", 0.0), ("height", 1.0)):
        image = bpy.data.images.new(layer, 16, 16, float_buffer=True, is_data=True)
        grey = np.full((16, 16, 4), 0.5, np.float32)
        grey[:, :8] = left
        image.pixels.foreach_set(grey.ravel())
        paint = getattr(paints, layer)
        paint.method, paint.image = "IMAGE", image
    steps.grow()
    after = heights(terrain)
    wet = steps.attribute(terrain, "moisture").reshape(after.shape)
    assert wet[:, :24].max() == 0 and wet[:, 40:].max() > 0.5
    assert (after[10:-10, 5:20] > 0).all() and (after[:, -3:] < 0).all()
    assert bpy.ops.orogen.clear_paint(layer="height") == {"FINISHED"}
    assert paints.height.method == "NONE"
