"""Plates as they are drawn: the worker's answers beside its jobs, arrows drawn and made rigid."""

from test_live import settle
from test_plates_in import arrows, plates_terrain, recipe_of


def plates_of(terrain):
    import bpy
    import steps

    bpy.context.view_layer.update()
    return steps.addon("scene.plates").read_plates(terrain, bpy.context.scene)


def rigid(plate):
    from orogen import tectonics

    return tectonics.rigid_plates([plate])[0]


def turned(terrain):
    """A terrain of plates, one of whose arrows has been turned and moved."""
    import bpy

    arrow = arrows(terrain, "South")[0]
    arrow.rotation_euler[2] += 0.5
    arrow.scale *= 1.4
    arrow.location.x += 3.0
    bpy.context.view_layer.update()
    return arrow


def test_the_answer_is_the_cores():
    import numpy as np
    import steps
    from orogen import Grid, tectonics
    from orogen.worker_gestures import CELLS

    terrain = plates_terrain()
    turned(terrain)
    plates, jobs = plates_of(terrain), steps.addon("worker.jobs").jobs
    ask = steps.addon("scene.rigid").ask
    answer = jobs.wait_for_answer(ask(plates, origin=[-45e3, -30e3], size=[90e3, 60e3]))
    known = tectonics.rigid_plates(plates)
    assert len(answer["plates"]) == len(known) == 2 and answer["problem"] == ""
    for got, plate in zip(answer["plates"], known, strict=True):
        assert got["angle"] == plate.angle and tuple(got["translation"]) == plate.translation
        assert np.array_equal(got["arrows"], plate.arrows)
        assert np.array_equal(got["hull"], plate.hull)
    assert known[0].angle != 0.0
    # A step to either side of a border, another plate is the nearest.
    cell = 90e3 / CELLS
    grid = Grid(CELLS, round(60e3 / cell), cell, (-45e3, -30e3))
    regions = tectonics.compression_field(known, grid).influence
    x, y = np.reshape(answer["borders"], (-1, 2)).T
    assert len(x) > 2 * (CELLS - 2)
    columns = np.round(2.0 * (x + 45e3) / cell) / 2.0 - 0.5  # between two cells' centres
    rows = np.round(2.0 * (y + 30e3) / cell) / 2.0 - 0.5
    lower = regions[np.floor(rows).astype(int), np.floor(columns).astype(int)]
    upper = regions[np.ceil(rows).astype(int), np.ceil(columns).astype(int)]
    assert (lower != upper).mean() > 0.99


def test_three_regions_meet_in_a_point():
    import numpy as np
    from orogen import Grid
    from orogen.worker_gestures import borders

    lines = borders(np.array([[0, 0], [1, 2]], np.int32), Grid(2, 2, 10.0, (100.0, 0.0)))
    assert sorted(lines.tolist()) == [
        [105.0, 10.0, 110.0, 10.0],
        [110.0, 15.0, 110.0, 10.0],
        [115.0, 10.0, 110.0, 10.0],
    ]
    assert borders(np.zeros((2, 2), np.int32), Grid(2, 2, 10.0)).shape == (0, 4)


def test_a_question_leaves_the_running_job_alone():
    import time

    import steps

    terrain = plates_terrain(resolution=1024)
    recipe, jobs = recipe_of(terrain), steps.addon("worker.jobs").jobs
    ask = steps.addon("scene.rigid").ask
    jobs.wait_for_answer(ask(plates_of(terrain)))  # the worker is up
    job = jobs.start(recipe)
    while job.fraction == 0.0:
        jobs.poll()
    begin = time.monotonic()
    answer = jobs.wait_for_answer(ask(plates_of(terrain)))
    assert "plates" in answer and time.monotonic() - begin < 0.5
    assert job.state == "RUNNING" and jobs.busy
    jobs.cancel(job)
    assert jobs.wait_for_answer(ask(7))["error"]
    assert "plates[0]" in jobs.wait_for_answer(ask([{"points": [], "arrows": []}]))["error"]


def test_plates_that_meet_keep_their_hulls():
    import steps

    plate = {"points": [(0, 0), (9e3, 0), (0, 9e3)], "arrows": [(0, 0)] * 3}
    jobs, ask = steps.addon("worker.jobs").jobs, steps.addon("scene.rigid").ask
    answer = jobs.wait_for_answer(ask([plate, plate], origin=[0, 0], size=[2e4, 2e4]))
    assert "meet" in answer["problem"] and answer["borders"] == []
    assert len(answer["plates"][1]["hull"]) == 3


def test_a_dead_worker_leaves_no_question_open():
    import os
    import signal
    import time
    from pathlib import Path

    import steps

    jobs, ask = steps.addon("worker.jobs").jobs, steps.addon("scene.rigid").ask
    plates = plates_of(plates_terrain())
    jobs.wait_for_answer(ask(plates))
    os.kill(jobs.worker_pid, signal.SIGSTOP)
    while Path(f"/proc/{jobs.worker_pid}/stat").read_text().rpartition(")")[2].split()[0] != "T":
        time.sleep(0.01)  # it could still answer
    question = ask(plates)
    os.kill(jobs.worker_pid, signal.SIGKILL)
    assert "SIGKILL" in jobs.wait_for_answer(question)["error"]
    assert "plates" in jobs.wait_for_answer(ask(plates))


