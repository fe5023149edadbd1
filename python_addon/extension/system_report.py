"""What a report of a problem should say: versions, the machine, the last message, the recipe."""

import json
import os
import platform
import subprocess
from pathlib import Path

import bpy
import gpu
import tomllib

from . import terrains
from .operators.job_operator import REFUSALS
from .settings_recipe import to_recipe
from .worker import launch

PATIENCE = 60.0  # s
PROGRAM = """
import json, sys, orogen
recipe = json.load(sys.stdin)
hash = orogen.Recipe.from_dict(recipe).hash if recipe else None
print(json.dumps([orogen.__version__, orogen.available_memory(), hash]))
"""


def make(context):
    """The report, as lines of `what: value`."""
    session = context.window_manager.orogen
    terrain = terrains.active(context)
    document, asked_for = _recipe(terrain, context.scene)
    core, memory, digest = _ask_core(document)
    if digest:
        asked_for = f"{digest}, {document['resolution']} cells"
    rows = {
        "Orogen": _version(),
        "Core": core,
        "Blender": f"{bpy.app.version_string} ({bpy.app.build_hash.decode()})",
        "Python": platform.python_version(),
        "Platform": platform.platform(),
        "Processors": os.cpu_count(),
        "Memory available": memory,
        "GPU": _gpu(),
        "Terrain": terrain.orogen.source.lower() if terrain else "none is active",
        "Recipe": asked_for,
        "Message": session.message or "none",
    }
    return "\n".join(f"{name}: {value}" for name, value in rows.items())


def _version():
    manifest = Path(__file__).with_name("blender_manifest.toml")
    return tomllib.loads(manifest.read_text(encoding="utf-8"))["version"]


def _recipe(terrain, scene):
    """The recipe, or why there is none."""
    if terrain is None:
        return None, "none"
    try:
        return to_recipe(terrain, scene), "refused by the core"
    except REFUSALS as error:
        return None, str(error)


def _ask_core(document):
    """Version of the core, memory, the recipe's hash: asked of a process like the worker's."""
    try:
        answer = subprocess.run(
            [launch.python_executable(), "-P", "-c", PROGRAM],
            input=json.dumps(document),
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            env=launch.environment(),
        )
    except (launch.NoCore, OSError, subprocess.TimeoutExpired) as error:
        return f"does not start: {error}", "unknown", None
    if answer.returncode:
        last = (answer.stderr.strip().splitlines() or ["no message"])[-1]
        return f"failed: {last}", "unknown", None
    version, memory, digest = json.loads(answer.stdout)
    known = memory < 2**60  # else the system does not say
    return version, f"{memory / 2**30:.1f} GiB" if known else "unknown", digest


def _gpu():
    try:
        names = gpu.platform.backend_type_get(), gpu.platform.renderer_get()
        return ", ".join(names)
    except SystemError:  # in the background
        return "none in use"
