"""The rocks below a terrain: block diagram, sections, horizons, traces, folds, volume."""


def grown(folder, **settings):
    import steps

    terrain = steps.collision(folder)
    for name, value in settings.items():
        setattr(terrain.orogen, name, value)
    steps.grow()
    return terrain


def rocks_of(terrain):
    """What the core makes of the same recipe."""
    import json

    import orogen

    return orogen.generate(json.loads(terrain.data["orogen_recipe"])).rocks


def world_points(ob):
    import bpy
    import numpy as np

    bpy.context.view_layer.update()
    points = np.empty(len(ob.data.vertices) * 3, np.float32)
    ob.data.vertices.foreach_get("co", points)
    matrix = np.array(ob.matrix_world)
    return points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]


def test_block_stands_below_the_terrain(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = grown(tmp_path, units_per_km=2.0, vertical_exaggeration=1.5)
    terrain.location = (3, 4, 5)
    assert bpy.ops.orogen.add_block() == {"FINISHED"}
    (block,) = terrain.children
    ground = world_points(terrain)
    points = world_points(block)
    assert np.allclose(points[:, :2].min(axis=0), ground[:, :2].min(axis=0), atol=1e-3)
    assert np.allclose(points[:, :2].max(axis=0), ground[:, :2].max(axis=0), atol=1e-3)
    assert points[:, 2].min() < ground[:, 2].min() - 1.0
    rim = {tuple(p) for p in np.round(ground, 2)}
    near = [p for p in np.round(points, 2) if tuple(p) in rim]
    assert len(near) >= 2 * (96 + 86) - 4, "the walls do not meet the terrain's rim"
    expected = rocks_of(terrain).block_diagram()
    walls = len(expected["faces"]) - (terrain.data["orogen_grid"][0] - 1) * (
        terrain.data["orogen_grid"][1] - 1
    )
    assert len(block.data.polygons) == walls
    assert not block.data.validate()
    attribute = block.data.attributes["strata_color"]
    assert (attribute.data_type, attribute.domain) == ("FLOAT_COLOR", "CORNER")
    assert len(np.unique(steps.colors(block.data, "strata_color"), axis=0)) > 3
    assert bpy.context.object == terrain

    terrain.orogen.units_per_km = 1.0
    assert np.allclose(world_points(block)[:, 0] - 3, (points[:, 0] - 3) / 2, atol=1e-3)
    assert bpy.ops.orogen.add_block(top=True) == {"FINISHED"}
    (again,) = terrain.children
    assert again == block and len(block.data.polygons) == len(expected["faces"])


def test_section_through_the_middle(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = grown(tmp_path)
    bpy.context.scene.cursor.location = (500, 0, 0)  # elsewhere
    assert bpy.ops.orogen.add_section() == {"FINISHED"}
    assert bpy.ops.orogen.add_section(bearing=np.pi / 2) == {"FINISHED"}
    south_north, west_east = terrain.children
    points = world_points(south_north)
    assert np.allclose(points[:, 0], 0, atol=1e-3)
    assert abs(np.ptp(points[:, 1]) - np.ptp(steps.positions(terrain)[:, 1])) < 1e-3
    assert np.allclose(world_points(west_east)[:, 1], 0, atol=1e-3)
    x, y = steps.COLLISION_ORIGIN
    half = 0.5 * terrain.data["orogen_cell_size"]
    line = [(x + 20e3, y + half), (x + 20e3, y + 36e3 - half)]
    expected = rocks_of(terrain).section(line).mesh()
    assert abs(len(south_north.data.polygons) - len(expected["faces"])) < 0.05 * len(
        expected["faces"]
    )
    assert abs(points[:, 2].max() * 1000 - expected["vertices"][:, 2].max()) < 100


def test_section_along_what_is_drawn(tmp_path):
    import bpy
    import numpy as np
    import steps
    from test_drawing import add_stroke, new_drawing

    terrain = grown(tmp_path)
    data = bpy.data.curves.new("Line", "CURVE")
    spline = data.splines.new("BEZIER")
    spline.bezier_points.add(1)
    for knot, x in zip(spline.bezier_points, (-30, 8), strict=True):
        knot.co, knot.handle_left, knot.handle_right = (x, 2, 9), (x - 5, 2, 9), (x + 5, 2, 9)
    curve = bpy.data.objects.new("Line", data)
    bpy.context.scene.collection.objects.link(curve)
    curve.select_set(True)
    bpy.ops.orogen.add_section()
    (section,) = terrain.children
    points = world_points(section)
    assert np.allclose(points[:, 1], 2, atol=1e-3)
    left = steps.positions(terrain)[:, 0].min()
    assert abs(points[:, 0].min() - left) < 0.5 and abs(points[:, 0].max() - 8) < 0.01
    curve.location.y = 1000
    bpy.context.view_layer.update()
    assert "beside the terrain" in steps.refused(bpy.ops.orogen.add_section)
    curve.select_set(False)
    pencil = new_drawing("Stroke")
    add_stroke(pencil, "Line", [(-5, -5, 1), (5, 5, 1)])
    pencil.select_set(True)
    bpy.context.view_layer.update()
    bpy.ops.orogen.add_section()
    points = world_points(terrain.children[-1])
    assert np.allclose(points[:, 0], points[:, 1], atol=1e-3)
    assert abs(points[:, 0].max() - 5) < 0.01


def test_horizons(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = grown(tmp_path)
    assert bpy.ops.orogen.add_horizons() == {"FINISHED"}
    children = sorted(terrain.children, key=lambda ob: ob.name)
    rocks = rocks_of(terrain)
    assert "crystalline basement" in children[0].name
    height = world_points(children[0])[:, 2] * 1000
    assert np.allclose(np.sort(height), np.sort(rocks.horizons[0].ravel()), atol=0.01)
    assert all(not ob.data.validate() for ob in children)
    names = [ob.name for ob in children]
    bpy.ops.orogen.add_horizons()
    assert sorted(ob.name for ob in terrain.children) == names
    assert steps.attribute(terrain, "elevation").max() > 0


def test_rocks_are_those_of_the_mesh(tmp_path):
    """Whatever the settings say by now, and in a later session too."""
    import bpy
    import numpy as np
    import steps

    terrain = grown(tmp_path)
    bpy.ops.orogen.add_block()
    before = world_points(terrain.children[0])
    terrain.orogen.seed, terrain.orogen.path = 99, ""
    steps.addon("worker.jobs").jobs.shutdown()
    bpy.ops.orogen.add_block()
    assert np.array_equal(world_points(terrain.children[0]), before)


def test_maps_have_no_rocks():
    import bpy
    import steps

    steps.corsica(resolution=64)
    steps.grow()
    assert not bpy.ops.orogen.add_block.poll()
    assert not bpy.ops.orogen.add_section.poll()


def lines_of(ob):
    import numpy as np

    found = []
    for spline in ob.data.splines:
        values = np.empty(len(spline.points) * 4, np.float32)
        spline.points.foreach_get("co", values)
        found.append(values.reshape(-1, 4)[:, :3])
    return found


def test_traces_lie_on_the_ground(tmp_path):
    import bpy
    import numpy as np

    terrain = grown(tmp_path, vertical_exaggeration=2.0)
    assert bpy.ops.orogen.add_traces() == {"FINISHED"}
    rocks = rocks_of(terrain)
    drawn = {int(ob["orogen_part"].split()[2]): ob for ob in terrain.children}
    for k in range(len(rocks.horizons)):
        traces = rocks.horizon_traces(k)
        assert (k in drawn) == bool(traces)
        for line, trace in zip(lines_of(drawn[k]) if traces else [], traces, strict=True):
            assert len(trace) - len(line) in (0, 1)
            assert np.array_equal(line, trace[: len(line)])
    assert drawn
    ob = next(iter(drawn.values()))
    bpy.context.view_layer.update()
    world = np.array([ob.matrix_world @ bpy_vector(p) for p in lines_of(ob)[0]])
    ground = world_points(terrain)
    nearest = np.hypot(*(ground[:, None, :2] - world[None, :, :2]).T).argmin(axis=1)
    assert np.abs(ground[nearest, 2] - world[:, 2]).max() < 2.0


def bpy_vector(point):
    from mathutils import Vector

    return Vector(point.tolist())


def test_fold_lines_and_rivers(tmp_path):
    import json

    import bpy
    import numpy as np
    import orogen
    import steps

    terrain = grown(tmp_path)
    assert bpy.ops.orogen.add_folds() == {"FINISHED"}
    folds = orogen.generate(json.loads(terrain.data["orogen_recipe"])).folds
    objects = [ob for ob in terrain.children if ob["orogen_role"] == "folds"]
    lines = [line for f in folds for line in (*f["skeleton"].top, *f["skeleton"].bottom)]
    nx, ny = terrain.data["orogen_grid"]
    size = np.array([nx, ny]) * terrain.data["orogen_cell_size"]
    corners = np.concatenate([line.points for line in lines]) - steps.COLLISION_ORIGIN
    inside = corners[((corners > 0) & (corners < size)).all(axis=1)]
    drawn = np.concatenate([line for ob in objects for line in lines_of(ob)])
    assert ((drawn[:, :2] > -0.1) & (drawn[:, :2] < size + 0.1)).all()
    for corner in inside[:: max(1, len(inside) // 100)]:
        assert np.hypot(*(drawn[:, :2] - corner).T).min() < 0.1, "a fold on the map is not drawn"
    cells = np.clip(drawn[:, :2] // terrain.data["orogen_cell_size"], 0, [nx - 1, ny - 1])
    ground = steps.attribute(terrain, "elevation").reshape(ny, nx)
    below = ground[cells[:, 1].astype(int), cells[:, 0].astype(int)]
    assert np.median(np.abs(below - drawn[:, 2])) < 60
    assert bpy.ops.orogen.add_rivers(least_area=20.0) == {"FINISHED"}
    (rivers,) = (ob for ob in terrain.children if ob["orogen_role"] == "rivers")
    before = len(rivers.data.splines)
    assert bpy.ops.orogen.add_rivers(least_area=2.0) == {"FINISHED"}
    assert len(rivers.data.splines) > before > 0
    lengths = [np.hypot(*np.diff(line[:, :2], axis=0).T) for line in lines_of(rivers)]
    assert max(map(max, lengths)) < 1.5 * terrain.data["orogen_cell_size"]
    assert "none drains" in steps.refused(bpy.ops.orogen.add_rivers, least_area=1e6)
    island = steps.corsica(resolution=64)
    steps.grow()
    assert "no layers fold" in steps.refused(bpy.ops.orogen.add_folds)
    assert bpy.ops.orogen.add_rivers() == {"FINISHED"} and len(island.children) == 2


def test_volume_fills_the_block(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = grown(tmp_path, resolution=48)
    assert "Save the .blend" in steps.refused(bpy.ops.orogen.add_volume)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    assert bpy.ops.orogen.add_volume(voxel_height=250.0) == {"FINISHED"}
    (ob,) = terrain.children
    assert ob.type == "VOLUME" and ob.data.filepath == "//two_plates_rock.vdb"
    assert (tmp_path / "two_plates_rock.vdb").exists()
    assert ob.data.grids.load(), ob.data.grids.error_message
    assert [grid.name for grid in ob.data.grids] == ["rock"]
    bpy.context.view_layer.update()
    matrix = np.array(ob.matrix_world) @ np.array(ob.data.grids[0].matrix_object)
    ground = world_points(terrain)
    assert np.allclose(matrix[:2, 3], ground[:, :2].min(axis=0), atol=2e-3)
    cell = terrain.data["orogen_cell_size"] / 1000
    assert np.allclose([matrix[0, 0], matrix[1, 1], matrix[2, 2]], [cell, cell, 0.25], rtol=1e-5)
    assert ob.data.materials[0].name == "two plates Rocks"
    assert bpy.ops.orogen.add_volume() == {"FINISHED"} and len(terrain.children) == 1


def test_section_as_picture_and_drawing(tmp_path):
    import xml.etree.ElementTree

    import bpy
    import numpy as np
    import steps

    terrain = grown(tmp_path)
    assert bpy.ops.orogen.add_section_picture() == {"FINISHED"}
    (ob,) = terrain.children
    image = ob.data
    assert ob.type == "EMPTY" and image.packed_file
    pixels = np.array(image.pixels[:]).reshape(image.size[1], image.size[0], 4)
    assert image.size[0] == 2048 and 100 < image.size[1] < 1500
    assert pixels[0, :, 3].min() == 1 and pixels[-1, :, 3].mean() < 0.5
    assert len(np.unique(pixels[:, 1000, :3], axis=0)) > 3
    svg = tmp_path / "section.svg"
    assert bpy.ops.orogen.export_section(filepath=str(svg)) == {"FINISHED"}
    assert xml.etree.ElementTree.parse(svg).getroot().tag.endswith("svg")
    png = tmp_path / "section.png"
    assert bpy.ops.orogen.export_section(filepath=str(png)) == {"FINISHED"}
    again = bpy.data.images.load(str(png))
    assert tuple(again.size) == tuple(image.size)
    values = np.array(again.pixels[:]).reshape(pixels.shape)
    opaque = pixels[..., 3] == 1
    assert np.abs(values - pixels)[opaque].max() < 1e-3
    assert "no folder" in steps.refused(
        bpy.ops.orogen.export_section, filepath=str(tmp_path / "none/section.svg")
    )
    assert ".bmp" in steps.refused(
        bpy.ops.orogen.export_section, filepath=str(tmp_path / "section.bmp")
    )
