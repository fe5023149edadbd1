"""Runs in a real Blender window: previews follow what is dragged; how many come a second, and how
soon after the empty was moved."""

import os
import time

import bpy
import numpy as np
from bpy_extras.view3d_utils import location_3d_to_region_2d
from window_tools import (
    Watch,
    addon,
    clear,
    found,
    heights,
    invoke,
    load,
    new_terrain,
    opened,
    percentiles,
    picture,
    run,
    terrain,
    until,
    view,
    view_all,
    view_area,
)

DRAG = float(os.environ.get("OROGEN_DRAG", 6.0))  # s
PATIENCE = 60.0  # s, for a first update where the machine has much else to do


def steps():
    yield from opened()
    yield from of_a_map()
    yield from of_corsica()
    yield from of_plates()


def drag(empty, name):
    """Moves an empty about, every 10 ms: as a user does, with G and the mouse; then by code, beside
    an open view and without the drawing of it."""
    area, start = view_area(), bpy.data.objects[empty].matrix_world.translation.copy()
    turn = Turn(start)
    yield from grab(empty, start)
    yield from moving(f"{name}_grabbed", lambda t: mouse("MOUSEMOVE", "NOTHING", turn.at(t)))
    mouse("LEFTMOUSE", "PRESS", turn.at(DRAG))
    mouse("LEFTMOUSE", "RELEASE", turn.at(DRAG))
    yield from until(lambda: not is_grabbed())
    yield 0.5

    def move(t):
        bpy.data.objects[empty].location = turn.at(t)

    found[f"{name}_grabbed"]["moved"] = (bpy.data.objects[empty].location - start).length
    yield from moving(f"{name}_drawn", move)
    # Software draws every editor that shows the object anew: a text alone shows nothing of it.
    area.type = "TEXT_EDITOR"
    with bpy.context.temp_override(window=window(), area=area):
        bpy.ops.screen.screen_full_area()
    yield 1.0
    yield from moving(f"{name}_not_drawn", move)
    with bpy.context.temp_override(window=window(), area=window().screen.areas[0]):
        bpy.ops.screen.screen_full_area()
    yield 0.5
    area = next(a for a in window().screen.areas if a.type == "TEXT_EDITOR")
    area.type = "VIEW_3D"
    yield 0.5


def window():
    return bpy.context.window_manager.windows[0]


class Turn:
    """A round way of 4 units from a place."""

    def __init__(self, start):
        self.start = start

    def at(self, t):
        way = type(self.start)((2.0 - 2.0 * np.cos(t), 2.0 * np.sin(t), 0.0))
        return self.start + way


def moving(name, move):
    with Watch() as watch:
        begin, seconds = time.perf_counter(), 0.0
        while seconds < DRAG or (not watch.latency and seconds < PATIENCE):
            move(seconds)
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
    yield from until(is_grabbed)


def is_grabbed():
    return addon("live.gestures").is_dragging(bpy.context)


def mouse(kind, value, world):
    with view():
        region = bpy.context.region
        at = location_3d_to_region_2d(region, bpy.context.area.spaces.active.region_3d, world)
        x, y = round(at.x + region.x), round(at.y + region.y)
    bpy.context.window_manager.windows[0].event_simulate(kind, value, x=x, y=y)


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
    """Plates are arrows; one where they meet is dragged."""
    yield from editable("folded_range")
    before = heights(terrain())
    arrows = bpy.data.collections["South"].objects
    yield from drag(max(arrows, key=lambda ob: ob.location.y).name, "plates")
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


run(steps())
