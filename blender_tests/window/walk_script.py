"""Runs in a real Blender window: what a newcomer does, from the empty file to a saved range, with
keys and clicks. Its pictures are those of the tutorial.

The places of buttons are looked for in the window's own picture: a click counts only if what it
should do happens.
"""

import hashlib
import time

import bpy
import numpy as np
import window_tools as tools
from window_tools import found, picture, press, until, view

COAST = [  # km
    (-22, -9), (-15, -14), (-8, -12), (1, -16), (9, -12), (18, -13), (23, -7), (21, -1),
    (26, 5), (19, 9), (14, 15), (6, 12), (-3, 16), (-9, 11), (-18, 12), (-20, 4), (-25, -2),
]  # fmt: skip
RIVERS = [[(-3, 2), (-8, -4), (-7, -12)], [(6, 3), (11, 8), (13, 14)]]
PEAKS = [(-8, 3, 1400), (2, 4, 1900), (11, 1, 1600)]  # km, km, m
FINE, COARSE = 1024, 256
GROW_BUTTONS = range(300, 420, 10)  # pixels from the window's top, where Grow may be


def session():
    return bpy.context.window_manager.orogen


def grown_from():
    return tools.terrain().data.get("orogen_grown_from")


def sha256(ob):
    return hashlib.sha256(tools.heights(ob).tobytes()).hexdigest()


def chord(kind, **modifiers):
    """A key with modifiers, over the 3D view."""
    window = bpy.context.window_manager.windows[0]
    window.event_simulate("MOUSEMOVE", "NOTHING", x=400, y=400)
    for value in ("PRESS", "RELEASE"):
        window.event_simulate(kind, value, x=400, y=400, **modifiers)


def click(x, from_top):
    window = bpy.context.window_manager.windows[0]
    y = window.height - from_top
    window.event_simulate("MOUSEMOVE", "NOTHING", x=x, y=y)
    yield 0.15
    for value in ("PRESS", "RELEASE"):
        window.event_simulate("LEFTMOUSE", value, x=x, y=y)
        yield 0.05


