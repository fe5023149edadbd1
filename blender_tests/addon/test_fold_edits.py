"""Folds as meshes: what is changed in them comes back in the regrown terrain, and stays."""

LAYER = 2  # from the bottom; its folds are the widest


def folded():
    """Two plates with one layer that folds, grown; and the mesh of its folds."""
    import bpy
    import steps

    bpy.ops.orogen.add_terrain(start="PLATES")
    terrain = bpy.context.object
    terrain.orogen.resolution = 128
    column = terrain.orogen.column
    column.use_layers = True
    for layer in column.layers:
        layer.fold_share = 0.5 if layer == column.layers[-LAYER] else 0.0
    steps.grow()
    assert bpy.ops.orogen.edit_folds() == {"FINISHED"}
    (ob,) = terrain.orogen.folds.objects
    return terrain, ob


def crests(terrain):
    """Middles (n, 2) and directions of the crests that the recipe of a terrain grows, from the
    core itself; and the height (m) of the folds in a cell."""
    import json

    import numpy as np
    import orogen

    recipe = json.loads(terrain.data["orogen_recipe"])
    grown = orogen.generate(recipe)
    assert not [text for text in grown.warnings if "fold_edits" in text], grown.warnings
    (fold,) = [f for f in grown.folds if f["layer"] == LAYER]
    skeleton = fold["skeleton"]
    a, b = skeleton.points[skeleton.edges[skeleton.choice > 0, :2].T]
    return (a + b) / 2, (b - a) / np.linalg.norm(b - a, axis=1)[:, None], fold, grown.grid


def along(terrain, line):
    """How many crests lie along a line of the plane (m): near its middle, within 45°."""
    import numpy as np

    a, b = np.array(line, float)
    middles, ways, *_ = crests(terrain)
    near = np.linalg.norm(middles - (a + b) / 2, axis=1) < np.linalg.norm(b - a) / 2
    way = (b - a) / np.linalg.norm(b - a)
    return int((near & (np.abs(ways @ way) > np.cos(np.pi / 4))).sum())


def highest(terrain, line):
    """The highest fold (m) within a third of the line's middle."""
    import numpy as np

    a, b = np.array(line, float)
    *_, fold, grid = crests(terrain)
    x = grid.origin[0] + grid.cell_size * (np.arange(grid.nx) + 0.5)
    y = grid.origin[1] + grid.cell_size * (np.arange(grid.ny) + 0.5)
    places = np.stack(np.meshgrid(x, y), -1) - (a + b) / 2
    near = np.linalg.norm(places, axis=-1) < np.linalg.norm(b - a) / 3
    return float((fold["speed"] * fold["years"])[near].max())


def line_of(ob, edge):
    """Its ends on the terrain's plane (m)."""
    origin = ob["orogen_fold_origin"]
    ends = [ob.data.vertices[i].co for i in ob.data.edges[edge].vertices]
    return [[p.x + origin[0], p.y + origin[1]] for p in ends]


def inner_edges(ob, terrain):
    """Edges well inside of the terrain that fold strongly, the highest first."""
    mesh = ob.data
    nx, ny = terrain.data["orogen_grid"]
    size = [n * terrain.data["orogen_cell_size"] for n in (nx, ny)]

    def height(edge):
        return min(mesh.vertices[i].co.z for i in edge.vertices)

    def inside(edge):
        ends = [mesh.vertices[i].co for i in edge.vertices]
        return all(0.2 * s < p[k] < 0.8 * s for p in ends for k, s in enumerate(size))

    found = sorted(filter(inside, mesh.edges), key=height, reverse=True)
    assert len(found) > 4
    return [edge.index for edge in found]


def delete_edge(ob, edge):
    import bmesh

    mesh = bmesh.new()
    mesh.from_mesh(ob.data)
    mesh.edges.ensure_lookup_table()
    bmesh.ops.delete(mesh, geom=[mesh.edges[edge]], context="EDGES")
    mesh.to_mesh(ob.data)
    mesh.free()


def test_a_mesh_shows_the_folds():
    import bpy
    import numpy as np
    import steps

    terrain, ob = folded()
    assert ob.name.startswith(f"{terrain.name} Folds Layer {LAYER}") and ob.parent == terrain
    assert list(ob["orogen_fold_where"]) == [LAYER, 1]
    nx, ny = terrain.data["orogen_grid"]
    places = np.array([ob.matrix_world @ v.co for v in ob.data.vertices])
    low, high = steps.positions(terrain).min(axis=0), steps.positions(terrain).max(axis=0)
    middles = np.array([places[list(e.vertices)].mean(axis=0) for e in ob.data.edges])
    assert (middles[:, :2] > low[:2] - 1).all() and (middles[:, :2] < high[:2] + 1).all()
    assert len(ob.data.edges) == len(inside(terrain)) > 50
    assert 0.1 < places[:, 2].max() < 5
    to_recipe = steps.addon("settings_recipe").to_recipe
    assert "fold_edits" not in to_recipe(terrain, bpy.context.scene)


