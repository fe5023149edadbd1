"""Runs in a real Blender window: the chooser of presets, and the making of an asset library.
What it found goes to out/result.json.
"""

import shutil
from pathlib import Path

import bpy
from window_tools import found, invoke, picture, press, run, terrain, until, view, view_area

FOLDER = Path("/tmp/orogen_assets")


def written():
    return sorted(file.name for file in FOLDER.glob("*"))


def steps():
    session = bpy.context.window_manager.orogen
    shutil.rmtree(FOLDER, ignore_errors=True)
    press("ESC")  # the splash
    yield 1.0
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    view_area().spaces.active.show_region_ui = True
    yield 1.0
    with view():
        next(r for r in bpy.context.area.regions if r.type == "UI").active_panel_category = "Orogen"
        bpy.ops.wm.call_panel(name="OROGEN_PT_presets")
    yield 2.0
    picture("1_presets")
    press("ESC")
    yield 0.5

    before = {thing.name for thing in bpy.data.user_map()}

    # The dialog, then terrains one after another; Esc.
    found["invoke"] = invoke(
        bpy.ops.orogen.save_asset_library, "INVOKE_DEFAULT", directory=str(FOLDER), resolution=256
    )
    yield 1.0
    picture("2_dialog")
    press("RET")
    yield from until(lambda: session.fraction > 0.0)
    picture("3_growing")
    yield from until(lambda: len(written()) > 0)
    yield from until(lambda: session.fraction < 0.9)
    press("ESC")
    yield from until(lambda: not session.running)
    found["after_esc"], found["message_after_esc"] = written(), session.message
    found["left_over"] = sorted({thing.name for thing in bpy.data.user_map()} - before)
    yield 0.5

    # To its end.
    invoke(
        bpy.ops.orogen.save_asset_library, "INVOKE_DEFAULT", directory=str(FOLDER), resolution=64
    )
    yield 0.5
    press("RET")
    yield from until(lambda: session.running)
    yield from until(lambda: not session.running, limit=300.0)
    found["written"], found["message"] = written(), session.message
    with view():
        bpy.ops.wm.append(directory=str(FOLDER / "Corsica.blend/Object") + "/", filename="Corsica")
    found["children"] = [child.name for child in terrain().children]
    area = view_area()
    area.ui_type = "ASSETS"
    yield 1.0
    area.spaces.active.params.asset_library_reference = "Orogen"
    yield 4.0
    picture("4_assets")


run(steps())
