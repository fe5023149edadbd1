"""The polygons of an island: what the worker says of them, changes of single ones; biomes."""


def island(resolution=96):
    import bpy

    assert bpy.ops.orogen.add_terrain(start="ISLAND") == {"FINISHED"}
    terrain = bpy.context.object
    terrain.orogen.resolution = resolution
    terrain.orogen.stages.hydraulic_erosion.duration = 0
    terrain.orogen.stages.island.cells = 1000
    return terrain


def polygons(terrain):
    import bpy
    import steps

    return steps.addon("live.polygons").now(terrain, bpy.context.scene)


def middle_land(found):
    """The center of dry land that is nearest to the middle."""
    import numpy as np
    import steps

    names = [biome.name for biome in steps.addon("declarations").BIOMES]
    dry = [k for k, b in enumerate(found["biomes"]) if names[b] not in ("ocean", "lake", "beach")]
    centers = np.array(found["centers"])
    return min(dry, key=lambda k: np.hypot(*centers[k]))


def test_the_worker_tells_an_islands_polygons():
    import numpy as np

    terrain = island()
    found = polygons(terrain)
    corners, edges = np.array(found["corners"]), np.array(found["edges"])
    assert len(found["centers"]) == len(found["rings"]) == len(found["biomes"]) == 1000
    assert len(corners) - len(edges) + 1000 == 1  # Euler
    assert np.abs(corners).max(axis=0).round(-3).tolist() == [45e3, 30e3]
    area = 0.0
    for ring in found["rings"]:
        x, y = corners[ring].T
        area += 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)
    assert abs(area / (90e3 * 60e3) - 1) < 0.01
    sides = {tuple(sorted(edge)) for edge in found["edges"]}
    assert {tuple(sorted(pair)) for pair in found["downslopes"]} <= sides
    assert {tuple(sorted(river[:2])) for river in found["rivers"]} <= sides and found["rivers"]
    terrain.orogen.source = "EXAMPLE"
    assert "no island" in polygons(terrain)["error"]


def test_a_polygon_is_raised_and_the_change_stays(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = island()
    steps.grow()
    before, found = steps.attribute(terrain, "elevation").copy(), polygons(terrain)
    place = found["centers"][middle_land(found)]
    for _ in range(2):
        change = {"layer": "height", "change": 0.15, "place": place}
        assert bpy.ops.orogen.change_polygon(**change) == {"FINISHED"}
    (edit,) = terrain.orogen.paints.polygons
    assert abs(edit.change - 0.3) < 1e-6
    steps.grow()
    after = steps.attribute(terrain, "elevation")
    x, y, _ = steps.positions(terrain).T
    far = np.hypot(1000 * x - place[0], 1000 * y - place[1])
    rise = after - before
    assert rise[far < 800].min() > 0.05 * before.max()
    assert abs(rise[far > 15e3]).mean() < 0.2 * rise[far < 800].mean()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "a.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "a.blend"))
    terrain = bpy.context.object
    terrain.orogen.stages.island.cells = 1500  # other polygons: the change stays where it was
    assert len(terrain.orogen.paints.polygons) == 1
    subtract = {"layer": "height", "change": 0.1, "subtract": True, "place": place}
    assert bpy.ops.orogen.change_polygon(**subtract) == {"FINISHED"}
    assert len(terrain.orogen.paints.polygons) == 2
    assert bpy.ops.orogen.clear_polygons() == {"FINISHED"}
    assert not terrain.orogen.paints.polygons


def test_changes_of_polygons_and_paint_add_up():
    import bpy
    import numpy as np
    import steps

    terrain = island()
    found = polygons(terrain)
    k = middle_land(found)
    place = found["centers"][k]
    change = {"layer": "moisture", "change": 0.25, "place": place}
    assert bpy.ops.orogen.change_polygon(**change) == {"FINISHED"}
    image = bpy.data.images.new("wet", 64, 64, float_buffer=True, is_data=True)
    image.pixels.foreach_set(np.full(64 * 64 * 4, 0.625, np.float32))
    terrain.orogen.paints.moisture.method = "IMAGE"
    terrain.orogen.paints.moisture.image = image
    recipe = steps.addon("settings_recipe").to_recipe(
        terrain, bpy.context.scene, pack=lambda values: values
    )
    values = recipe["rasters"]["moisture_change"]
    assert sorted({round(float(v), 4) for v in values.ravel()}) == [0.25, 0.5]
    row, column = (
        int((at + half) / (2 * half) * 64)
        for at, half in zip(place[::-1], (30e3, 45e3), strict=True)
    )
    assert values[row, column] == 0.5


def test_a_ring_is_filled_and_its_corners_with_it():
    import numpy as np
    import steps

    edits = steps.addon("polygon_edits")
    values = np.zeros((40, 60), np.float32)
    ring = [(10.0, 10.0), (20.0, 10.0), (20.0, 20.0), (10.0, 20.0)]
    edits.add(values, [(ring, 0.5), (ring, 0.25)], (0.0, 0.0), (60.0, 40.0))
    assert (values[9:21, 9:21] == 0.75).all() and values.sum() == 0.75 * 14**2
    edits.add(values, [(np.array(ring) - 500, 1.0)], (0.0, 0.0), (60.0, 40.0))
    assert values.max() == 0.75


def test_biomes_have_their_own_colours_and_names():
    import json

    import numpy as np
    import steps

    terrain = island(128)
    steps.grow()
    terrain.orogen.view.field = "biome"
    biomes = steps.addon("declarations").BIOMES
    assert len(biomes) == 16
    numbers = steps.attribute(terrain, "biome")
    linear = steps.colors(terrain.data, "orogen_view")[:, :3]
    colors = steps.addon("mesh.colors")
    wanted = colors.to_linear(colors.unpack(np.array([b.color for b in biomes])))[numbers, :3]
    assert np.abs(linear - wanted).max() < 1e-6
    rows = dict(json.loads(terrain.data["orogen_legend"])["rows"])
    assert len(rows) == len(np.unique(numbers)) > 5 and "Temperate Desert" in rows
    ocean = next(biome for biome in biomes if biome.name == "ocean")
    assert rows["Ocean"] == [ocean.color >> 16, ocean.color >> 8 & 255, ocean.color & 255]
