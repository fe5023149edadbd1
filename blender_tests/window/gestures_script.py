"""Runs in a real Blender window: arrows of plates are drawn with the tool, moved and turned; the
others follow, in the edit's own step of undo."""

import time

import bpy
import numpy as np
from bpy_extras.view3d_utils import location_3d_to_region_2d
from window_tools import addon, found, invoke, picture, press, run, terrain, until, view, view_area


def steps():
    press("ESC")  # the splash
    yield 1.0
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    with view():
        space = bpy.context.area.spaces.active
        space.show_region_ui = True
        space.clip_start, space.clip_end = 1.0, 5000.0
        bpy.ops.orogen.add_terrain("EXEC_DEFAULT", True, start="PLATES")
    yield 1.0
    with view():
        sidebar = next(r for r in bpy.context.area.regions if r.type == "UI")
        sidebar.active_panel_category = "Orogen"
        bpy.ops.view3d.view_axis(type="TOP")
        region = bpy.context.area.spaces.active.region_3d
        region.view_perspective = "ORTHO"
        region.view_distance, region.view_location = 150.0, (8, 0, 0)
    yield from until(lambda: addon("live.loop").plates_shown())
    yield 1.0
    picture("gestures_1_start")
    yield from turned()
    yield from moved()
    yield from twice()
    yield from drawn()
    yield from measured()


def plates():
    bpy.context.view_layer.update()
    return addon("scene.plates").read_plates(terrain(), bpy.context.scene)


def place(world):
    with view():
        at = location_3d_to_region_2d(
            bpy.context.region, bpy.context.area.spaces.active.region_3d, world
        )
        return round(at.x + bpy.context.region.x), round(at.y + bpy.context.region.y)


def mouse(kind, value, world):
    x, y = place(world)
    bpy.context.window_manager.windows[0].event_simulate(kind, value, x=x, y=y)


def same(one, other):
    return all(
        np.allclose(a[key], b[key], atol=0.02)
        for a, b in zip(one, other, strict=True)
        for key in ("points", "arrows")
    )


def edit(key, path, end="LEFTMOUSE"):
    """Transforms an arrow with a key and the mouse; returns the plates before, as they were let go,
    and after."""
    before = plates()
    ob = bpy.data.collections["South"].objects[0]
    for other in bpy.context.selected_objects:
        other.select_set(False)
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    with view():
        bpy.ops.ed.undo_push(message="Select")
    mouse("MOUSEMOVE", "NOTHING", path[0])
    yield 0.3
    mouse(key, "PRESS", path[0])
    mouse(key, "RELEASE", path[0])
    yield 0.3
    for world in path[1:]:
        mouse("MOUSEMOVE", "NOTHING", world)
        yield 0.3
    during = plates()
    mouse(end, "PRESS", path[-1])
    mouse(end, "RELEASE", path[-1])
    yield from rest()
    return before, during, plates()


def rest():
    """Until nothing is left to do, and it has been drawn."""
    yield 0.7
    yield from until(lambda: not bpy.app.timers.is_registered(addon("live.loop").tick))
    yield 0.3


def walked(name, before, during, after):
    """Undo and redo of what was edited, one step each."""
    others = [
        np.allclose(during[0]["arrows"][k], before[0]["arrows"][k], atol=0.02) for k in (1, 2, 3)
    ]
    invoke(bpy.ops.ed.undo)
    yield from rest()
    undone = same(plates(), before)
    invoke(bpy.ops.ed.redo)
    yield from rest()
    found[name] = {
        "edited": not same(during, before),
        "others_rest_meanwhile": all(others),
        "followed": not same(after, during),
        "undone_in_one_step": undone,
        "redone_in_one_step": same(plates(), after),
        "settled": not addon("live.loop")._gestures.edited,
    }


def moved():
    start = bpy.data.collections["South"].objects[0].matrix_world.translation.copy()
    path = [start, start + type(start)((6, 2, 0)), start + type(start)((14, 6, 0))]
    yield from walked("move", *(yield from edit("G", path)))


