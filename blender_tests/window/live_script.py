"""Runs in a real Blender window: previews that follow a drag, growth that is watched, the browser
of seeds, a killed worker, undo; and how soon the window answers meanwhile."""

import os
import random
import signal
import time

import bpy
import numpy as np
from bpy_extras.view3d_utils import location_3d_to_region_2d
from window_tools import (
    addon,
    found,
    heights,
    invoke,
    picture,
    press,
    run,
    terrain,
    until,
    view,
    view_area,
)

DRAG = float(os.environ.get("OROGEN_DRAG", 6.0))  # s
EDITS = int(os.environ.get("OROGEN_EDITS", 150))


def steps():
    press("ESC")  # the splash
    yield 1.0
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    with view():
        bpy.context.area.spaces.active.show_region_ui = True
        bpy.context.area.spaces.active.clip_start = 1.0
        bpy.context.area.spaces.active.clip_end = 5000
    bpy.context.preferences.edit.undo_steps = 256
    yield 1.0
    with view():
        sidebar = next(r for r in bpy.context.area.regions if r.type == "UI")
        sidebar.active_panel_category = "Orogen"
    yield from of_a_map()
    yield from of_corsica()
    yield from of_plates()
    yield from watched()
    yield from seeds()
    yield from killed()
    yield from answers_while_it_grows()
    yield from undo_walk()


def session():
    return bpy.context.window_manager.orogen


def new_terrain(**settings):
    with view():
        bpy.ops.orogen.add_terrain()
    ob = bpy.context.object
    for name, value in settings.items():
        setattr(ob.orogen, name, value)
    return ob


def view_all():
    with view():
        bpy.ops.view3d.view_all()


def clear():
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    bpy.data.orphans_purge()


class Watch:
    """When previews are asked for and written, and what the main thread spends on them."""

    def __init__(self):
        self.loop, self.mesh = addon("live.loop"), addon("mesh.terrain_mesh")
        self.jobs = addon("worker.jobs").jobs
        self.changed, self.asked, self.latency, self.spent = 0.0, 0.0, [], {}
        self.write, self.start = self.mesh.write, self.jobs.start_preview
        self.look = self.loop._loop._look

    def __enter__(self):
        self.mesh.write = self._timed("write", self.write, self._written)
        self.loop._loop._look = self._timed("read", self.look)
        self.jobs.start_preview = self._asked
        return self

    def __exit__(self, *_):
        self.mesh.write, self.jobs.start_preview = self.write, self.start
        self.loop._loop._look = self.look

    def _asked(self, recipe):
        self.asked = self.changed
        return self.start(recipe)

    def _written(self):
        self.latency.append(time.perf_counter() - self.asked)

    def _timed(self, name, function, after=None):
        def timed(*arguments, **more):
            begin = time.perf_counter()
            result = function(*arguments, **more)
            self.spent.setdefault(name, []).append(time.perf_counter() - begin)
            if after:
                after()
            return result

        return timed


def drag(empty, name):
    """Moves an empty about, every 10 ms: as a user does, with G and the mouse; then by code, beside
    an open view and without the drawing of it."""
    area, start = view_area(), bpy.data.objects[empty].matrix_world.translation.copy()
    turn = Turn(start)
    yield from grab(empty, start)
    yield from moving(f"{name}_grabbed", lambda t: mouse("MOUSEMOVE", "NOTHING", turn.at(t)))
    mouse("LEFTMOUSE", "PRESS", turn.at(DRAG))
    mouse("LEFTMOUSE", "RELEASE", turn.at(DRAG))
    yield 0.5

    def move(t):
        bpy.data.objects[empty].location = turn.at(t)

    found[f"{name}_grabbed"]["moved"] = (bpy.data.objects[empty].location - start).length
    for kind, drawn in (("VIEW_3D", "drawn"), ("TEXT_EDITOR", "not_drawn")):
        area.type = kind
        yield 0.5
        yield from moving(f"{name}_{drawn}", move)
    area.type = "VIEW_3D"
    yield 0.5


