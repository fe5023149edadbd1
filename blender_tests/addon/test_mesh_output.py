"""The ground as other meshes: tiles, coarser copies, a body, triangles; UVs; glTF."""


def grown(resolution=96, **settings):
    import steps

    terrain = steps.corsica(resolution=resolution, **settings)
    steps.grow()
    return terrain


def with_role(terrain, role):
    return sorted(
        (ob for ob in terrain.children if ob.get("orogen_role") == role), key=lambda ob: ob.name
    )


def uv_of(mesh):
    """(corners, 2), and each corner's vertex."""
    import numpy as np

    uv = np.empty(len(mesh.loops) * 2, np.float32)
    mesh.uv_layers["UVMap"].uv.foreach_get("vector", uv)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    return uv.reshape(-1, 2), corners


def edge_counts(mesh):
    """How many faces each edge has, and whether the two of a pair run against each other."""
    from collections import Counter

    directed = Counter()
    for polygon in mesh.polygons:
        corners = list(polygon.vertices)
        directed.update(zip(corners, corners[1:] + corners[:1], strict=True))
    return directed


def test_tiles_share_their_borders_to_the_bit():
    import bpy
    import numpy as np
    import steps

    terrain = grown(units_per_km=2.0, vertical_exaggeration=1.5)
    before = steps.positions(terrain).copy()
    nx, ny = terrain.data["orogen_grid"]
    assert bpy.ops.orogen.split_tiles(count=3) == {"FINISHED"}
    tiles = with_role(terrain, "tiles")
    assert len(tiles) == 9 and len({tile["orogen_part"] for tile in tiles}) == 9
    assert sum(len(tile.data.polygons) for tile in tiles) == (nx - 1) * (ny - 1)
    seen = {}
    shared = 0
    for tile in tiles:
        assert not tile.data.validate()
        normals = np.empty((len(tile.data.loops), 3), np.float32)
        tile.data.corner_normals.foreach_get("vector", normals.ravel())
        _, corners = uv_of(tile.data)
        points = steps.positions(tile)
        area = steps.attribute(tile, "drainage_area")
        of_vertex = dict(zip(corners.tolist(), normals.tolist(), strict=True))
        for k, point in enumerate(points):
            what = (area[k], *of_vertex[k])
            if (key := point.tobytes()) in seen:
                shared += 1
                assert np.allclose(seen[key], what, atol=2e-3), "neighbours differ at their border"
            seen[key] = what
    assert len(seen) == nx * ny and {p.tobytes() for p in before} == set(seen)
    assert shared == 2 * nx + 2 * ny + 4
    assert np.array_equal(steps.positions(terrain), before), "the terrain itself was touched"
    assert bpy.ops.orogen.split_tiles(count=2, skirt=300.0) == {"FINISHED"}
    again = with_role(terrain, "tiles")
    assert len(again) == 4 and len([ob for ob in bpy.data.objects if "tile" in ob.name]) == 4
    lowest = min(steps.positions(tile)[:, 2].min() for tile in again)
    assert abs(lowest - (before[:, 2].min() - 0.3 * 2.0 * 1.5)) < 1e-4


def test_uv_lies_on_the_map():
    import bpy
    import numpy as np
    import steps

    terrain = grown(64)
    nx, ny = terrain.data["orogen_grid"]
    assert bpy.ops.orogen.add_uv() == {"FINISHED"}
    assert bpy.ops.orogen.split_tiles(count=2) == {"FINISHED"}
    cell = terrain.data["orogen_cell_size"] * 0.001
    corner = np.array(terrain.data["orogen_offset"]) * 0.001
    for ob in (terrain, *with_role(terrain, "tiles")):
        uv, corners = uv_of(ob.data)
        places = (steps.positions(ob)[corners, :2] - corner) / [nx * cell, ny * cell]
        assert np.allclose(uv, places, atol=1e-5)
        assert uv.min() > 0 and uv.max() < 1


def test_coarser_copies_keep_the_extent():
    import bpy
    import numpy as np
    import steps

    terrain = grown(96)
    points = steps.positions(terrain)
    known = {p.tobytes() for p in points}
    assert bpy.ops.orogen.add_lods(levels=3) == {"FINISHED"}
    lods = with_role(terrain, "lods")
    sizes = [len(lod.data.vertices) for lod in lods]
    assert len(lods) == 3
    for k, (lod, finer) in enumerate(zip(lods, [len(points), *sizes], strict=False), 1):
        own = steps.positions(lod)
        assert {p.tobytes() for p in own} <= known
        assert np.array_equal(own.min(axis=0)[:2], points.min(axis=0)[:2])
        assert np.array_equal(own.max(axis=0)[:2], points.max(axis=0)[:2])
        assert 3.3 < finer / len(own) < 4.1, k
        assert "drainage_area" in lod.data.attributes
    assert "more than" in steps.refused(bpy.ops.orogen.add_lods, levels=9)


