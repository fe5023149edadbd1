"""Runs in a process with bpy: `install ZIP`, or `test FILE FUNCTION [TMP_PATH]`."""

import importlib.util
import os
import sys
import traceback
from pathlib import Path

import bpy

ADDON = "bl_ext.user_default.orogen"


def install(archive):
    bpy.ops.extensions.package_install_files(
        repo="user_default", filepath=archive, enable_on_install=True, overwrite=True
    )
    assert ADDON in bpy.context.preferences.addons, "the extension was not enabled"


def test(file, function, *arguments):
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    if ADDON not in bpy.context.preferences.addons:
        bpy.ops.preferences.addon_enable(module=ADDON)
    sys.path.insert(0, str(Path(__file__).parent))
    spec = importlib.util.spec_from_file_location(Path(file).stem, file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    getattr(module, function)(*map(Path, arguments))


def main(what, *arguments):
    status = 0
    try:
        {"install": install, "test": test}[what](*arguments)
        bpy.ops.preferences.addon_disable(module=ADDON) if what == "test" else None
    except BaseException:
        traceback.print_exc()
        status = 1
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # Blender's own end may crash or hang when scripts leave things registered


if __name__ == "__main__":
    main(*sys.argv[1:])
