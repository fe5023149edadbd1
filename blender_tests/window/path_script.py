"""Runs in a real Blender window: the shortest way from Blender as it starts to a rendered range, by
keys and clicks alone, each of them counted. Its pictures are those of the tutorial's beginning.

The places of buttons are looked for: what is not there is clicked in vain and not counted.
"""

import bpy
import numpy as np
import window_tools as tools
from window_tools import found, picture, until

WIDTH, SAMPLES = 720, 24  # of the rendered picture: what a processor that draws bears
found["presses"] = []


def press(kind, why, x=400, y=400):
    """One key or click, counted."""
    found["presses"].append(why)
    yield from tap(kind, x, y)


def tap(kind, x, y, **modifiers):
    window = bpy.context.window_manager.windows[0]
    window.event_simulate("MOUSEMOVE", "NOTHING", x=x, y=y)
    yield 0.3
    for value in ("PRESS", "RELEASE"):
        window.event_simulate(kind, value, x=x, y=y, **modifiers)
        yield 0.1


def click(why, x, places, happened):
    """A click at the first of some places (pixels from the window's top) where something happens;
    it counts once."""
    found["presses"].append(why)
    for place in places:
        yield from tap("LEFTMOUSE", x, from_top(place))
        for _ in range(20):
            yield 0.05
            if happened():
                found.setdefault("places", {})[why] = place
                return
    raise AssertionError(f"no click did this: {why}")


def from_top(pixels):
    return bpy.context.window_manager.windows[0].height - pixels


def session():
    return bpy.context.window_manager.orogen


def sidebar():
    return next(region for region in tools.view_area().regions if region.type == "UI")


def steps():
    yield from press("ESC", "the splash goes")
    yield 1.0
    yield from press("A", "everything is selected")
    yield from press("DEL", "and deleted")
    yield from until(lambda: not bpy.data.objects)
    yield from press("N", "the sidebar comes")
    yield 1.0
    bar = sidebar()
    left, right = bar.x + bar.width // 3, bar.x + bar.width - 10
    is_ours = lambda: sidebar().active_panel_category == "Orogen"  # noqa: E731
    yield from click("its tab Orogen", right, range(100, 400, 30), is_ours)
    yield 1.0
    picture("1_empty")
    yield from press("LEFTMOUSE", "Add Terrain", left, from_top(154))
    yield 1.0
    picture("starts")
    yield from press("M", "Moving Plates", left, from_top(154))
    yield from until(lambda: any(ob.orogen.is_terrain for ob in bpy.data.objects))
    yield 1.0
    found["seen"] = tools.view_area().spaces.active.region_3d.view_distance
    picture("2_plates")
    yield from click("Grow", left, (314,), lambda: session().running)
    yield from until(lambda: not session().running)
    assert session().message == "", session().message
    yield 3.0
    picture("3_grown")
    yield from click("Set Up Scene", left, (396,), lambda: bpy.context.scene.camera)
    yield 2.0
    picture("4_set_up")
    yield from undo_and_redo()
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.samples = "CYCLES", SAMPLES
    scene.cycles.use_denoising = False  # Debian's Blender cannot
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, WIDTH * 9 // 16
    rendered = []
    bpy.app.handlers.render_complete.append(lambda *_: rendered.append(True))
    yield from press("F12", "the picture is rendered")
    yield from until(lambda: rendered, limit=600.0, tick=0.5)
    yield 2.0
    picture("render_window")
    scene.render.image_settings.file_format = "PNG"
    bpy.data.images["Render Result"].save_render(str(tools.OUT / "5_rendered.png"))
    found["picture"] = look(tools.OUT / "5_rendered.png")


def undo_and_redo():
    """A look aside, not counted: all that was set up is one step."""
    names = {ob.name for ob in bpy.data.objects if "orogen_role" in ob}
    yield from tap("Z", 400, 400, ctrl=True)
    yield 2.0
    left = {ob.name for ob in bpy.data.objects if "orogen_role" in ob}
    found["taken_back"] = sorted(names - left)
    yield from tap("Z", 400, 400, ctrl=True, shift=True)
    yield from until(lambda: bpy.context.scene.camera)


def look(file):
    """Mean of the upper and of the lower quarter of a picture, and how much the middle varies."""
    image = bpy.data.images.load(str(file))
    width, height = image.size
    rows = np.array(image.pixels[:]).reshape(height, width, 4)[::-1, :, :3]
    quarter = height // 4
    means = [float(rows[:quarter].mean()), float(rows[-quarter:].mean())]
    return [*means, float(rows[quarter:-quarter].std())]


tools.run(steps())
