"""Runs in a real Blender window: draws with the mouse, grows, pushes plates; pictures to look at.

A Blender without brushes (Debian's has none) cannot draw: then the same lines are put there.
What it found goes to out/result.json.
"""

import math

import bpy
from bpy_extras.view3d_utils import region_2d_to_location_3d
from window_tools import addon, found, picture, run, terrain, until

session = None


def area_and_region():
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    return window, area, next(region for region in area.regions if region.type == "WINDOW")


def view():
    window, area, region = area_and_region()
    return bpy.context.temp_override(window=window, area=area, region=region)


def press(kind, value=None, x=400, y=400):
    window = bpy.context.window_manager.windows[0]
    for what in (value,) if value else ("PRESS", "RELEASE"):
        window.event_simulate(kind, what, x=x, y=y)


def draw(layer, *lines):
    """Draws lines through places of the window, with the left button if there is a brush."""
    with view():
        bpy.ops.orogen.draw(layer=layer)
    found["brush"] = bpy.context.scene.tool_settings.gpencil_paint.brush is not None
    for line in lines:
        if found["brush"]:
            yield from drag(line)
        else:
            addon("scene.pencil").add_strokes(pencil(), layer, [on_plane(line)], 1)


def on_plane(line):
    _, area, region = area_and_region()
    shown = area.spaces.active.region_3d
    places = [(x - region.x, y - region.y) for x, y in line]
    return [region_2d_to_location_3d(region, shown, place, (0, 0, 0))[:2] for place in places]


def drag(points):
    press("MOUSEMOVE", "NOTHING", *points[0])
    yield 0.1
    press("LEFTMOUSE", "PRESS", *points[0])
    yield 0.05
    for x, y in points[1:]:
        press("MOUSEMOVE", "NOTHING", x, y)
        yield 0.02
    press("LEFTMOUSE", "RELEASE", *points[-1])
    yield 0.3


def arc(begin, end, radius, count=24):
    """Places in the window around the middle of the 3D view's free part."""
    _, area, region = area_and_region()
    x, y = region.x + 0.42 * region.width, region.y + 0.5 * region.height
    turns = [begin + (end - begin) * k / count for k in range(count + 1)]
    wobble = [1 + 0.12 * math.sin(5 * t) for t in turns]
    return [
        (int(x + w * radius * 1.3 * math.cos(t)), int(y + w * radius * math.sin(t)))
        for t, w in zip(turns, wobble, strict=True)
    ]


def pencil():
    return next(ob for ob in bpy.data.objects if ob.type in ("GREASEPENCIL", "GPENCIL"))


def recipe():
    return addon("settings_recipe").to_recipe(terrain(), bpy.context.scene)


def grow(name):
    with view():
        bpy.ops.orogen.grow("INVOKE_DEFAULT")
    yield from until(lambda: not session.running)
    found[f"message_{name}"] = session.message
    yield 1.0
    picture(name)


def clear():
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    for collection in list(bpy.data.collections):
        bpy.data.collections.remove(collection)


def steps():
    global session
    session = bpy.context.window_manager.orogen
    press("ESC")  # the splash
    yield 1.0
    clear()
    with view():
        bpy.context.area.spaces.active.show_region_ui = True
        bpy.ops.orogen.add_terrain(start="DRAWING")
    terrain().orogen.resolution = 192
    yield 1.0
    with view():
        sidebar = next(r for r in bpy.context.area.regions if r.type == "UI")
        sidebar.active_panel_category = "Orogen"
        bpy.ops.orogen.draw(layer="Coast")
    yield 1.0
    picture("draw_1_empty")
    yield from draw("Coast", arc(0.1, 3.0, 180), arc(3.2, 6.2, 180))
    yield from draw("Rivers", arc(4.4, 4.45, 60)[:1] + arc(4.6, 4.7, 190)[:1])
    found["strokes"] = [f["properties"]["kind"] for f in recipe()["map"]["features"]]
    flat = [p for f in recipe()["map"]["features"][:1] for p in f["geometry"]["coordinates"][0]]
    found["points"] = len(flat)
    strokes = addon("scene.strokes").read_strokes(pencil(), 1)
    found["off_the_plane"] = max(abs(stroke.points[:, 2]).max() for stroke in strokes)
    with view():
        bpy.ops.object.mode_set(mode="OBJECT")
    yield from draw("Peaks", arc(1.5, 1.52, 60)[:2], arc(2.5, 2.52, 60)[:2])
    found["peaks"] = sum(f["properties"]["kind"] == "peak" for f in recipe()["map"]["features"])
    yield 0.5
    picture("draw_2_drawn")
    yield from grow("draw_3_grown")
    found["vertices"] = len(terrain().data.vertices)
    found["gaps"] = sum("coast is open" in p.text for p in terrain().orogen.problems)

    with view():
        bpy.ops.object.mode_set(mode="OBJECT")
    clear()
    with view():
        bpy.ops.ed.undo_push(message="Cleared")
        bpy.ops.orogen.add_terrain("EXEC_DEFAULT", True, start="PLATES")  # with undo
        bpy.ops.view3d.view_axis(type="TOP")
        region = bpy.context.area.spaces.active.region_3d
        region.view_distance, region.view_location = 130.0, (10, 0, 0)
    found["objects"] = len(bpy.data.objects)
    yield 2.0
    picture("plates_1_start")
    with view():
        bpy.ops.ed.undo()
    yield 0.5
    found["undone"] = len([ob for ob in bpy.data.objects if ob.orogen.is_terrain])
    with view():
        bpy.ops.ed.redo()
    yield 0.5
    found["redone"] = len(bpy.data.objects)
    terrain().orogen.resolution = 192
    yield from grow("plates_2_grown")
    arrows = [ob for ob in bpy.data.objects if ob.name.startswith("South")]
    for ob in arrows:
        ob.empty_display_size = 80
    yield from grow("plates_3_problem")
    found["placed"] = [p.has_place for p in terrain().orogen.problems]


run(steps())
