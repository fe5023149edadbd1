"""Runs in a real Blender window: installs the zip, grows, cancels with Esc, undoes, takes pictures.

A generator is stepped by a timer; every `yield SECONDS` lets the window live for a while. What it
found goes to out/result.json.
"""

import importlib.util
import time
from pathlib import Path

import bpy
from window_tools import ADDON, OUT, found, heights, picture, press, run, terrain, until, view


def invoke_grow():
    with view():
        return list(bpy.ops.orogen.grow("INVOKE_DEFAULT"))


def open_panels():
    """Every panel open from the start, so that each is drawn."""
    panels = importlib.import_module(f"{ADDON}.panels")
    panels.unregister()
    for cls in panels.CLASSES:
        cls.bl_options = set()
    panels.register()


def steps():
    session = bpy.context.window_manager.orogen
    press("ESC")  # the splash
    yield 1.0
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    with view() as _:
        bpy.ops.orogen.add_terrain()
        bpy.context.area.spaces.active.show_region_ui = True
        bpy.context.area.spaces.active.clip_end = 5000
    yield 1.0
    with view():
        sidebar = next(r for r in bpy.context.area.regions if r.type == "UI")
        sidebar.active_panel_category = "Orogen"
    settings = terrain().orogen
    settings.source, settings.resolution = "EXAMPLE", 128
    bpy.ops.ed.undo_push(message="Settings")
    yield 1.0
    picture("1_ready")
    open_panels()
    yield 1.0
    picture("1_panels")

    # Growing: the operator returns at once, progress shows, the mesh comes in one undo step.
    found["invoke"] = invoke_grow()
    found["running"] = session.running
    yield from until(lambda: session.fraction > 0 or not session.running)
    yield from until(lambda: not session.running)
    found["vertices"] = len(terrain().data.vertices)
    found["message"] = session.message
    with view():
        bpy.ops.view3d.view_all()
    yield 1.5
    picture("2_grown")

    # Esc: the job ends at once and the terrain stays.
    before = list(heights(terrain()))
    terrain().orogen.seed = 777
    terrain().orogen.resolution = 2048
    bpy.ops.ed.undo_push(message="Settings")
    invoke_grow()
    yield from until(lambda: session.fraction > 0)
    yield 0.3
    picture("3_growing")
    found["fraction_at_esc"] = session.fraction
    begin = time.monotonic()
    press("ESC")
    yield from until(lambda: not session.running)
    found["seconds_to_cancel"] = time.monotonic() - begin
    found["kept"] = list(heights(terrain())) == before
    found["message_after_esc"] = session.message
    yield 0.5
    picture("4_cancelled")

    # The Cancel button does the same.
    invoke_grow()
    yield from until(lambda: session.fraction > 0)
    with view():
        bpy.ops.orogen.cancel()
    yield from until(lambda: not session.running)
    found["cancel_button"] = list(heights(terrain())) == before

    # The latest job wins.
    invoke_grow()
    yield 0.3
    terrain().orogen.resolution = 128
    invoke_grow()
    yield from until(lambda: not session.running)
    yield 0.5
    found["latest_wins"] = len(terrain().data.vertices) == found["vertices"]
    second = list(heights(terrain()))
    found["second_differs"] = second != before

    # One undo takes the growth back, one redo brings it again.
    with view():
        bpy.ops.ed.undo()
    yield 0.5
    found["undone"] = list(heights(terrain())) == before
    with view():
        bpy.ops.ed.redo()
    yield 0.5
    found["redone"] = list(heights(terrain())) == second

    yield from rocks(session)

    # The terrain is deleted while it grows.
    terrain().orogen.resolution = 1024
    invoke_grow()
    yield from until(lambda: session.fraction > 0)
    bpy.data.objects.remove(terrain())
    yield from until(lambda: not session.running)
    found["message_when_gone"] = session.message
    yield 0.5
    picture("5_gone")

    # Another file is loaded while it grows.
    with view():
        bpy.ops.orogen.add_terrain()
    terrain().orogen.resolution, terrain().orogen.seed = 1024, 778
    invoke_grow()
    yield from until(lambda: session.fraction > 0)
    bpy.ops.wm.read_homefile(use_empty=False)
    yield 1.0
    found["running_after_load"] = bpy.context.window_manager.orogen.running


def rocks(session):
    """Colliding plates: what lies below them, and their growth as an animation; Esc in both."""
    drawn = terrain()
    recipes = Path(importlib.util.find_spec("orogen").origin).parent / "recipes"
    with view():
        bpy.ops.orogen.add_terrain()
        bpy.ops.orogen.load_map(filepath=str(recipes / "folded_range.orogen.json"))
    range_ = bpy.context.object
    range_.orogen.resolution = 128
    yield 0.5
    invoke_grow()
    yield from until(lambda: not session.running)
    with view():
        bpy.ops.view3d.view_all()

    def invoke(operator, **more):
        with view():
            return list(operator("INVOKE_DEFAULT", **more))

    for name in ("block", "section", "horizons"):
        kind = getattr(bpy.ops.orogen, f"add_{name}")
        found[f"invoke_{name}"] = invoke(kind)
        yield from until(lambda: not session.running)
        found[f"message_{name}"] = session.message
    found["rock_objects"] = len(range_.children)
    yield 1.0
    picture("6_rocks")

    # With other settings the worker must grow it anew, which leaves time to press Esc.
    before = list(heights(range_))
    range_.orogen.seed = 41
    range_.orogen.resolution = 1024
    cache = OUT / "growth.pc2"
    found["invoke_growth"] = invoke(
        bpy.ops.orogen.animate_growth, filepath=str(cache), frames=8, step=1
    )
    yield from until(lambda: session.fraction > 0)
    yield 0.3
    begin = time.monotonic()
    press("ESC")
    yield from until(lambda: not session.running)
    found["growth_seconds_to_cancel"] = time.monotonic() - begin
    found["growth_kept"] = list(heights(range_)) == before and not cache.exists()
    range_.orogen.resolution = 128
    invoke(bpy.ops.orogen.animate_growth, filepath=str(cache), frames=8, step=1)
    yield from until(lambda: not session.running)
    found["growth_frames"] = cache.exists() and len(range_.modifiers)
    bpy.context.scene.frame_set(4)
    yield 1.0
    picture("7_growth")
    for child in list(range_.children):
        bpy.data.objects.remove(child)
    bpy.data.objects.remove(range_)
    bpy.context.view_layer.objects.active = drawn
    drawn.select_set(True)
    yield 0.5


run(steps())
