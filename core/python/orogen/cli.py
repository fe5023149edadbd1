"""The command line: python -m orogen generate | schema | info."""

import argparse
import json
import os
import signal
import sys
import warnings

from . import _core, files, pipeline

EXIT_INPUT = 2
EXIT_INTERRUPTED = 130


def main(arguments=None):
    options = _parser().parse_args(arguments)
    # Ctrl-C works even where the shell started us in the background with SIGINT ignored.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    warnings.showwarning = lambda message, *_: _warn(message)
    try:
        return options.run(options)
    except (_core.InputError, MemoryError) as error:
        print(f"orogen: {_one_line(error)}", file=sys.stderr)
        return EXIT_INPUT
    except OSError as error:
        print(f"orogen: {error.filename or 'file'}: {error.strerror or error}", file=sys.stderr)
        return EXIT_INPUT
    except (KeyboardInterrupt, _core.Cancelled):
        print("orogen: interrupted; nothing was written", file=sys.stderr)
        return EXIT_INTERRUPTED


def _warn(message):
    print(f"orogen: warning: {message}", file=sys.stderr)


def _one_line(error):
    return " ".join(str(error).split())


def _parser():
    parser = argparse.ArgumentParser(prog="orogen", description="Grows terrain from vector maps.")
    parser.add_argument("--version", action="version", version=f"orogen {_core.__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    generate = commands.add_parser("generate", help="make a terrain and write it to files")
    generate.add_argument(
        "recipe", help=f"recipe, GeoJSON map, or one of: {', '.join(pipeline.shipped())}"
    )
    generate.add_argument("-o", "--output", required=True, help="folder to write to")
    generate.add_argument("--resolution", type=int, help="cells along the longer side")
    generate.add_argument("--threads", type=int, default=0, help="0: all cores (the default)")
    generate.add_argument("--seed", type=int, help="in place of the recipe's")
    generate.add_argument(
        "--format", nargs="+", default=[], choices=files.FORMATS, metavar="FORMAT",
        help=f"beside npz: {', '.join(f for f in files.FORMATS if f != 'npz')}",
    )  # fmt: skip
    generate.add_argument(
        "--fields", nargs="+", default=["elevation"], metavar="FIELD",
        help="what tif, exr and png16 are written of (default: elevation)",
    )  # fmt: skip
    generate.add_argument("--strict", action="store_true", help="refuse maps that need mending")
    generate.add_argument("--memory-limit", type=float, metavar="GIB", help="refuse to need more")
    generate.set_defaults(run=_generate)

    schema = commands.add_parser("schema", help="print stages, parameters and fields as JSON")
    schema.set_defaults(run=_schema)

    info = commands.add_parser("info", help="tell what a recipe, a map or a terrain is")
    info.add_argument("file")
    info.set_defaults(run=_info)
    return parser


def _generate(options):
    formats = list(dict.fromkeys(["npz", *options.format]))
    files.check_formats(formats)
    known = {info["name"] for info in _core.schema()["fields"]}
    for name in options.fields:
        if name not in known:
            raise _core.InputError(f"--fields: there is no field '{name}'")
    recipe = pipeline.Recipe.load(options.recipe, strict=options.strict)
    limit = options.memory_limit
    bar = ProgressBar(sys.stderr)
    try:
        terrain = pipeline.generate(
            recipe,
            resolution=options.resolution,
            threads=options.threads,
            seed=options.seed,
            progress=bar.show,
            memory_limit_bytes=None if limit is None else max(1, int(limit * 2**30)),
            cache=None,
        )
    finally:
        bar.clear()
    report = files.save_terrain(terrain, options.output, formats, fields=options.fields)
    for warning in recipe.warnings:
        _warn(warning)
    if not files.can_draw():
        print("orogen: no previews without pillow: pip install 'orogen[files]'", file=sys.stderr)
    seconds = sum(report["seconds"].values())
    grid = report["grid"]
    print(f"{options.output}: {grid['nx']} x {grid['ny']} cells in {seconds:.1f} s")
    return 0


class ProgressBar:
    """One line on a terminal; nothing where the stream is none."""

    WIDTH = 30

    def __init__(self, stream):
        self._stream = stream if stream.isatty() else None

    def show(self, stage, fraction):
        if self._stream:
            done = int(fraction * self.WIDTH)
            bar = "#" * done + "." * (self.WIDTH - done)
            self._stream.write(f"\r{bar} {fraction:4.0%} {stage[:24]:24}")
            self._stream.flush()

    def clear(self):
        if self._stream:
            self._stream.write("\r" + " " * (self.WIDTH + 31) + "\r")
            self._stream.flush()


def _schema(_options):
    _print_json(_core.schema())
    return 0


def _info(options):
    if options.file.endswith(".npz"):
        _print_json(_terrain_info(options.file))
    else:
        _print_json(_recipe_info(options.file))
    return 0


def _recipe_info(file):
    recipe = pipeline.Recipe.load(file)
    document = recipe.to_dict()
    grid = recipe.grid()
    return {
        "name": recipe.name,
        "recipe_sha256": recipe.hash,
        "seed": recipe.seed,
        "projection": recipe.projection,
        "grid": {"nx": grid.nx, "ny": grid.ny, "cell_size": grid.cell_size, "origin": grid.origin},
        "stages": document["stages"],
        "warnings": recipe.warnings,
    }


def _terrain_info(file):
    import zipfile

    import numpy

    try:
        with numpy.load(file, allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in archive.files}
    except (ValueError, KeyError, zipfile.BadZipFile):
        raise _core.InputError(f"{file}: no terrain that can be read") from None
    fields = {n: a for n, a in arrays.items() if n not in ("cell_size", "origin")}
    if "elevation" not in fields:
        raise _core.InputError(f"{os.path.basename(file)}: has no field 'elevation'")
    return {
        "cell_size": arrays["cell_size"].tolist() if "cell_size" in arrays else None,
        "origin": arrays["origin"].tolist() if "origin" in arrays else None,
        "shape": list(fields["elevation"].shape),
        "fields": {
            name: {"dtype": str(a.dtype), "min": a.min().item(), "max": a.max().item()}
            for name, a in fields.items()
            if a.size
        },
    }


def _print_json(document):
    json.dump(document, sys.stdout, indent=1)
    sys.stdout.write("\n")
