"""What scripts in a real window share: a generator is stepped by a timer, every `yield SECONDS`
lets the window live for a while. What was found goes to out/result.json."""

import importlib
import json
import os
import sys
import time
import traceback
from pathlib import Path

import bpy
import numpy as np

HERE = Path(__file__).parent
OUT = HERE / "out"
ADDON = "bl_ext.user_default.orogen"
found = {}


def addon(name):
    return importlib.import_module(f"{ADDON}.{name}")


def picture(name):
    os.system(f"xwd -root -silent | convert xwd:- {OUT / name}.png")


def press(kind):
    window = bpy.context.window_manager.windows[0]
    for value in ("PRESS", "RELEASE"):
        window.event_simulate(kind, value, x=400, y=400)


def view_area():
    return next(
        a for a in bpy.context.window_manager.windows[0].screen.areas if a.type == "VIEW_3D"
    )


def view():
    window, area = bpy.context.window_manager.windows[0], view_area()
    region = next(region for region in area.regions if region.type == "WINDOW")
    return bpy.context.temp_override(window=window, area=area, region=region)


def invoke(operator, *arguments, **more):
    with view():
        return list(operator(*arguments, **more))


def heights(ob):
    values = np.empty(len(ob.data.vertices) * 3, np.float32)
    ob.data.attributes["position"].data.foreach_get("vector", values)
    return values[2::3].copy()


def terrain():
    return next(ob for ob in bpy.data.objects if ob.orogen.is_terrain)


def until(condition, limit=120.0, tick=0.02):
    end = time.monotonic() + limit
    while not condition() and time.monotonic() < end:
        yield tick
    assert condition(), "waited in vain"


def opened():
    """An empty scene and the extension's tab beside it."""
    press("ESC")  # the splash
    yield 1.0
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    with view():
        bpy.context.area.spaces.active.show_region_ui = True
        bpy.context.area.spaces.active.clip_start = 1.0
        bpy.context.area.spaces.active.clip_end = 5000
    yield 1.0
    with view():
        sidebar = next(r for r in bpy.context.area.regions if r.type == "UI")
        sidebar.active_panel_category = "Orogen"


def new_terrain(**settings):
    with view():
        bpy.ops.orogen.add_terrain()
    ob = bpy.context.object
    for name, value in settings.items():
        setattr(ob.orogen, name, value)
    return ob


def view_all():
    with view():
        bpy.ops.view3d.view_all()


def clear():
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    bpy.data.orphans_purge()


def load(example, resolution):
    clear()
    new_terrain(source="EXAMPLE", example=example, resolution=resolution)
    view_all()


class Watch:
    """When previews are asked for and written, and what the main thread spends on them."""

    def __init__(self):
        self.loop, self.mesh = addon("live.loop"), addon("mesh.terrain_mesh")
        self.jobs = addon("worker.jobs").jobs
        self.changed, self.asked, self.latency, self.spent = 0.0, 0.0, [], {}
        self.write, self.start = self.mesh.write, self.jobs.start_preview
        self.look = self.loop._loop._look

    def __enter__(self):
        self.mesh.write = self._timed("write", self.write, self._written)
        self.loop._loop._look = self._timed("read", self.look)
        self.jobs.start_preview = self._asked
        return self

    def __exit__(self, *_):
        self.mesh.write, self.jobs.start_preview = self.write, self.start
        self.loop._loop._look = self.look

    def _asked(self, recipe):
        self.asked = self.changed
        return self.start(recipe)

    def _written(self):
        self.latency.append(time.perf_counter() - self.asked)

    def _timed(self, name, function, after=None):
        def timed(*arguments, **more):
            begin = time.perf_counter()
            result = function(*arguments, **more)
            self.spent.setdefault(name, []).append(time.perf_counter() - begin)
            if after:
                after()
            return result

        return timed


def percentiles(seconds):
    values = np.percentile(1e3 * np.array(seconds), [50, 95, 100])
    return dict(zip(("median", "p95", "max"), values.round(2).tolist(), strict=True))


def finish(error=""):
    found["error"] = error
    (OUT / "result.json").write_text(json.dumps(found, indent=1))
    sys.stdout.flush()
    os._exit(0)


def run(steps):
    """Installs the zip beside the script and takes the steps of a generator."""

    def step():
        try:
            return next(steps)
        except StopIteration:
            finish()
        except BaseException:
            picture("error")
            finish(traceback.format_exc())

    def begin():
        OUT.mkdir(exist_ok=True)
        archive = next(HERE.glob("*.zip"))
        bpy.ops.extensions.package_install_files(
            repo="user_default", filepath=str(archive), enable_on_install=True, overwrite=True
        )
        bpy.app.timers.register(step, first_interval=1.0, persistent=True)

    bpy.app.timers.register(begin, first_interval=1.0)
