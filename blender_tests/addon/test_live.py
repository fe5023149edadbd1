"""Previews that follow the hand. Timers never fire here: the tests look where the timer would."""


def settle(limit=60.0):
    """Looks until nothing is left to do; returns how many previews were grown."""
    import time

    import bpy
    import steps

    loop, jobs = steps.addon("live.loop"), steps.addon("worker.jobs").jobs
    bpy.context.view_layer.update()
    jobs_seen, end = set(), time.monotonic() + limit
    while (wait := loop.tick()) is not None:
        assert time.monotonic() < end, "it goes on for ever"
        jobs_seen |= {job.number for job in [loop._loop.job] if job}
        time.sleep(wait)
        bpy.context.view_layer.update()
    assert not jobs.busy
    return len(jobs_seen)


def edit(terrain, group=None, **values):
    """Sets settings, and tags the terrain as Blender's panels do."""
    for name, value in values.items():
        setattr(group or terrain.orogen, name, value)
    terrain.update_tag()


def preview_of(terrain, **more):
    import bpy
    import steps
    from orogen.preview import generate_preview

    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    return generate_preview(recipe, **more)["elevation"].ravel()


def live_corsica():
    import steps

    terrain = steps.corsica(resolution=1024)
    terrain.orogen.live.enabled = True
    return terrain


def test_a_changed_setting_grows_a_preview_once():
    import numpy as np
    import steps

    terrain = live_corsica()
    assert settle() == 1
    assert max(terrain.data["orogen_grid"]) == 256 and terrain.data["orogen_preview"]
    assert np.array_equal(steps.attribute(terrain, "elevation"), preview_of(terrain))
    mesh = terrain.data
    edit(terrain, seed=7)
    assert settle() == 1
    assert terrain.data == mesh
    assert np.array_equal(steps.attribute(terrain, "elevation"), preview_of(terrain))
    edit(terrain, terrain.orogen.stages.relief_growth, talus_angle_deg=20.0)
    assert settle() == 1
    assert np.array_equal(steps.attribute(terrain, "elevation"), preview_of(terrain))
    terrain.update_tag()
    assert settle() == 0, "its own mesh made it grow again"
    edit(terrain, resolution=512)
    assert settle() == 0, "previews have a resolution of their own"


def test_a_moved_peak_grows_a_preview():
    import bpy
    import numpy as np
    import steps

    def peak(x, y, height):
        empty = bpy.data.objects.new("Peak", None)
        empty.location = (x, y, height)
        bpy.context.collection.objects.link(empty)
        return empty

    moved = peak(0, 0, 1.5)
    peak(30, 5, 2.0), peak(10, 20, 1.0)
    terrain = steps.new_terrain(source="DRAWING")
    terrain.orogen.live.enabled = True
    assert settle() == 1
    before = steps.attribute(terrain, "elevation")
    moved.location.x = 4.0
    assert settle() == 1
    after = steps.attribute(terrain, "elevation")
    assert not np.array_equal(after, before)
    assert np.array_equal(after, preview_of(terrain))
    bpy.data.objects.remove(moved)
    assert settle() == 1
    assert not np.array_equal(steps.attribute(terrain, "elevation"), after)


def test_the_newest_state_wins():
    import time

    import bpy
    import numpy as np
    import steps

    terrain = live_corsica()
    settle()
    loop, jobs = steps.addon("live.loop"), steps.addon("worker.jobs").jobs
    first = jobs._current.number
    for seed in range(20, 60):  # a drag
        edit(terrain, seed=seed)
        bpy.context.view_layer.update()
        loop.tick()
        time.sleep(0.01)
    settle()
    assert 1 < jobs._current.number - first < 40
    assert np.array_equal(steps.attribute(terrain, "elevation"), preview_of(terrain))


def test_a_grown_terrain_stays():
    import numpy as np
    import steps

    terrain = live_corsica()
    terrain.orogen.resolution = 96
    steps.grow()
    before = steps.positions(terrain)
    assert settle() == 0
    assert np.array_equal(steps.positions(terrain), before)
    assert not terrain.data["orogen_preview"]


def test_no_preview_while_a_terrain_grows():
    import bpy
    import steps

    terrain = live_corsica()
    settle()
    loop, jobs = steps.addon("live.loop"), steps.addon("worker.jobs").jobs
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    job = jobs.start(recipe, resolution=1024)
    edit(terrain, seed=99)
    bpy.context.view_layer.update()
    for _ in range(20):
        loop.tick()
        assert jobs._current is job
    jobs.cancel(job)
    assert settle() == 1