class Turn:
    """A round way of 4 units from a place."""

    def __init__(self, start):
        self.start = start

    def at(self, t):
        way = type(self.start)((2.0 - 2.0 * np.cos(t), 2.0 * np.sin(t), 0.0))
        return self.start + way


def moving(name, move):
    with Watch() as watch:
        begin = time.perf_counter()
        while (now := time.perf_counter()) - begin < DRAG:
            move(now - begin)
            watch.changed = time.perf_counter()
            yield 0.01
        seconds = time.perf_counter() - begin
        yield from until(lambda: addon("live.loop")._loop.turns.idle)
    found[name] = {
        "updates_per_second": len(watch.latency) / seconds,
        "latency_ms": percentiles(watch.latency),
        "main_thread_ms": {key: percentiles(value) for key, value in watch.spent.items()},
        "load": os.getloadavg()[0],
    }


def grab(empty, start):
    ob = bpy.data.objects[empty]
    for other in bpy.context.selected_objects:
        other.select_set(False)
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    with view():
        bpy.ops.view3d.view_axis(type="TOP")
        bpy.context.area.spaces.active.region_3d.view_perspective = "ORTHO"
    yield 0.5
    mouse("MOUSEMOVE", "NOTHING", start)
    yield 0.3
    mouse("G", "PRESS", start)
    mouse("G", "RELEASE", start)
    yield 0.3


def mouse(kind, value, world):
    with view():
        region = bpy.context.region
        at = location_3d_to_region_2d(region, bpy.context.area.spaces.active.region_3d, world)
        x, y = round(at.x + region.x), round(at.y + region.y)
    bpy.context.window_manager.windows[0].event_simulate(kind, value, x=x, y=y)


def percentiles(seconds):
    values = np.percentile(1e3 * np.array(seconds), [50, 95, 100])
    return dict(zip(("median", "p95", "max"), values.round(2).tolist(), strict=True))


def of_a_map():
    """Peaks are empties; one is dragged about."""
    peaks = []
    for i, (x, y, z) in enumerate([(0, 0, 1.6), (18, 9, 2.1), (34, 2, 1.2), (25, 24, 1.8)]):
        empty = bpy.data.objects.new(f"Peak {i}", None)
        empty.location = (x, y, z)
        bpy.context.collection.objects.link(empty)
        peaks.append(empty.name)
    ob = new_terrain(source="DRAWING")
    view_all()
    yield 0.5
    ob.orogen.live.enabled = True
    yield from until(lambda: "orogen_grid" in terrain().data)
    view_all()
    before = heights(terrain())
    yield from drag(peaks[0], "map")
    found["map_moved"] = not np.array_equal(heights(terrain()), before)
    yield 1.0
    picture("1_live_map")

    # A click in the panel's field does what a script's edit does.
    before = heights(terrain())
    terrain().orogen.seed = 5
    terrain().update_tag()
    yield from until(lambda: not np.array_equal(heights(terrain()), before))
    clear()


def of_corsica():
    """A whole map: strokes, and peaks, of which the highest is dragged."""
    yield from editable("corsica")
    peaks = [ob for ob in drawn() if ob.type == "EMPTY"]
    yield from drag(max(peaks, key=lambda ob: ob.location.z).name, "corsica")
    yield 1.0
    picture("1_live_corsica")
    clear()


def of_plates():
    """Plates are arrows; one is dragged."""
    yield from editable("folded_range")
    before = heights(terrain())
    yield from drag(next(ob for ob in drawn() if ob.type == "EMPTY").name, "plates")
    found["plates_moved"] = not np.array_equal(heights(terrain()), before)
    yield 1.0
    picture("2_live_plates")
    terrain().orogen.live.enabled = False


def editable(example):
    load(example, 128)
    invoke(bpy.ops.orogen.edit_recipe)
    terrain().orogen.live.enabled = True
    yield from until(lambda: "orogen_grid" in terrain().data)
    view_all()
    yield from until(lambda: addon("live.loop")._loop.turns.idle)


def drawn():
    return terrain().orogen.drawing.all_objects


def load(example, resolution):
    clear()
    new_terrain(source="EXAMPLE", example=example, resolution=resolution)
    view_all()


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