def turned():
    start = bpy.data.collections["South"].objects[0].matrix_world.translation.copy()
    kind = type(start)
    path = [start + kind((20, 0, 0)), start + kind((18, 8, 0)), start + kind((12, 12, 0))]
    result = yield from edit("R", path)
    picture("gestures_2_turned")
    yield from walked("turn", *result)


def twice():
    """Two edits are two steps; one that is given up is none, and nothing follows it."""
    start = bpy.data.collections["South"].objects[0].matrix_world.translation.copy()
    path = [start, start + type(start)((0, -9, 0))]
    before, during, after = yield from edit("G", path, "ESC")
    found["given_up"] = not same(during, before) and same(after, before)
    first, _, second = yield from edit("G", path)
    _, _, third = yield from edit("G", path[::-1])
    states = []
    for step in (bpy.ops.ed.undo, bpy.ops.ed.undo, bpy.ops.ed.undo, bpy.ops.ed.redo):
        invoke(step)
        yield from rest()
        states.append(plates())
    # Each edit is preceded by a step of its own for the selection.
    found["twice"] = [
        same(a, b) for a, b in zip(states, (second, second, first, second), strict=True)
    ]
    found["twice_differ"] = not same(third, second) and not same(second, first)


def drawn():
    terrain().orogen.input.rigid_arrows = False
    bpy.context.view_layer.objects.active = bpy.data.collections["North"].objects[0]
    with view():
        bpy.ops.ed.undo_push(message="Pick")
        bpy.ops.wm.tool_set_by_id(name="orogen.arrow_tool")
    yield 0.5
    for end in ("ESC", "RIGHTMOUSE", "LEFTMOUSE"):
        count = len(bpy.data.objects)
        mouse("MOUSEMOVE", "NOTHING", (-10, 24, 0))
        yield 0.2
        mouse("LEFTMOUSE", "PRESS", (-10, 24, 0))
        yield 0.2
        for x, y in ((-6, 18, 0)[:2], (0, 14)):
            mouse("MOUSEMOVE", "NOTHING", (x, y, 0))
            yield 0.3
        if end == "LEFTMOUSE":
            picture("gestures_3_drawing")
        mouse(end, "RELEASE" if end == "LEFTMOUSE" else "PRESS", (0, 14, 0))
        yield 0.3
        if end != "LEFTMOUSE":
            mouse(end, "RELEASE", (0, 14, 0))
            mouse("LEFTMOUSE", "RELEASE", (0, 14, 0))
        yield 0.5
        found[f"drawn_{end}"] = len(bpy.data.objects) - count
    found["drawn_arrow"] = [plates()[1][key][-1] for key in ("points", "arrows")]
    picture("gestures_4_drawn")
    invoke(bpy.ops.ed.undo)
    yield 0.5
    found["drawn_undone"] = len(bpy.data.objects) - count
    with view():
        bpy.ops.wm.tool_set_by_id(name="builtin.select_box")


def measured():
    """From a moved arrow to the answer that is shown."""
    loop, area = addon("live.loop"), view_area()
    for kind, drawn in (("VIEW_3D", "drawn"), ("TEXT_EDITOR", "not_drawn")):
        area.type = kind
        yield 0.5
        latency = []
        yield from asked_again(loop, latency)
        found[f"latency_{drawn}_ms"] = np.percentile(latency, [50, 95, 100]).round(1).tolist()


def asked_again(loop, latency):
    for i in range(40):
        ob = bpy.data.collections["South"].objects[0]
        ob.location.x += 0.1 * (-1) ** i
        asked = plates()
        begin = time.perf_counter()
        yield from until(lambda asked=asked: loop.plates_shown()[0]["plates"] == asked, tick=0.001)
        latency.append(1e3 * (time.perf_counter() - begin))


run(steps())