def test_what_cannot_grow_says_so_once(tmp_path):
    import bpy
    import steps

    terrain = steps.new_terrain(source="DRAWING")
    terrain.orogen.live.enabled = True
    assert settle() == 0
    session = bpy.context.window_manager.orogen
    assert session.is_error and "Nothing is drawn" in session.message
    edit(terrain, source="EXAMPLE")
    assert settle() == 1
    assert not session.message


def test_a_killed_worker_costs_one_message():
    import os
    import signal

    import bpy
    import steps

    terrain = live_corsica()
    settle()
    before = steps.positions(terrain)
    loop, jobs = steps.addon("live.loop"), steps.addon("worker.jobs").jobs
    edit(terrain, seed=12)
    bpy.context.view_layer.update()
    loop.tick()
    os.kill(jobs.worker_pid, signal.SIGKILL)
    settle()
    assert "SIGKILL" in bpy.context.window_manager.orogen.message
    assert (steps.positions(terrain) == before).all()
    edit(terrain, seed=13)
    assert settle() == 1
    assert not (steps.positions(terrain) == before).all()


def test_a_file_with_a_grown_terrain_opens_as_it_was(tmp_path):
    import bpy
    import steps

    terrain = live_corsica()
    terrain.orogen.resolution = 64
    steps.grow()
    file = str(tmp_path / "terrain.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    assert settle() == 0
    terrain = bpy.context.object
    assert max(terrain.data["orogen_grid"]) == 64
    edit(terrain, seed=44)
    assert settle() == 1


def test_turns():
    import steps

    turns = steps.addon("live.turns").Turns()
    patience = steps.addon("live.turns").PATIENCE
    assert turns.idle and turns.due(0.0) is None
    turns.notice("a"), turns.notice("b"), turns.notice("a")
    assert turns.due(0.0) == "a"
    turns.start("a", 0.0)
    turns.notice("a")
    assert turns.due(patience) is None, "one grows at a time"
    assert turns.due(2.1 * patience) == "a", "a slow one is given up for a newer one"
    turns.start("a", 2.1 * patience)
    turns.notice("a")
    assert turns.due(100.0) is None, "but not twice in a row"
    turns.end(2.1 * patience + 1.0)
    assert turns.due(100.0) == "b"
    turns.drop("b")
    assert turns.due(100.0) == "a"
    turns.start("a", 100.0)
    turns.notice("a")
    assert turns.due(102.4) is None, "they take a second here"
    assert turns.due(102.6) == "a"
    turns.drop("a"), turns.end(103.0)
    assert turns.idle


def test_remaining_time():
    import steps

    remaining = steps.addon("worker.remaining")
    history = []
    for i in range(100):
        history = remaining.note(history, 0.05 * i, 0.005 * i)
        assert (remaining.seconds_left(history) is None) == (history[-1][0] < 1.0)
    assert abs(remaining.seconds_left(history) - (10.0 - history[-1][0])) < 1e-6
    for i in range(200):  # it slows down to a fifth
        history = remaining.note(history, 5.0 + 0.1 * i, 0.5 + 0.002 * i)
    left = remaining.seconds_left(history)
    assert 4.0 < left < 5.2, left  # 0.102 at 0.02/s, and a little still of the faster past
    assert len(history) < 160
    assert remaining.in_words(None) == ""
    assert remaining.in_words(0.2) == "about 1 s left"
    assert remaining.in_words(42.0) == "about 40 s left"
    assert remaining.in_words(400.0) == "about 7 min left"
    assert remaining.seconds_left([(0.0, 0.1), (9.0, 0.1)]) is None


def test_growth_that_was_watched_is_kept_as_an_animation(tmp_path):
    """The frames come as they would while the window lives."""
    import bpy
    import numpy as np
    import steps

    terrain = steps.collision(tmp_path, resolution=300)
    jobs = steps.addon("worker.jobs").jobs
    watched = steps.addon("mesh.watched_growth").watched_growth
    growing_mesh = steps.addon("mesh.growing_mesh")
    assert not bpy.ops.orogen.keep_growth.poll()
    recipe = steps.addon("settings_recipe").to_recipe(terrain, bpy.context.scene)
    own = terrain.data
    watched.begin(terrain.session_uid)
    job, shown, seen = jobs.start(recipe, watch=True), 0, []
    while job.state == "RUNNING":
        jobs.poll()
        if frame := job.take_frame():
            growing_mesh.show(terrain, frame)
            seen.append(steps.positions(terrain)[:, 2].max())
            watched.add(frame)
            frame.close()
            shown += 1
    assert job.state == "DONE" and shown > 2 and seen[-1] > seen[0]
    assert growing_mesh.is_shown(terrain) and max(terrain.data["orogen_grid"]) == 256
    growing_mesh.end(terrain)
    assert terrain.data == own and not own.use_fake_user
    assert not [mesh for mesh in bpy.data.meshes if mesh.name == "Orogen Growth"]
    steps.addon("mesh.terrain_mesh").write(terrain, job.result, recipe)
    job.result.close()
    watched.mark = terrain.data["orogen_grown_from"]
    file = tmp_path / "kept.pc2"
    assert bpy.ops.orogen.keep_growth(filepath=str(file), frames=6, step=2) == {"FINISHED"}
    still, peaks = steps.positions(terrain), []
    for frame in range(1, 12, 2):
        bpy.context.scene.frame_set(frame)
        mesh = terrain.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        values = np.empty(len(mesh.vertices) * 3, np.float32)
        mesh.attributes["position"].data.foreach_get("vector", values)
        peaks.append(values[2::3].max())
    assert peaks[0] < 0.6 * peaks[-1] and np.array_equal(values.reshape(-1, 3), still), peaks
    assert abs(terrain["orogen_years"] - 5e6) < 1.0
    terrain.orogen.seed = 8
    steps.grow()
    assert not bpy.ops.orogen.keep_growth.poll(), "another terrain"


def test_a_file_holds_the_terrain_not_its_growth(tmp_path):
    import bpy
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    before, own = steps.positions(terrain), terrain.data.name
    growing_mesh = steps.addon("mesh.growing_mesh")
    jobs = steps.addon("worker.jobs").jobs
    recipe = steps.collision_recipe()
    job = jobs.start(recipe, resolution=512, watch=True)
    while not (frame := job.take_frame()):
        jobs.poll()
    growing_mesh.show(terrain, frame)
    frame.close()
    jobs.cancel(job)
    assert terrain.data.name != own
    file = str(tmp_path / "growing.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    terrain = bpy.context.object
    assert terrain.data.name == own and (steps.positions(terrain) == before).all()
    assert not terrain.data.use_fake_user


def test_running_water_is_watched_in_colours():
    import json
    from types import SimpleNamespace

    import bpy
    import numpy as np
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    own, growing = terrain.data.name, steps.addon("mesh.growing_mesh")
    change = np.linspace(-8.0, 4.0, 80, dtype=np.float32).reshape(8, 10)
    fields = {"elevation": 100.0 + change, "water_depth": abs(change), "change": change}
    grid = {"nx": 10, "ny": 8, "cell_size": 500.0, "origin": [0.0, 0.0]}
    seen = {}
    for what, factor in (("CHANGE", 1.0), ("WATER", 1.0), ("CHANGE", 0.5)):
        terrain.orogen.live.watch_shows = what
        frame = {name: np.float32(factor) * values for name, values in fields.items()}
        growing.show(terrain, SimpleNamespace(grid=grid, fields=frame))
        legend = json.loads(terrain.data["orogen_legend"])
        seen[what, factor] = (
            legend["low"],
            legend["high"],
            steps.colors(terrain.data, "orogen_view"),
        )
    low, high, rgba = seen["CHANGE", 1.0]
    assert 7.5 < high < 8 and low == -high
    assert (rgba[:20, 2] > rgba[:20, 0]).all() and (rgba[-10:, 0] > rgba[-10:, 2]).all()
    assert seen["WATER", 1.0][0] == 0 and 7.5 < seen["WATER", 1.0][1] < 8
    assert seen["CHANGE", 0.5][1] < 4, "another range after another field"
    side = steps.addon("scene.feature_curves").longer_side
    standing_in = side(terrain)
    growing.end(terrain)
    assert side(terrain) == standing_in, "the ground is the terrain's own meanwhile"
    assert terrain.data.name == own and not bpy.data.meshes.get("Orogen Growth")
