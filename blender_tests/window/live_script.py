"""Runs in a real Blender window: growth that is watched, the browser of seeds, a killed worker,
undo; and how soon the window answers meanwhile."""

import os
import random
import signal
import time

import bpy
import numpy as np
from window_tools import (
    Watch,
    addon,
    found,
    heights,
    invoke,
    load,
    opened,
    percentiles,
    picture,
    press,
    run,
    terrain,
    until,
    view,
    view_all,
    view_area,
)

EDITS = int(os.environ.get("OROGEN_EDITS", 150))


def steps():
    yield from opened()
    bpy.context.preferences.edit.undo_steps = 256
    yield from watched()
    yield from seeds()
    yield from killed()
    yield from answers_while_it_grows()
    yield from undo_walk()


def session():
    return bpy.context.window_manager.orogen


def watched():
    """Frames come, rest and go on; Esc brings the terrain back."""
    load("folded_range", 128)
    invoke(bpy.ops.orogen.grow, "INVOKE_DEFAULT")
    yield from until(lambda: not session().running)
    view_all()
    before, own = heights(terrain()), terrain().data.name
    terrain().orogen.resolution = 1024
    bpy.ops.ed.undo_push(message="Settings")
    invoke(bpy.ops.orogen.grow, "INVOKE_DEFAULT")
    yield from until(lambda: terrain().data.name != own)
    begin, seen = time.monotonic(), []
    while time.monotonic() - begin < 3.0:
        z = heights(terrain())
        if not seen or not np.array_equal(z, seen[-1]):
            seen.append(z)
        yield 0.02
    found["frames_per_second"] = len(seen) / 3.0
    found["grows"] = bool(seen[-1].max() > 1.2 * seen[0].max())
    picture("3_watched")
    invoke(bpy.ops.orogen.pause_growth)
    yield 3.0  # what is on its way is still shown
    rests = heights(terrain())
    yield 1.5
    found["rests"] = bool(np.array_equal(heights(terrain()), rests))
    picture("4_paused")
    invoke(bpy.ops.orogen.pause_growth)
    yield from until(lambda: not np.array_equal(heights(terrain()), rests))
    begin = time.monotonic()
    press("ESC")
    yield from until(lambda: not session().running, tick=0.005)
    found["seconds_to_cancel"] = time.monotonic() - begin
    found["kept"] = terrain().data.name == own and np.array_equal(heights(terrain()), before)
    found["left_over"] = [mesh.name for mesh in bpy.data.meshes if "Growth" in mesh.name]

    # To its end, with a look at a saved file on the way.
    terrain().orogen.resolution, terrain().orogen.seed = 512, 4
    invoke(bpy.ops.orogen.grow, "INVOKE_DEFAULT")
    yield from until(lambda: terrain().data.name != own)
    bpy.ops.wm.save_as_mainfile(filepath="/tmp/watched.blend", copy=True)
    with bpy.data.libraries.load("/tmp/watched.blend") as (inside, _):
        found["saved_growth"] = "Orogen Growth" in inside.meshes
    yield from until(lambda: not session().running)
    found["grown"] = terrain().data.name == own and len(terrain().data.vertices)
    found["fake_user"] = terrain().data.use_fake_user


def seeds():
    load("corsica", 256)
    invoke(bpy.ops.orogen.grow, "INVOKE_DEFAULT")
    yield from until(lambda: not session().running)
    invoke(bpy.ops.orogen.browse_seeds, "INVOKE_DEFAULT")
    yield from until(lambda: not session().running)
    variations = [ob for ob in terrain().children if "orogen_seed" in ob]
    found["variations"] = len(variations)
    view_all()
    yield 1.5
    picture("5_seeds")
    bpy.context.view_layer.objects.active = variations[2]
    invoke(bpy.ops.orogen.pick_seed)
    found["picked"] = terrain().orogen.seed
    invoke(bpy.ops.orogen.browse_seeds, "INVOKE_DEFAULT", count=2)
    yield from until(lambda: not session().running)
    yield 0.5
    press("ESC")
    yield 0.5
    found["esc_clears"] = not any("orogen_seed" in ob for ob in terrain().children)