def test_arrows_are_made_rigid():
    import bpy
    import numpy as np

    terrain = plates_terrain(units_per_km=0.5)
    terrain.location, terrain.rotation_euler = (100, -20, 3), (0, 0, 0.4)
    terrain.scale = (2, 2, 2)
    turned(terrain)
    drawn, still = plates_of(terrain)
    found = rigid(drawn)
    assert found.residual_m > 1000.0
    bpy.context.view_layer.objects.active = arrows(terrain, "South")[1]
    assert bpy.ops.orogen.make_rigid() == {"FINISHED"}
    south, north = plates_of(terrain)
    assert np.allclose(south["arrows"], found.arrows, rtol=1e-4, atol=0.02)
    assert np.allclose(south["points"], drawn["points"], atol=0.02) and north == still
    again = rigid(south)
    assert again.residual_m < 0.1 and abs(again.angle - found.angle) < 1e-5
    assert bpy.ops.orogen.make_rigid(plate="North") == {"FINISHED"}
    assert plates_of(terrain)[1] == still, "upright arrows stay as they are"
    assert bpy.ops.orogen.make_rigid(plate="Nowhere") == {"CANCELLED"}


def follow(terrain):
    """The others' turn, once the edit has ended."""
    import numpy as np

    settle()
    return plates_of(terrain)[0], np.array(plates_of(terrain)[0]["arrows"])


def test_arrows_follow_an_edit_once():
    import numpy as np
    import steps

    terrain = plates_terrain()
    settle()
    turned(terrain)
    found = rigid(plates_of(terrain)[0])
    after, vectors = follow(terrain)
    assert np.allclose(vectors, found.arrows, rtol=1e-4, atol=0.02)
    shown = steps.addon("live.loop").plates_shown()
    assert shown[0]["plates"][0] == after, "what is shown is the newest state"
    assert follow(terrain)[0] == after
    terrain.orogen.input.rigid_arrows = False
    turned(terrain)
    as_drawn = plates_of(terrain)[0]
    assert follow(terrain)[0] == as_drawn


def test_only_edits_are_followed():
    import bpy

    terrain = plates_terrain()
    arrow = turned(terrain)
    as_drawn = plates_of(terrain)[0]
    assert follow(terrain)[0] == as_drawn, "a state that is met is left alone"
    arrow.keyframe_insert("rotation_euler", frame=1)
    arrow.rotation_euler[2] += 0.4
    arrow.keyframe_insert("rotation_euler", frame=20)
    bpy.context.scene.frame_set(20)
    as_keyed = plates_of(terrain)[0]
    assert follow(terrain)[0] == as_keyed != as_drawn


def test_arrows_are_drawn():
    import bpy
    import numpy as np

    terrain = plates_terrain()
    terrain.orogen.input.rigid_arrows = False
    count = len(bpy.data.objects)
    assert bpy.ops.orogen.draw_arrow(start=(10, 25, 0), end=(12, 20, 7)) == {"FINISHED"}
    plates = plates_of(terrain)
    active = max(plates, key=lambda plate: len(plate["points"]))
    assert len(bpy.data.objects) == count + 1 and active["name"] == "North"
    assert np.allclose(active["points"][-1], (10e3, 25e3), atol=0.02)
    assert np.allclose(active["arrows"][-1], (2e3, -5e3), atol=0.02)
    assert bpy.context.object.name.startswith("North Arrow")
    terrain.orogen.input.rigid_arrows = True
    assert bpy.ops.orogen.draw_arrow(start=(-10, 25, 0), end=(-10, 20, 0)) == {"FINISHED"}
    north = plates_of(terrain)[1]
    assert len(north["points"]) == 6 and rigid(north).residual_m < 0.1


def test_the_first_arrow_brings_its_plate():
    import bpy
    import numpy as np

    terrain = plates_terrain()
    while bpy.ops.orogen.remove_plate.poll():
        bpy.ops.orogen.remove_plate()
    for x in (0, 8):
        assert bpy.ops.orogen.draw_arrow(start=(x, 1, 0), end=(x, 4, 0)) == {"FINISHED"}
    (plate,) = plates_of(terrain)
    assert np.allclose(plate["arrows"], [(0, 3e3)] * 2, atol=0.02)
    terrain.orogen.source = "DRAWING"
    assert not bpy.ops.orogen.draw_arrow.poll()


def test_the_tool_comes_and_goes():
    import bpy
    import steps
    from bl_ui.space_toolsystem_toolbar import VIEW3D_PT_tools_active as toolbar

    def tools():
        return str(toolbar._tools["OBJECT"])

    assert "orogen.arrow_tool" in tools()
    bpy.ops.preferences.addon_disable(module=steps.ADDON)
    without = tools()
    assert "orogen" not in without
    bpy.ops.preferences.addon_enable(module=steps.ADDON)
    bpy.ops.preferences.addon_disable(module=steps.ADDON)
    assert tools() == without
    bpy.ops.preferences.addon_enable(module=steps.ADDON)
