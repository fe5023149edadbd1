"""What is painted, and ground that is frozen, keep their detail under coarse previews; and a look
at them costs the main thread little. Timers never fire here: the tests look where the timer would.
"""


def live(resolution):
    import steps

    terrain = steps.corsica(resolution)
    steps.grow()
    terrain.orogen.live.enabled = True
    return terrain


def stripes(terrain):
    """Fine stripes of paint on the terrain's vertices, as a grey (ny, nx)."""
    import numpy as np

    nx, ny = terrain.data["orogen_grid"]
    grey = np.tile(np.float32([0.3, 0.7]), (ny, nx // 2 + 1))[:, :nx]
    paint(terrain, grey)
    return grey


def paint(terrain, grey):
    import numpy as np
    import steps

    painted = steps.addon("mesh.painted")
    colors = np.ones((*grey.shape, 4), np.float32)
    colors[..., :3] = grey[..., None]
    attribute = painted.ensure(terrain.data, "uplift")
    attribute.data.foreach_set("color", colors.ravel())


def greys(terrain):
    import steps

    nx, ny = terrain.data["orogen_grid"]
    return steps.colors(terrain.data, "orogen_paint_uplift")[:, 0].reshape(ny, nx)


def test_paint_outlives_previews(tmp_path):
    import bpy
    import numpy as np
    import steps
    from test_live import edit, settle

    terrain = live(512)
    terrain.orogen.paints.uplift.method = "VERTEX"
    grey = stripes(terrain)
    for seed in (5, 6):
        edit(terrain, seed=seed)
        assert settle() == 1
        assert max(terrain.data["orogen_grid"]) == 256
    read = steps.addon("mesh.painted").read
    assert np.array_equal(read(terrain.data, "uplift"), grey)

    # What is painted on the preview goes into the detail, and nothing else of it changes.
    coarse = greys(terrain).copy()
    ny, nx = coarse.shape
    coarse[: ny // 2, : nx // 2] = 0.9
    paint(terrain, coarse)
    wanted = grey.copy()
    rows, columns = grey.shape
    half_row, half_column = (np.arange(rows) + 0.5) * ny / rows, (np.arange(columns) + 0.5) * nx
    inside = np.ix_(half_row < ny // 2, half_column / columns < nx // 2)
    wanted[inside] = 0.9
    assert np.array_equal(read(terrain.data, "uplift"), wanted)
    edit(terrain, seed=7)
    assert settle() == 1
    file = str(tmp_path / "preview.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    terrain = bpy.context.object
    assert np.array_equal(read(terrain.data, "uplift"), wanted)
    assert settle() == 0, "a file opens as it was"
    steps.grow()
    assert np.array_equal(greys(terrain), wanted)
    assert not [name for name in terrain.data.keys() if "detail" in name]
    edit(terrain, seed=8)
    assert settle() == 1
    assert bpy.ops.orogen.clear_paint(layer="uplift") == {"FINISHED"}
    assert not [name for name in terrain.data.keys() if "detail" in name]


def freeze(terrain):
    """Freezes the ground below a cylinder in the terrain's middle."""
    import bpy
    import steps

    bpy.ops.mesh.primitive_cylinder_add(radius=20, depth=50)
    area = bpy.context.object
    steps.addon("terrains").activate(bpy.context, terrain)
    terrain.orogen.paints.keep_object, terrain.orogen.paints.freeze = area, True
    return area


def test_frozen_ground_outlives_previews():
    import numpy as np
    import steps
    from test_live import edit, preview_of, settle

    terrain = live(512)
    before = steps.attribute(terrain, "elevation").copy()
    far = np.hypot(*steps.positions(terrain)[:, :2].T)
    freeze(terrain)
    for seed in (5, 6):
        edit(terrain, seed=seed)
        assert settle() == 1
        assert max(terrain.data["orogen_grid"]) == 256
        assert np.array_equal(steps.attribute(terrain, "elevation"), preview_of(terrain))
    steps.grow()
    assert terrain.orogen.resolution == 512
    now = steps.attribute(terrain, "elevation")
    assert (now[far < 19] == before[far < 19]).all(), "frozen to the bit, at its own resolution"
    assert (now != before).mean() > 0.3
    assert "orogen_frozen" not in terrain.data


def test_what_is_frozen_is_looked_at_anew_where_its_area_changes():
    from test_live import edit, settle

    terrain = live(300)
    area = freeze(terrain)
    edit(terrain, seed=5)
    assert settle() == 1
    area.location.x = 9.0
    assert settle() == 1
    for vertex in area.data.vertices:
        vertex.co.x *= 1.3
    area.data.update()
    assert settle() == 1
    assert settle() == 0


def test_a_look_at_frozen_ground_is_cheap():
    """4 ms of the main thread at 1024 x 1024; the first one casts rays on the area."""
    import time

    import numpy as np
    import steps
    from test_live import edit, settle

    terrain = live(1024)
    freeze(terrain)
    loop = steps.addon("live.loop")._loop
    look, spent = loop._look, []

    def timed(*arguments):
        begin = time.thread_time()
        look(*arguments)
        spent.append(1e3 * (time.thread_time() - begin))

    loop._look = timed
    for seed in range(20, 28):
        edit(terrain, seed=seed)
        assert settle() == 1
    assert np.median(spent) < 10.0, spent


def test_a_file_is_read_anew_where_it_changed(tmp_path):
    import json
    import os

    import steps
    from test_live import edit, settle

    terrain = steps.collision(tmp_path, resolution=64)
    terrain.orogen.live.enabled = True
    assert settle() == 1
    file = tmp_path / "plates.orogen.json"
    document = json.loads(file.read_text())
    document["phases"][0]["plates"][0]["points"][0][0] += 3000.0
    file.write_text(json.dumps(document))
    os.utime(file, ns=(1, 1))
    edit(terrain)
    assert settle() == 1
    edit(terrain)
    assert settle() == 0
