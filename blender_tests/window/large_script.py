"""Runs in a real Blender window: a terrain in tiles grows, and a timer's gaps tell when the window
stood still, and for what. What it found goes to out/result.json.
"""

import base64
import json
import time

import bpy
import numpy as np
from window_tools import OUT, addon, found, heights, picture, press, run, terrain, until, view_area
from window_tools import view as in_view

SIDE = 4096  # cells
TICK = 0.005  # s


def now():
    """By the clock, and what the window's own thread worked (s)."""
    return time.perf_counter(), time.thread_time()


class Track:
    """When a timer ticked, when what was done, and when the view was drawn."""

    def __enter__(self):
        self.ticks, self.spans = [now()], []
        self.large, self.show = addon("mesh.large_ground"), addon("view.show")
        self.patched = []
        self.watch(addon("mesh.grid_mesh"), "build_topology")
        self.watch(addon("mesh.attributes"), "write")
        self.watch(addon("mesh.grid_mesh"), "set_positions")
        self.watch(addon("mesh.terrain_mesh"), "_write")
        self.watch(self.large.Tiles, "put")
        self.watch(self.show, "refresh")
        bpy.app.handlers.depsgraph_update_pre.append(self.before_update)
        bpy.app.handlers.depsgraph_update_post.append(self.after_update)
        self.timer = self.tick  # the very function that is to be unregistered
        bpy.app.timers.register(self.timer)
        return self

    def __exit__(self, *_):
        bpy.app.timers.unregister(self.timer)
        for owner, name, function in self.patched:
            setattr(owner, name, function)
        bpy.app.handlers.depsgraph_update_pre.remove(self.before_update)
        bpy.app.handlers.depsgraph_update_post.remove(self.after_update)

    def tick(self):
        self.ticks.append(now())
        return TICK

    def watch(self, owner, name):
        function = getattr(owner, name)

        def watched(*arguments, **more):
            begin = time.perf_counter()
            try:
                return function(*arguments, **more)
            finally:
                self.spans.append((name, begin, time.perf_counter()))

        self.patched.append((owner, name, function))
        setattr(owner, name, watched)

    def before_update(self, *_):
        self.begin = time.perf_counter()

    def after_update(self, *_):
        self.spans.append(("depsgraph", self.begin, time.perf_counter()))

    def longest(self, count=12):
        """The longest gaps, with what was done in them: names and seconds."""
        answer = []
        gaps = zip(self.ticks[:-1], self.ticks[1:], strict=True)
        for (begin, before), (end, after) in sorted(gaps, key=lambda g: g[0][0] - g[1][0])[:count]:
            within = [(n, round(e - b, 3)) for n, b, e in self.spans if b < end and e > begin]
            answer.append(
                {
                    "s": round(end - begin, 3),
                    "worked_s": round(after - before, 3),
                    "at": round(begin - self.ticks[0][0], 2),
                    "of": within,
                }
            )
        return answer


def document():
    n = 65
    y, x = np.mgrid[0:n, 0:n] / (n - 1)
    waves = 1 + 0.3 * np.sin(9 * x) * np.cos(7 * y)
    heights = 2500 * np.exp(-8 * ((x - 0.5) ** 2 + (y - 0.5) ** 2)) * waves - 300
    packed = base64.b64encode(heights.astype("<f4").tobytes()).decode("ascii")
    return {
        "orogen": 1,
        "seed": 1,
        "resolution": SIDE,
        "extent": {"origin": [0, 0], "size": [100e3, 100e3]},
        "rasters": {"elevation": {"rows": n, "columns": n, "float32": packed}},
        "stages": [
            {"stage": "given_elevation"},
            {"stage": "even_rates"},
            {"stage": "river_erosion", "parameters": {"steps": 2}},
        ],
    }


def tiles():
    return [ob for ob in terrain().children if ob.get("orogen_role") == "ground tile"]


def grow():
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        bpy.ops.orogen.grow("INVOKE_DEFAULT")


def state():
    """What must stay when growing is given up."""
    of_tiles = {ob.name: float(np.sum(heights(ob))) for ob in tiles()}
    return terrain().data["orogen_grown_from"], of_tiles, len(bpy.data.meshes)


def steps():
    session = bpy.context.window_manager.orogen
    press("ESC")  # the splash
    yield 1.0
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    file = OUT / "large.orogen.json"
    file.write_text(json.dumps(document()))
    with in_view():
        bpy.ops.orogen.add_terrain()
        bpy.ops.orogen.load_map(filepath=str(file))
        bpy.context.area.spaces.active.clip_end = 5000
    terrain().orogen.resolution = SIDE
    bpy.ops.ed.undo_push(message="Settings")
    yield 1.0
    area = view_area()
    area.type = "TEXT_EDITOR"  # the drawing of millions of faces by software apart
    yield 0.5
    yield from growing(session)
    yield from given_up(session)
    yield from shown()
    yield from undone()
    yield from drawn(area)


def growing(session):
    for _ in range(2):
        terrain().orogen.seed += 1
        with Track() as track:
            begin = time.perf_counter()
            grow()
            yield from until(lambda: not session.running, limit=400.0)
            seconds = time.perf_counter() - begin
            yield 2.0  # the step of undo
        found.setdefault("grown", []).append({"seconds": seconds, "gaps": track.longest()})
    found["tiles"] = len(tiles())
    found["message"] = session.message


def given_up(session):
    """Esc while tiles are made."""
    before, meshes = state(), len(bpy.data.meshes)
    terrain().orogen.seed += 1
    grow()
    yield from until(lambda: len(bpy.data.meshes) > meshes + 4, limit=400.0)
    found["running_at_esc"] = session.running
    begin = time.perf_counter()
    press("ESC")
    yield from until(lambda: not session.running)
    found["seconds_to_cancel"] = time.perf_counter() - begin
    found["message_after_esc"] = session.message
    yield 0.5
    found["kept"] = state() == before
    terrain().orogen.seed -= 1


def shown():
    """A field as colours on the tiles."""
    with Track() as track:
        terrain().orogen.view.field = "drainage_area"
        legend = terrain().data["orogen_legend"]
        yield from until(lambda: all(t.data.get("orogen_legend") == legend for t in tiles()))
    found["shown"] = {"gaps": track.longest(4)}
    bpy.ops.ed.undo_push(message="Show")


def undone():
    """Back over what is shown and over the latest growth."""
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        for _ in range(2):
            begin = time.perf_counter()
            bpy.ops.ed.undo()
            found.setdefault("seconds_to_undo", []).append(time.perf_counter() - begin)
            yield 1.0
            found.setdefault("undone", []).append([terrain().orogen.seed, len(tiles())])
        for _ in range(2):
            bpy.ops.ed.redo()
            yield 0.5
    found["redone"] = [terrain().orogen.seed, len(tiles())]


def drawn(area):
    """The drawing by software apart, in which the window stands still."""
    area.type = "VIEW_3D"
    addon("view.show").in_solid_view(bpy.context, True)
    begin = time.perf_counter()
    with in_view():
        bpy.ops.view3d.view_all()
    yield 1.0
    found["seconds_to_draw"] = time.perf_counter() - begin
    yield from until(tiles_show_the_field, limit=60.0)
    yield 1.0
    picture("1_tiles")


def tiles_show_the_field():
    return all(tile.data.get("orogen_legend") for tile in tiles())


run(steps())