def inside(terrain):
    middles, _, _, grid = crests(terrain)
    local = (middles - grid.origin) / grid.cell_size
    return middles[((local >= 0) & (local <= [grid.nx, grid.ny])).all(axis=1)]


def test_edits_stay_through_regrow_save_and_reload(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain, ob = folded()
    edges = inner_edges(ob, terrain)
    raised = line_of(ob, edges[0])
    distant = next(
        e for e in edges if np.linalg.norm(np.subtract(line_of(ob, e)[0], raised[0])) > 15e3
    )
    removed = line_of(ob, distant)
    assert along(terrain, removed) > 0
    wanted = 1.6 * highest(terrain, raised)
    for i in ob.data.edges[edges[0]].vertices:
        ob.data.vertices[i].co.z = wanted
    delete_edge(ob, distant)
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    kinds = [edit["edit"] for edit in recipe["fold_edits"]]
    assert kinds.count("remove") == 1 and set(kinds) == {"remove", "set"}
    assert {(e["layer"], e["phase"]) for e in recipe["fold_edits"]} == {(LAYER, 1)}

    def check(what):
        steps.grow()
        assert along(terrain, removed) == 0, what
        reached = highest(terrain, raised)
        print(f"{what}: {reached:.0f} m of {wanted:.0f} m")
        assert abs(reached / wanted - 1) < 0.1, what

    check("grown anew")
    terrain.orogen.seed += 1
    check("with another seed")
    assert bpy.ops.orogen.edit_folds() == {"FINISHED"}
    check("meshes made anew")
    name, file = terrain.name, str(tmp_path / "folds.blend")
    before = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=file)
    terrain = bpy.data.objects[name]
    terrain.orogen.seed += 1
    after = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    assert after["fold_edits"] == before["fold_edits"] == recipe["fold_edits"]
    bpy.context.view_layer.objects.active = terrain
    check("saved and loaded")


def test_new_edges_are_new_folds():
    """Drawn in Edit Mode, as a hand would, and read there."""
    import bmesh
    import bpy
    import numpy as np
    import steps

    terrain, ob = folded()
    before = len(ob.data.edges)
    steps.addon("terrains").activate(bpy.context, ob)
    bpy.ops.object.mode_set(mode="EDIT")
    mesh = bmesh.from_edit_mesh(ob.data)
    mesh.verts.ensure_lookup_table()
    nx, ny = terrain.data["orogen_grid"]
    size = np.array([nx, ny]) * terrain.data["orogen_cell_size"]
    first = min(mesh.verts, key=lambda v: np.linalg.norm(np.array(v.co[:2]) - 0.45 * size))
    begin = first.co.copy()
    made = bmesh.ops.extrude_vert_indiv(mesh, verts=[first])
    tip = made["verts"][0]
    tip.co = (begin.x + 9e3, begin.y + 2e3, 1500.0)
    first.co.z = 1500.0
    bmesh.update_edit_mesh(ob.data)
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    (added,) = [e for e in recipe["fold_edits"] if e["edit"] == "add"]
    assert not [e for e in recipe["fold_edits"] if e["edit"] == "remove"]
    origin = np.array(ob["orogen_fold_origin"])
    assert np.allclose(added["from"], origin + begin[:2], atol=0.2)
    assert np.allclose(added["to"], origin + tip.co[:2], atol=0.2)
    (height,) = [
        e["value"] for e in recipe["fold_edits"] if e["edit"] == "set" and e["to"] == added["to"]
    ]
    assert height == 1500
    steps.grow()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(ob.data.edges) == before + 1
    assert along(terrain, [added["from"], added["to"]]) > 0
    assert abs(highest(terrain, [added["from"], added["to"]]) / 1500 - 1) < 0.1
    assert bpy.ops.orogen.clear_fold_edits() == {"FINISHED"}
    assert bpy.context.object == terrain and terrain.orogen.folds is None
    assert "fold_edits" not in steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)


def test_copies_and_bad_moments():
    import bpy
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    assert not bpy.ops.orogen.edit_folds.poll()  # no layers fold on a map
    assert not bpy.ops.orogen.clear_fold_edits.poll()
    terrain, ob = folded()
    delete_edge(ob, inner_edges(ob, terrain)[0])
    to_recipe = steps.addon("settings_recipe").to_recipe
    expected = to_recipe(terrain, bpy.context.scene)["fold_edits"]
    assert len(expected) == 1
    bpy.ops.object.select_all(action="DESELECT")
    steps.addon("terrains").activate(bpy.context, terrain)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert copy != terrain and to_recipe(copy, bpy.context.scene)["fold_edits"] == expected
    assert bpy.ops.orogen.clear_fold_edits() == {"FINISHED"}
    assert "fold_edits" not in to_recipe(copy, bpy.context.scene)
    assert to_recipe(terrain, bpy.context.scene)["fold_edits"] == expected
