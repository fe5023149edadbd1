"""The command line: python -m orogen generate | batch | section | schema | info."""

import argparse
import json
import os
import signal
import sys
import time
import warnings

from . import _core, batch, files, pipeline, rock_files

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
    parser = argparse.ArgumentParser(
        prog="orogen", description="Grows terrain from vector maps and from colliding plates."
    )
    parser.add_argument("--version", action="version", version=f"orogen {_core.__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    generate = commands.add_parser("generate", help="make a terrain and write it to files")
    _add_terrain_arguments(generate)
    generate.add_argument("-o", "--output", required=True, help="folder to write to")
    _add_format_argument(generate)
    generate.add_argument(
        "--fields", nargs="+", metavar="FIELD",
        help="what tif, exr and png16 are written of (default: elevation)",
    )  # fmt: skip
    generate.add_argument(
        "--section", nargs=4, type=float, metavar=("X0", "Y0", "X1", "Y1"),
        help="line of the format section in metres (default: through the middle, south to north)",
    )  # fmt: skip
    generate.set_defaults(run=_generate)

    many = commands.add_parser("batch", help="make the terrains of a file of jobs, one a line")
    many.add_argument("jobs", help='lines of JSON: {"recipe": ..., "name": ..., "seed": ..., ...}')
    many.add_argument("-o", "--output", required=True, help="folder; each job has one in it")
    many.add_argument("--index", type=int, metavar="N", help="only that job, counted from 0")
    many.add_argument("--jobs", type=int, default=1, metavar="K", dest="processes",
                      help="so many at a time, in processes of their own (default: 1)")  # fmt: skip
    many.add_argument("--threads", type=int, default=0, help="of each job (default: its share)")
    _add_format_argument(many)
    many.set_defaults(run=_batch)

    section = commands.add_parser("section", help="cut a terrain's rocks open along a line")
    _add_terrain_arguments(section)
    section.add_argument(
        "-o", "--output", required=True, metavar="FILE",
        help=f"file to write, ending in {', '.join(rock_files.SECTION_SUFFIXES)}",
    )  # fmt: skip
    section.add_argument(
        "--line", nargs=4, type=float, metavar=("X0", "Y0", "X1", "Y1"),
        help="in metres (default: through the middle, south to north)",
    )  # fmt: skip
    section.set_defaults(run=_section)

    schema = commands.add_parser("schema", help="print stages, parameters and fields as JSON")
    schema.set_defaults(run=_schema)

    info = commands.add_parser("info", help="tell what a recipe, a map or a terrain is")
    info.add_argument("file")
    info.set_defaults(run=_info)
    return parser


def _add_format_argument(command):
    command.add_argument(
        "--format", nargs="+", default=[], choices=files.FORMATS, metavar="FORMAT",
        help=f"beside npz: {', '.join(f for f in files.FORMATS if f != 'npz')}",
    )  # fmt: skip


def _add_terrain_arguments(command):
    """What says which terrain is made, and how."""
    command.add_argument(
        "recipe",
        help=f"recipe, GeoJSON map, elevation model, or one of: {', '.join(pipeline.shipped())}",
    )
    command.add_argument("--resolution", type=int, help="cells along the longer side")
    command.add_argument("--threads", type=int, default=0, help="0: all cores (the default)")
    command.add_argument("--seed", type=int, help="in place of the recipe's")
    command.add_argument("--strict", action="store_true", help="refuse maps that need mending")
    command.add_argument("--memory-limit", type=float, metavar="GIB", help="refuse to need more")


def _generate(options):
    formats = list(dict.fromkeys(["npz", *options.format, *["section"] * bool(options.section)]))
    files.check_formats(formats)
    known = {info["name"] for info in _core.schema()["fields"]}
    for name in options.fields or ():
        if name not in known:
            raise _core.InputError(f"--fields: there is no field '{name}'")
    recipe = pipeline.Recipe.load(options.recipe, strict=options.strict)
    files.check_recipe(recipe, formats)
    section = _section_line(recipe, options, options.section)
    terrain = _terrain(recipe, options)
    report = files.save_terrain(
        terrain, options.output, formats, fields=options.fields, section=section
    )
    for warning in terrain.warnings:
        _warn(warning)
    if not files.can_draw():
        print("orogen: no previews without pillow: pip install 'orogen[files]'", file=sys.stderr)
    seconds = sum(report["seconds"].values())
    grid = report["grid"]
    print(f"{options.output}: {grid['nx']} x {grid['ny']} cells in {seconds:.1f} s")
    return 0


def _batch(options):
    """Everything is checked first; what is done already is left as it is."""
    begin = time.monotonic()
    formats = list(dict.fromkeys(["npz", *options.format]))
    jobs = _picked(batch.read_jobs(options.jobs), options.index)
    batch.check(jobs, formats)
    if options.processes < 1:
        raise _core.InputError(f"--jobs: {options.processes} is not allowed; 1 or more is wanted")
    bar = ProgressBar(sys.stderr)
    ended = batch.run_all(
        jobs, options.output, formats, options.threads, options.processes, bar.show
    )
    counts = {"made": 0, "there": 0, "failed": 0}
    try:
        for job, result in ended:
            bar.clear()
            counts[_tell(job, result)] += 1
    except (KeyboardInterrupt, _core.Cancelled):
        print("orogen: interrupted; the same command goes on from here", file=sys.stderr)
        return EXIT_INTERRUPTED
    seconds = time.monotonic() - begin
    print(
        f"{options.output}: {counts['made']} made, {counts['there']} already there, "
        f"{counts['failed']} failed, in {seconds:.1f} s"
    )
    return EXIT_INPUT if counts["failed"] else 0


def _picked(jobs, index):
    if index is None:
        return jobs
    if not 0 <= index < len(jobs):
        raise _core.InputError(
            f"--index: {index} is not allowed; there are {len(jobs)} jobs, from 0"
        )
    return [jobs[index]]


def _tell(job, result):
    """A line about a job that has ended; says what became of it."""
    if result is None:
        return "there"
    if isinstance(result, Exception):
        print(f"orogen: {job['name']}: {_one_line(result)}", file=sys.stderr)
        return "failed"
    for warning in result["warnings"]:
        _warn(f"{job['name']}: {warning}")
    print(f"{job['name']}: {sum(result['seconds'].values()):.1f} s", flush=True)  # for farms' logs
    return "made"


def _section(options):
    suffix = os.path.splitext(options.output)[1]
    if suffix not in rock_files.SECTION_SUFFIXES:
        raise _core.InputError(
            f"--output: '{suffix}' is not allowed; {', '.join(rock_files.SECTION_SUFFIXES)}"
        )
    recipe = pipeline.Recipe.load(options.recipe, strict=options.strict)
    rock_files.check_rocks(recipe)
    line = _section_line(recipe, options, options.line)
    terrain = _terrain(recipe, options)
    folder, name = os.path.split(os.path.abspath(options.output))
    with files.finished_folder(folder) as unfinished:
        file = os.path.join(unfinished, name)
        rock_files.write_section(terrain.rocks, line, file, terrain.grid.origin)
    return 0


def _section_line(recipe, options, ends):
    grid = recipe.grid(options.resolution)
    return rock_files.section_line(grid, ends and [ends[:2], ends[2:]])


def _terrain(recipe, options):
    limit = options.memory_limit
    bar = ProgressBar(sys.stderr)
    try:
        return pipeline.generate(
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
        "inputs": _inputs_info(document),
        "stages": document["stages"],
        "warnings": recipe.warnings,
    }


def _inputs_info(document):
    """What a recipe is made of, counted."""
    inputs = {}
    if "map" in document:
        inputs["features"] = len(document["map"]["features"])
    if "phases" in document:
        inputs["phases"] = len(document["phases"])
        inputs["plates"] = [len(phase["plates"]) for phase in document["phases"]]
    if "column" in document:
        column = document["column"]
        name = column.get("preset")
        layers = _core.strata.preset_column(name)["layers"] if name else column["layers"]
        inputs["layers"] = len(layers)
    if "rain" in document:
        inputs["rain"] = [len(document["rain"]), len(document["rain"][0])]
    for name, raster in document.get("rasters", {}).items():
        inputs[name] = [raster["rows"], raster["columns"]]
    if "fold_edits" in document:
        inputs["fold_edits"] = len(document["fold_edits"])
    return inputs


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
