"""Runs in a real Blender window: feature curves and polygons of an island, edited live; pictures to
look at. What it found goes to out/result.json.
"""

import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Quaternion
from window_tools import (
    addon,
    found,
    heights,
    opened,
    picture,
    run,
    terrain,
    until,
    view,
    view_area,
)

PLACES = {"RIDGE": (-16, -9), "CLIFF": (14, 10), "RIVER_BED": (12, -9)}  # km


def look(distance=95.0, tilt=(0.87, 0.49, 0.05, 0.05)):
    with view():
        region = bpy.context.area.spaces.active.region_3d
        region.view_perspective = "PERSP"
        region.view_rotation = Quaternion(tilt).normalized()
        region.view_location, region.view_distance = (4.0, -2.0, 0.0), distance


def grow():
    session = bpy.context.window_manager.orogen
    with view():
        bpy.ops.orogen.grow("INVOKE_DEFAULT")
    yield from until(lambda: not session.running)
    found["message"] = session.message
    yield 0.5


def activate(ob):
    with view():
        addon("terrains").activate(bpy.context, ob)


def add_curves():
    for kind, (x, y) in PLACES.items():
        activate(terrain())
        bpy.context.scene.cursor.location = (x, y, 0)
        with view():
            bpy.ops.orogen.add_feature_curve("EXEC_DEFAULT", True, kind=kind)
        yield 0.2


def feature_curves():
    overlay = addon("overlay.features")
    made = []
    make = overlay.make
    overlay.make = lambda *arguments: made.append(1) or make(*arguments)
    yield from add_curves()
    look()
    yield 1.0
    picture("1_drawn")
    made.clear()
    for _ in range(5):
        view_area().tag_redraw()
        yield 0.1
    found["made_anew_without_an_edit"] = len(made)
    bpy.context.object.orogen_feature.plateau = 400
    yield from until(lambda: made, 20.0)
    found["made_anew_after_an_edit"] = len(made)
    yield from grow()
    found["message_curves"] = found["message"]
    ridge = next(ob for ob in bpy.data.objects if ob.name == "Ridge")
    activate(ridge)
    look(55.0)
    yield 1.0
    picture("2_grown")
    terrain().orogen.input.show_features = False
    look(95.0)
    yield 1.0
    picture("3_ground")
    terrain().orogen.input.show_features = True
    yield from edit_live(ridge)


def edit_live(ridge):
    """In edit mode a preview follows; Ctrl-Z brings the curve and its ground back."""
    terrain().orogen.live.enabled = True
    mesh = addon("mesh.terrain_mesh")
    ridge.location.x -= 0.5
    yield from until(lambda: mesh.is_preview(terrain()))
    yield 0.5
    with view():
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.curve.select_all(action="DESELECT")
        bpy.ops.ed.undo_push(message="Edit")
    point = ridge.data.splines[0].bezier_points[3]
    point.select_control_point = True
    before, mark, high = heights(terrain()), mesh.grown_from(terrain()), point.co.z
    with view():
        bpy.ops.transform.translate("EXEC_DEFAULT", True, value=(0, 0, 1.5))
    yield from until(lambda: mesh.grown_from(terrain()) != mark)
    yield 0.5
    found["rise"] = float((heights(terrain()) - before).max())
    look(55.0)
    yield 0.5
    picture("4_edited")
    with view():
        bpy.ops.ed.undo()
    yield from until(lambda: mesh.grown_from(terrain()) == mark)
    point = (
        next(ob for ob in bpy.data.objects if ob.name == "Ridge").data.splines[0].bezier_points[3]
    )
    found["undone"] = abs(point.co.z - high) < 1e-6
    found["ground_undone"] = float(abs(heights(terrain()) - before).max())
    with view():
        bpy.ops.object.mode_set(mode="OBJECT")
    terrain().orogen.live.enabled = False


def polygons():
    activate(terrain())
    terrain().orogen.input.show_polygons = True
    loop = addon("live.loop")
    yield from until(lambda: loop.polygons_shown() is not None)
    look(100.0, (0.96, 0.28, 0.0, 0.0))
    yield 1.0
    picture("5_polygons")
    terrain().orogen.input.show_downslopes = True
    look(40.0)
    yield 1.0
    picture("6_downslopes")
    yield from click_polygon(loop)
    terrain().orogen.input.show_polygons = False


def click_polygon(loop):
    """A click with the tool changes the polygon there; an undo takes it back."""
    with view():
        bpy.ops.wm.tool_set_by_id(name="orogen.polygon_tool")
        area, region = bpy.context.area, bpy.context.region
        shown = area.spaces.active.region_3d
        at = location_3d_to_region_2d(region, shown, (4.0, -2.0, 0.5))
    window = bpy.context.window_manager.windows[0]
    x, y = int(at.x + region.x), int(at.y + region.y)
    window.event_simulate("MOUSEMOVE", "NOTHING", x=x, y=y)
    yield 0.2
    before = loop.polygons_shown()
    for value in ("PRESS", "RELEASE"):
        window.event_simulate("LEFTMOUSE", value, x=x, y=y)
    yield from until(lambda: len(terrain().orogen.paints.polygons) == 1, 10.0)
    yield from until(lambda: loop.polygons_shown()[0] != before[0], 10.0)
    yield 0.5
    picture("7_changed")
    with view():
        bpy.ops.ed.undo()
    yield 0.5
    found["edits_after_undo"] = len(terrain().orogen.paints.polygons)


def springs():
    """A preview follows a spring that is moved; undone, it is back, and then gone."""
    mesh = addon("mesh.terrain_mesh")

    def now():
        return mesh.grown_from(terrain())

    def drawn():
        return [ob for ob in bpy.data.objects if ob.orogen_spring.is_spring]

    activate(terrain())
    bpy.context.scene.cursor.location = (*PLACES["RIDGE"], 0)
    terrain().orogen.live.enabled = True
    yield 1.0
    before = now()
    with view():
        bpy.ops.orogen.add_spring("EXEC_DEFAULT", True)
    yield from until(lambda: now() != before)
    added, x = now(), drawn()[0].location.x
    with view():
        bpy.ops.transform.translate("EXEC_DEFAULT", True, value=(2, 1, 0))
    yield from until(lambda: now() != added)
    picture("9_spring")
    with view():
        bpy.ops.ed.undo()
    yield from until(lambda: now() == added)
    found["spring_back"] = [ob.location.x for ob in drawn()] == [x]
    with view():
        bpy.ops.ed.undo()
    yield from until(lambda: now() == before)
    found["springs_after_undo"] = len(drawn())
    terrain().orogen.live.enabled = False


def biomes():
    activate(terrain())
    yield from grow()
    terrain().orogen.view.field = "biome"
    look(100.0, (0.96, 0.28, 0.0, 0.0))
    yield 1.0
    picture("8_biomes")


def steps():
    yield from opened()
    with view():
        bpy.ops.orogen.add_terrain("EXEC_DEFAULT", True, start="ISLAND")
    terrain().orogen.resolution, terrain().orogen.vertical_exaggeration = 384, 1.5
    yield from grow()
    yield from feature_curves()
    yield from polygons()
    yield from biomes()
    yield from springs()


run(steps())