def click_grow():
    """Clicks down the sidebar until something grows, or has grown already."""
    before = grown_from()
    places = [found["grow_button"]] if "grow_button" in found else GROW_BUTTONS
    sidebar = next(r for r in tools.view_area().regions if r.type == "UI")
    for from_top in places:
        yield from click(sidebar.x + sidebar.width // 3, from_top)
        for _ in range(60):  # a slow machine draws before it answers
            yield 0.05
            if session().running or grown_from() != before:
                found["grow_button"] = from_top
                return
    raise AssertionError("no click made it grow")


def grow():
    yield from click_grow()
    yield from until(lambda: not session().running)
    assert session().message == "", session().message
    assert len(tools.terrain().data.vertices) > 10_000
    yield 1.0


def strokes(layer, lines):
    """Lines in km, drawn as strokes of a layer."""
    with view():
        bpy.ops.orogen.draw(layer=layer)
    pencil = next(ob for ob in bpy.data.objects if ob.type in ("GREASEPENCIL", "GPENCIL"))
    tools.addon("scene.pencil").add_strokes(pencil, layer, lines, 1)


def smooth(points, closed):
    """More points between, by Catmull and Rom, so that lines look drawn by hand."""
    points = np.array(points, float)
    pad = (points[-1:], points[:2]) if closed else (points[:1], points[-1:])
    knots = np.concatenate([pad[0], points, pad[1]])
    p, q, r, s = (knots[k : len(knots) - 3 + k, None] for k in range(4))
    t = np.arange(12)[:, None] / 12
    curve = q + 0.5 * t * (r - p + t * (2 * p - 5 * q + 4 * r - s + t * (3 * (q - r) + s - p)))
    curve = curve.reshape(-1, 2)
    return np.concatenate([curve, curve[:1]]) if closed else curve


def to_shore(line, coast):
    """The line, and on to the nearest point of the coast."""
    nearest = np.hypot(*(coast - line[-1]).T).argmin()
    return np.concatenate([line, coast[nearest : nearest + 1]])


def show_tab():
    with view():
        next(r for r in bpy.context.area.regions if r.type == "UI").active_panel_category = "Orogen"
        bpy.context.area.tag_redraw()
    yield 1.0


def start():
    press("ESC")  # the splash
    yield 1.0
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    with view():
        bpy.context.area.spaces.active.show_region_ui = True
        bpy.ops.ed.undo_push(message="Empty file")
    yield 2.0
    yield from show_tab()


def draw():
    with view():
        bpy.ops.orogen.add_terrain("EXEC_DEFAULT", True, start="DRAWING")
        bpy.ops.view3d.view_axis(type="TOP")
        shown = bpy.context.area.spaces.active.region_3d
        shown.view_distance, shown.view_location = 105.0, (11, 0, 0)
    terrain = tools.terrain()
    terrain.orogen.resolution, terrain.orogen.seed = COARSE, 2
    yield 0.5
    picture("2_added")
    coast = smooth(COAST, closed=True)
    strokes("Coast", [coast])
    strokes("Rivers", [to_shore(smooth(line, closed=False), coast) for line in RIVERS])
    with view():
        bpy.ops.object.mode_set(mode="OBJECT")
        for x, y, height in PEAKS:
            bpy.ops.object.empty_add(location=(x, y, height / 1000))
            bpy.context.object.parent = terrain
            empty = bpy.context.object
            for collection in list(empty.users_collection):
                collection.objects.unlink(empty)
            terrain.orogen.drawing.objects.link(empty)
        tools.addon("terrains").activate(bpy.context, terrain)
        bpy.ops.ed.undo_push(message="Drawn")
    yield 1.0
    picture("3_drawn")


def esc():
    """Esc stops and keeps the terrain."""
    before, terrain = sha256(tools.terrain()), tools.terrain()
    terrain.orogen.resolution, terrain.orogen.seed = FINE, 7
    yield from click_grow()
    yield from until(lambda: session().fraction > 0.02)
    picture("5_growing")
    begin = time.monotonic()
    chord("ESC")
    yield from until(lambda: not session().running, tick=0.005)
    found["seconds_to_esc"] = time.monotonic() - begin
    found["kept"] = sha256(tools.terrain()) == before
    terrain.orogen.resolution, terrain.orogen.seed = COARSE, 2
    yield 0.5


def undo():
    first = sha256(tools.terrain())
    tools.terrain().orogen.seed = 5
    with view():
        bpy.ops.ed.undo_push(message="Seed")
    yield from grow()
    second = sha256(tools.terrain())
    chord("Z", ctrl=True)
    yield 1.0
    found["undone"] = sha256(tools.terrain()) == first != second
    chord("Z", ctrl=True, shift=True)
    yield 1.0
    found["redone"] = sha256(tools.terrain()) == second


def save_and_load():
    before = sha256(tools.terrain())
    file = str(tools.OUT / "walk.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file, load_ui=True)
    yield 2.0
    yield from show_tab()
    found["loaded"] = sha256(tools.terrain()) == before
    flatten(tools.terrain().data)
    yield from grow()
    found["same_bytes"] = sha256(tools.terrain()) == before


def flatten(mesh):
    """So that what stands there afterwards has grown anew."""
    mesh.attributes["position"].data.foreach_set("vector", np.zeros(3 * len(mesh.vertices)))
    mesh.pop("orogen_grown_from")


def beauty():
    """The finished island, through the camera of its scene."""
    terrain = tools.terrain()
    terrain.orogen.resolution = FINE
    yield from grow()
    terrain.orogen.vertical_exaggeration = 1.5
    terrain.orogen.drawing.hide_viewport = True
    bpy.context.scene.render.engine = "CYCLES"
    bpy.context.scene.cycles.preview_samples = 16
    with view():
        bpy.ops.orogen.set_up_scene()
        space = bpy.context.area.spaces.active
        space.overlay.show_overlays = False
        space.shading.type = "RENDERED"
    yield 90.0  # Cycles begins with the sky
    picture("7_from_beside")
    with view():
        space = bpy.context.area.spaces.active
        space.shading.type, space.overlay.show_overlays = "SOLID", True
        shown = space.region_3d
        shown.view_perspective = "PERSP"
        shown.view_rotation = (0.82, 0.49, 0.15, 0.26)
        shown.view_distance, shown.view_location = 52.0, (6, 1, 0)
        bpy.ops.object.select_all(action="DESELECT")
        bpy.context.view_layer.objects.active = terrain
        terrain.orogen.view.field = "elevation"
    yield 2.0
    picture("8_heights")


def steps():
    yield from start()
    yield from draw()
    yield from grow()
    picture("4_grown")
    yield from esc()
    yield from undo()
    yield from save_and_load()
    yield from beauty()


tools.run(steps())