def killed():
    terrain().orogen.resolution, terrain().orogen.seed = 2048, 9
    before, area = heights(terrain()), view_area()
    invoke(bpy.ops.orogen.grow, "INVOKE_DEFAULT")
    yield from until(lambda: session().fraction > 0.1)
    area.type = "TEXT_EDITOR"  # drawing by software apart
    yield 0.5
    os.kill(addon("worker.jobs").jobs.worker_pid, signal.SIGKILL)
    begin = time.monotonic()
    yield from until(lambda: session().message, tick=0.005)
    found["seconds_to_message"] = time.monotonic() - begin
    found["message_when_killed"] = session().message
    found["scene_unchanged"] = bool(np.array_equal(heights(terrain()), before))
    area.type = "VIEW_3D"
    yield 0.5
    picture("6_killed")


def answers_while_it_grows():
    """Gaps between ticks of a timer of 5 ms: while a job runs, and while its mesh is written."""
    ticks = []

    def tick():
        ticks.append(time.perf_counter())
        return 0.005

    area = view_area()
    area.type = "TEXT_EDITOR"  # the drawing of millions of faces by software apart
    yield 0.5
    terrain().orogen.resolution = 2048
    for _ in range(2):  # the first one makes the topology
        yield from answer(tick, ticks)
    terrain().orogen.resolution = 1024
    for _ in range(2):
        yield from answer(tick, ticks)
    area.type = "VIEW_3D"
    yield 0.5


def answer(tick, ticks):
    terrain().orogen.seed += 1
    ticks.clear()
    bpy.app.timers.register(tick)
    with Watch() as watch:
        with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
            bpy.ops.orogen.grow("INVOKE_DEFAULT")
        yield from until(lambda: not session().running)
        end = ticks[-1] - watch.spent["write"][-1]
        yield 1.0
    bpy.app.timers.unregister(tick)
    times = np.array(ticks)
    found.setdefault("answers", []).append(
        {
            "resolution": terrain().orogen.resolution,
            "gaps_while_it_grows_ms": percentiles(np.diff(times[times < end])),
            "longest_gap_at_its_end_ms": 1e3 * float(np.diff(times[times > end - 0.5]).max()),
            "write_ms": 1e3 * watch.spent["write"][-1],
        }
    )


def undo_walk():
    """Random edits, undos and redos, while previews grow: every state is as it was recorded."""
    load("folded_range", 96)
    terrain().orogen.live.enabled = True
    for i in range(3):
        empty = bpy.data.objects.new(f"Mark {i}", None)
        bpy.context.collection.objects.link(empty)
    yield from until(lambda: "orogen_grid" in terrain().data)
    rng = random.Random(3)

    def state():
        marks = [
            tuple(round(c, 4) for c in bpy.data.objects[f"Mark {i}"].location) for i in range(3)
        ]
        live = terrain().orogen
        rate = round(live.stages.collision.crust_smoothing, 2)
        return (live.seed, rate, live.vertical_exaggeration, marks, len(bpy.data.objects))

    def edit():
        choice = rng.randrange(4)
        if choice == 0:
            terrain().orogen.seed = rng.randrange(10**6)
        elif choice == 1:
            terrain().orogen.stages.collision.crust_smoothing = rng.uniform(500.0, 4000.0)
        elif choice == 2:
            bpy.data.objects[f"Mark {rng.randrange(3)}"].location.x = rng.uniform(-50.0, 50.0)
        else:
            terrain().orogen.vertical_exaggeration = rng.choice([1.0, 1.5, 2.0])
        terrain().update_tag()

    with view():
        bpy.ops.ed.undo_push(message="Start")
    states, at, wrong = [state()], 0, []
    jobs = addon("worker.jobs").jobs
    first = jobs._current.number
    for i in range(EDITS):
        choice = rng.random()
        if choice < 0.3 and at > 0 and len(states) - at < 150:
            at -= 1
            invoke(bpy.ops.ed.undo)
        elif choice < 0.5 and at + 1 < len(states):
            at += 1
            invoke(bpy.ops.ed.redo)
        else:
            edit()
            states = [*states[: at + 1], state()]
            at += 1
            with view():
                bpy.ops.ed.undo_push(message=f"Edit {i}")
        if state() != states[at]:
            wrong.append([i, str(state()), str(states[at])])
            break
        yield rng.choice([0.0, 0.0, 0.02, 0.1])
    yield from until(lambda: addon("live.loop")._loop.turns.idle)
    previews = jobs._current.number - first
    recipe = addon("settings_recipe").to_recipe(terrain(), bpy.context.scene)
    found["undo_walk"] = {
        "edits": EDITS,
        "wrong": wrong,
        "previews": previews,
        "ends_grown": terrain().data["orogen_grown_from"] == addon("recipe").fingerprint(recipe),
    }
    picture("8_undo_walk")


run(steps())
