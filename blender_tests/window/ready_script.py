"""Runs in a real Blender window: a scene is made ready, given up at first, then undone. A timer's
gaps tell when the window stood still. What it found goes to out/result.json.
"""

import time
from pathlib import Path

import bpy
from window_tools import (
    found,
    load,
    opened,
    picture,
    press,
    run,
    terrain,
    until,
    view,
    view_area,
)

WISHES = {"reach": 2000.0, "quality": 0.05, "cover_reach": 60.0, "picture_size": 64}
TICK = 0.005  # s


class Gaps:
    """How long the window's thread worked, and how long it took, between ticks of a timer (s)."""

    def __enter__(self):
        self.ticks, self.timer = [], self.tick
        bpy.app.timers.register(self.timer)
        return self

    def __exit__(self, *_):
        bpy.app.timers.unregister(self.timer)

    def tick(self):
        self.ticks.append((time.thread_time(), time.perf_counter()))
        return TICK

    def longest(self):
        pairs = list(zip(self.ticks, self.ticks[1:], strict=False))
        return [max(after[i] - before[i] for before, after in pairs) for i in (0, 1)]


def window():
    return bpy.context.temp_override(window=bpy.context.window_manager.windows[0])


def session():
    return bpy.context.window_manager.orogen


def state():
    """What must stay when it is given up, and come back with an undo."""
    scene = bpy.context.scene
    names = sorted(ob.name for ob in scene.objects)
    return [names, scene.camera and scene.camera.name, scene.world and scene.world.name]


def folders():
    return {path.name for path in Path(bpy.app.tempdir).glob("orogen-*")}


def make():
    with window():
        bpy.ops.orogen.make_ready_scene("INVOKE_DEFAULT", **WISHES)


def begin():
    yield from opened()
    load("corsica", 256)
    with window():
        bpy.ops.orogen.grow("EXEC_DEFAULT", True)
    yield 1.0
    area = view_area()
    area.type = "TEXT_EDITOR"  # the drawing of a forest by software apart
    return area


def given_up():
    """Esc while pictures of plants are rendered."""
    before, files = state(), folders()
    make()
    yield from until(lambda: session().stage == "pictures of plants" and session().fraction > 0)
    found["folders_while_rendering"] = len(folders() - files)
    start = time.perf_counter()
    press("ESC")
    yield from until(lambda: not session().running, tick=0.005)
    found["seconds_to_cancel"] = time.perf_counter() - start
    found["message_after_esc"] = session().message
    yield 0.5
    found["kept"] = state() == before
    found["folders_left"] = len(folders() - files)


def made():
    fractions, before = [], state()
    with Gaps() as gaps:
        make()
        start = time.perf_counter()
        while session().running:
            if session().stage == "pictures of plants":
                fractions.append(session().fraction)
            yield 0.02
        found["seconds"] = time.perf_counter() - start
        yield 1.0  # the step of undo
    found["worked_s"], found["stood_still_s"] = gaps.longest()
    found["fractions"] = sorted(set(fractions))
    found["in_order"] = fractions == sorted(fractions)
    found["message"] = session().message
    found["roles"] = sorted({ob["orogen_role"] for ob in terrain().children})
    found["impostors"] = sum(
        ob.get("orogen_plant", "").endswith("picture") for ob in bpy.data.objects
    )
    after = state()
    with window():
        bpy.ops.ed.undo()
    yield 1.0
    found["undone"] = state() == before
    with window():
        bpy.ops.ed.redo()
    yield 1.0
    found["redone"] = state() == after


def made_again(area):
    """Pictures and meshes that are there are used again; then the ground grows anew."""
    start = time.perf_counter()
    make()
    yield from until(lambda: not session().running)
    found["seconds_again"] = time.perf_counter() - start
    yield 0.5
    terrain().orogen.seed += 1
    with window():
        bpy.ops.orogen.grow("INVOKE_DEFAULT")
    yield from until(lambda: not session().running)
    yield 0.5
    found["above_ground_m"] = above_ground()
    area.type = "VIEW_3D"
    with view():
        bpy.context.area.spaces.active.region_3d.view_perspective = "CAMERA"
        bpy.context.area.spaces.active.shading.type = "SOLID"
    yield 3.0
    picture("1_ready")


def above_ground():
    """How far, at most, a tree's foot is from the ground below it (m), for some of them."""
    trees = next(ob for ob in terrain().children if ob["orogen_role"] == "trees")
    up = terrain().orogen.local_scale()[1]
    worst = 0.0
    points = trees.data.attributes["position"].data
    for index in range(0, len(points), max(1, len(points) // 200)):
        x, y, z = trees.matrix_local @ points[index].vector
        hit, place, *_ = terrain().ray_cast((x, y, 10.0), (0.0, 0.0, -1.0))
        assert hit
        worst = max(worst, abs(z - place.z) / up)
    return worst


def steps():
    area = yield from begin()
    yield from given_up()
    yield from made()
    yield from made_again(area)


run(steps())
