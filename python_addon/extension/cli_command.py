"""blender -b FILE.blend --command orogen ...: for shells, scripts and farms."""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import bpy

from . import system_report
from .worker import launch

FAILED = 2
_handles = []


class Refused(RuntimeError):
    """What was asked for cannot be done; the message says why."""


def main(arguments):
    """Runs a command and returns the exit status. A complaint is one line on standard error."""
    try:
        options = _parser().parse_args(arguments)
        options.run(options)
    except SystemExit as end:  # argparse has said why
        return end.code
    except (Refused, launch.NoCore, OSError) as error:
        print(f"orogen: {error}", file=sys.stderr)
        return FAILED
    return 0


def _parser():
    parser = argparse.ArgumentParser(
        prog="blender -b FILE.blend --command orogen", description="Terrains of a .blend"
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    generate = commands.add_parser("generate", help="grow terrains and save the .blend")
    generate.add_argument("objects", nargs="*", metavar="OBJECT", help="default: all terrains")
    generate.add_argument("--resolution", type=int, help="cells along the longer side")
    generate.add_argument("--threads", type=int, default=0, help="0: all cores (the default)")
    generate.add_argument(
        "--save", metavar="FILE.blend",
        help="default: where it was opened from, unless there is --export alone",
    )  # fmt: skip
    generate.add_argument(
        "--export", metavar="FOLDER", help="write each terrain's files into FOLDER/OBJECT"
    )
    generate.add_argument(
        "--format", nargs="+", default=[], metavar="FORMAT", help="of --export, beside npz"
    )
    generate.set_defaults(run=_generate)

    recipe = commands.add_parser("recipe", help="write the recipe of a terrain")
    recipe.add_argument("object", metavar="OBJECT")
    recipe.add_argument("file", metavar="FILE")
    recipe.set_defaults(run=lambda options: _save_recipe(_terrain(options.object), options.file))

    report = commands.add_parser("report", help="print versions, machine and messages")
    report.set_defaults(run=_report)
    return parser


def _report(_options):
    active = bpy.context.view_layer.objects.active  # without a window the context has no object
    with bpy.context.temp_override(object=active):
        print(system_report.make(bpy.context))


def _generate(options):
    save = options.save or ("" if options.export else bpy.data.filepath)
    if not save and not options.export:
        raise Refused("no .blend was opened: say where to --save or --export")
    terrains = [_terrain(name) for name in options.objects] or _terrains()
    for terrain in terrains:
        _set_resolution(terrain.orogen, options.resolution)
    for terrain in terrains if save else ():
        _ask(terrain, bpy.ops.orogen.grow, threads=options.threads)
        print(f"{terrain.name}: {len(terrain.data.vertices)} vertices")
    for terrain in terrains if options.export else ():
        _export(terrain, Path(options.export, bpy.path.clean_name(terrain.name)), options)
    if save:
        bpy.ops.wm.save_as_mainfile(filepath=str(Path(save).absolute()))


def _terrains():
    found = [ob for ob in bpy.context.scene.objects if ob.orogen.is_terrain]
    if not found:
        raise Refused(f"the scene '{bpy.context.scene.name}' has no terrain")
    return found


def _terrain(name):
    terrain = bpy.context.scene.objects.get(name)
    if terrain is None or not terrain.orogen.is_terrain:
        raise Refused(f"the scene '{bpy.context.scene.name}' has no terrain called '{name}'")
    return terrain


def _set_resolution(settings, resolution):
    if resolution is None:
        return
    settings.resolution = resolution
    if settings.resolution != resolution:  # a property clamps in silence
        raise Refused(f"--resolution: {resolution} is not allowed; 2 to 65536 is wanted")


def _export(terrain, folder, options):
    """The core itself grows the terrain from its recipe and writes the files."""
    with tempfile.TemporaryDirectory(dir=bpy.app.tempdir or None) as temporary:
        file = Path(temporary, "terrain.orogen.json")
        _save_recipe(terrain, file)
        command = [launch.python_executable(), "-P", "-m", "orogen", "generate", str(file)]
        command += ["-o", str(folder), "--threads", str(options.threads)]
        command += ["--format", *options.format] if options.format else []
        done = subprocess.run(command, env=launch.environment(), stderr=subprocess.PIPE, text=True)
    if done.returncode:
        last = (done.stderr.strip().splitlines() or ["no message"])[-1]
        raise Refused(last.removeprefix("orogen: ").removeprefix("orogen generate: error: "))


def _save_recipe(terrain, file):
    _ask(terrain, bpy.ops.orogen.save_recipe, filepath=str(file))


def _ask(terrain, operator, **arguments):
    """Calls an operator on a terrain."""
    try:
        with bpy.context.temp_override(object=terrain, active_object=terrain):
            operator(**arguments)
    except RuntimeError as error:
        complaint = str(error).strip().splitlines()[0].removeprefix("Error: ")
        raise Refused(f"{terrain.name}: {complaint}") from None


def register():
    _handles.append(bpy.utils.register_cli_command("orogen", main))


def unregister():
    bpy.utils.unregister_cli_command(_handles.pop())
