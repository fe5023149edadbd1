"""Runs in a real Blender window: fields with their legend, lines, tiles, an export through the
browser of files; pictures to look at. What it found goes to out/result.json.
"""

import importlib
import json

import bpy
import window_tools
from window_tools import ADDON, OUT, found, picture, press, terrain, until


def view(kind="VIEW_3D"):
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == kind)
    region = next(region for region in area.regions if region.type == "WINDOW")
    return bpy.context.temp_override(window=window, area=area, region=region)


def run(operator, **more):
    """An operator as a button starts it, until the worker is done."""
    session = bpy.context.window_manager.orogen
    with view():
        found[operator] = list(getattr(bpy.ops.orogen, operator)("INVOKE_DEFAULT", **more))
    yield from until(lambda: not session.running)
    found[f"message_{operator}"] = session.message
    yield 0.3


def open_panels():
    panels = importlib.import_module(f"{ADDON}.panels")
    panels.unregister()
    for cls in panels.CLASSES:
        if cls.__name__ in ("OROGEN_PT_view", "OROGEN_PT_output", "OROGEN_PT_meshes"):
            cls.bl_options = set()
    panels.register()


def steps():
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    press("ESC")  # the splash
    open_panels()
    yield 1.0
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    with view():
        bpy.ops.orogen.add_terrain()
        bpy.context.area.spaces.active.show_region_ui = True
        bpy.context.area.spaces.active.clip_end = 5000
    yield 1.0
    yield from map_fields()
    yield from range_fields()
    yield from export_field()


def map_fields():
    """Corsica, seen by height; the choice of a field is undone by a key."""
    terrain().orogen.source, terrain().orogen.resolution = "EXAMPLE", 256
    terrain().orogen.vertical_exaggeration = 2.0
    yield from run("grow")
    with view():
        bpy.ops.view3d.view_selected()
        sidebar = next(r for r in bpy.context.area.regions if r.type == "UI")
        sidebar.active_panel_category = "Orogen"
    for name in ("elevation", "boundary_kind"):
        terrain().orogen.view.field = name
        bpy.ops.ed.undo_push(message="Show")
        yield 1.0
        picture(f"1_{name}")
    with view():
        shading = bpy.context.area.spaces.active.shading
        found["solid"] = [shading.type, shading.color_type]
        bpy.ops.ed.undo()
    yield 0.5
    legend = json.loads(terrain().data["orogen_legend"])
    found["undone"] = [terrain().orogen.view.field, legend["label"]]


def range_fields():
    """A folded range: strata, drainage, traces and rivers, tiles."""
    terrain().orogen.example, terrain().orogen.resolution = "folded_range", 192
    yield from run("grow")
    with view():
        bpy.ops.view3d.view_selected()
        terrain().select_set(False)
    for name in ("strata_color", "drainage_area"):
        terrain().orogen.view.field = name
        yield 1.0
        picture(f"2_{name}")
    yield from run("add_traces")
    yield from run("add_rivers")
    terrain().orogen.view.field = "rock_layer"
    yield 1.0
    picture("3_lines")
    for child in terrain().children:
        child.hide_set(True)
    yield from run("split_tiles", count=3, skirt=500.0)
    found["tiles"] = sum(ob.get("orogen_role") == "tiles" for ob in terrain().children)


def export_field():
    """Modal after the browser: the window lives while the worker grows what it no longer has."""
    importlib.import_module(f"{ADDON}.worker.jobs").jobs.shutdown()
    session = bpy.context.window_manager.orogen
    with view():
        bpy.ops.orogen.export_terrain("INVOKE_DEFAULT", format="exr")
    yield 1.0
    with view("FILE_BROWSER"):
        browser = bpy.context.area.spaces.active.params
        browser.directory, browser.filename = str(OUT).encode(), "heights.exr"
    yield 0.5
    picture("4_browser")
    with view("FILE_BROWSER"):
        bpy.ops.file.execute()
    yield from until(lambda: session.running, 5.0)
    yield from until(lambda: not session.running)
    found["message_export"], found["written"] = session.message, (OUT / "heights.exr").exists()


window_tools.run(steps())