def test_solid_is_closed():
    import bpy
    import steps

    terrain = grown(48)
    assert bpy.ops.orogen.add_solid(depth=700.0) == {"FINISHED"}
    (solid,) = with_role(terrain, "solid")
    assert not solid.data.validate()
    directed = edge_counts(solid.data)
    assert all(count == 1 and directed[b, a] == 1 for (a, b), count in directed.items())
    ground = steps.positions(terrain)[:, 2].min()
    assert abs(steps.positions(solid)[:, 2].min() - (ground - 0.7)) < 1e-5
    floor = max(solid.data.polygons, key=lambda polygon: polygon.area)
    assert floor.normal.z < -0.999
    import bmesh

    body = bmesh.new()
    body.from_mesh(solid.data)
    assert body.calc_volume(signed=True) > 0
    body.free()


def test_triangles_are_those_it_grew_on(tmp_path):
    import json

    import bpy
    import numpy as np
    import orogen
    import steps

    terrain = steps.collision(tmp_path, resolution=64)
    terrain.orogen.vertical_exaggeration = 2.0
    steps.grow()
    assert bpy.ops.orogen.add_tin() == {"FINISHED"}
    (ob,) = with_role(terrain, "tin")
    tin = orogen.generate(json.loads(terrain.data["orogen_recipe"])).tin
    assert len(ob.data.vertices) == len(tin) and len(ob.data.polygons) == len(tin.triangles)
    assert not ob.data.validate()
    points = steps.positions(ob)
    assert np.allclose(points[:, 2] * 500, tin.elevation, atol=0.01)
    places = tin.points - np.asarray(steps.COLLISION_ORIGIN) + terrain.data["orogen_offset"]
    assert np.allclose(points[:, :2] * 1000, places, atol=0.1)
    assert "strata_color" in ob.data.attributes
    island = steps.corsica(resolution=48)
    steps.grow()
    assert "mountain_growth" in steps.refused(bpy.ops.orogen.add_tin)
    assert not with_role(island, "tin")


def test_decimated_follows_the_terrain():
    import bpy
    import steps

    terrain = grown(64)
    assert bpy.ops.orogen.add_decimated(ratio=0.2) == {"FINISHED"}
    (ob,) = with_role(terrain, "decimated")
    assert ob.data == terrain.data
    bpy.context.view_layer.update()
    depsgraph = bpy.context.evaluated_depsgraph_get()
    triangles = 2 * len(terrain.data.polygons)
    left = len(ob.evaluated_get(depsgraph).data.polygons)
    assert left < 0.3 * triangles
    terrain.orogen.seed = 8
    steps.grow()
    assert ob.data == terrain.data and len(with_role(terrain, "decimated")) == 1


def test_gltf_takes_uv_normals_and_colours(tmp_path):
    import json

    import addon_utils
    import bpy

    addon_utils.enable("io_scene_gltf2")
    terrain = grown(64)
    terrain.orogen.view.field = "elevation"
    bpy.ops.orogen.split_tiles(count=2)
    tile = with_role(terrain, "tiles")[0]
    for ob in bpy.context.selected_objects:
        ob.select_set(False)
    tile.select_set(True)
    file = tmp_path / "tile.gltf"
    bpy.ops.export_scene.gltf(
        filepath=str(file),
        export_format="GLTF_SEPARATE",
        use_selection=True,
        **({"export_vertex_color": "ACTIVE"} if bpy.app.version >= (4, 2) else {}),
    )
    document = json.loads(file.read_text())
    (mesh,) = document["meshes"]
    attributes = mesh["primitives"][0]["attributes"]
    assert {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0"} <= set(attributes)
    assert document["accessors"][attributes["POSITION"]]["count"] == len(tile.data.vertices)


def test_edited_ground_is_refused():
    import bmesh
    import bpy
    import steps

    terrain = grown(48)
    edited = bmesh.new()
    edited.from_mesh(terrain.data)
    edited.verts.ensure_lookup_table()
    bmesh.ops.delete(edited, geom=edited.verts[:3], context="VERTS")
    edited.to_mesh(terrain.data)
    assert "edited" in steps.refused(bpy.ops.orogen.split_tiles)
    assert not with_role(terrain, "tiles")
