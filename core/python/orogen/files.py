"""Files that a terrain is saved to.

Pictures, TIFF, EXR and PNG have row 0 in the north, as their readers expect; NPZ and VDB keep the
core's order (row 0 in the south). Everything is written into a folder beside and moved into place
at the end, the report last: no half-written file is ever left, and a folder with a report is whole.
"""

import contextlib
import importlib.util
import json
import os
import shutil
import signal
import tempfile
import threading
import typing

from . import _core, fold_files, rock_files

FORMATS = ("tif", "exr", "png16", "npz", "vdb", "section", "ply", "tin", "folds")
REPORT = "report.json"
UNFINISHED = ".orogen-"
FIELD_FORMATS = ("tif", "exr", "png16")  # a file for each field asked for
ROCK_FORMATS = ("section", "ply")  # which show the rocks below


def check_formats(formats):
    """InputError for a format that is unknown."""
    for name in formats:
        if name not in FORMATS:
            raise _core.InputError(f"format: there is no '{name}'; there are {', '.join(FORMATS)}")


def check_recipe(recipe, formats):
    """InputError for a format that terrains of the recipe cannot be written in."""
    if not set(ROCK_FORMATS).isdisjoint(formats):
        rock_files.check_rocks(recipe)
    if "tin" in formats:
        rock_files.check_tin(recipe)
    if "folds" in formats:
        fold_files.check_folds(recipe)


def can_draw():
    """Whether pictures can be written."""
    return importlib.util.find_spec("PIL") is not None


def check_fields(terrain, fields):
    for name in fields:
        if name not in terrain:
            raise _core.InputError(
                f"fields: the terrain has no '{name}'; it has {', '.join(terrain)}"
            )


class _Wanted(typing.NamedTuple):
    """What is to be shown, beside the format."""

    formats: tuple
    fields: tuple
    section: list  # its line


def save_terrain(terrain, folder, formats=("npz",), pictures=True, fields=None, section=None):
    """Writes a terrain into a folder, which is made if it is missing.

    Parameters
    ----------
    terrain : Terrain
    folder : path
    formats : sequence of str, optional
        npz: NAME.npz, every field by name, with `cell_size` and `origin`.
        tif: FIELD.tif, GeoTIFF of 32-bit floats with the map's projection.
        exr: FIELD.exr, one 32-bit float channel.
        png16: FIELD.png of 16 bits, with metres per unit and offset in FIELD.png.json.
        vdb: ground.vdb, the ground as a narrow-band level set in metres; with rocks below also
        rock.vdb, an index volume of them.
        section: section.svg and section.png, the rocks cut open along a line.
        ply: block.ply, the terrain with the rocks on its sides, and horizon_K.ply, the top of
        each layer K; with section also section.ply.
        tin: tin.ply, the triangles that mountains grew on, with their vertices' heights.
        folds: folds.geojson, crests and troughs of the layers that folded, as lines with ids.
    pictures : bool, optional
        Also preview.png, hillshade.png and, with rocks, strata.png (needs pillow).
    fields : sequence of str, optional
        What tif, exr and png16 are written of; default: elevation.
    section : [(x0, y0), (x1, y1)], optional
        Line of the section in metres; default: through the middle from south to north.

    Returns
    -------
    dict
        The report that was written as report.json.
    """
    check_formats(formats)
    if fields is None:
        fields = () if set(FIELD_FORMATS).isdisjoint(formats) else ("elevation",)
    check_fields(terrain, fields)
    check_recipe(terrain.recipe, formats)
    wanted = _Wanted(tuple(formats), fields, rock_files.section_line(terrain.grid, section))
    report = {**terrain.report, "formats": list(formats)}
    with finished_folder(folder) as unfinished:
        for name in formats:
            _WRITERS[name](terrain, unfinished, wanted)
        if pictures and can_draw():
            from .pictures import save_pictures

            save_pictures(terrain, unfinished)
        terrain.recipe.save(os.path.join(unfinished, f"{safe_name(terrain)}.orogen.json"))
        _write_json(os.path.join(unfinished, REPORT), report)
    return report


@contextlib.contextmanager
def finished_folder(folder):
    """A folder to write into, whose files move to `folder` only if all goes well."""
    folder = os.path.abspath(os.fspath(folder))
    if os.path.exists(folder) and not os.path.isdir(folder):
        raise _core.InputError(f"{folder}: is a file; a folder is wanted")
    existing = folder
    while not os.path.isdir(existing):
        existing = os.path.dirname(existing)
    try:
        unfinished = tempfile.mkdtemp(prefix=UNFINISHED, dir=existing)
    except OSError as error:
        raise _core.InputError(f"{folder}: cannot be written ({error.strerror})") from None
    try:
        yield unfinished
        with _uninterrupted():
            os.makedirs(folder, exist_ok=True)
            names = sorted(os.listdir(unfinished), key=lambda name: name == REPORT)
            if REPORT in names:
                with contextlib.suppress(FileNotFoundError):
                    os.remove(os.path.join(folder, REPORT))
            for name in names:
                os.replace(os.path.join(unfinished, name), os.path.join(folder, name))
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)


def remove_unfinished(folder):
    """Removes what a process that was killed while it wrote has left in `folder`."""
    for name in os.listdir(folder):
        if name.startswith(UNFINISHED):
            shutil.rmtree(os.path.join(folder, name), ignore_errors=True)


@contextlib.contextmanager
def _uninterrupted():
    """Ctrl-C does not count: files that are complete are moved into place all or not at all."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before or signal.SIG_DFL)


def safe_name(terrain):
    name = "".join(c if c.isalnum() or c in "-_." else "_" for c in terrain.name).strip(".")
    return name or "terrain"


def _write_json(file, document):
    with open(file, "w", encoding="utf-8", newline="\n") as stream:
        json.dump(document, stream, indent=1)
        stream.write("\n")


def _write_npz(terrain, folder, _wanted):
    import numpy

    grid = terrain.grid
    arrays = {name: terrain[name] for name in terrain}
    file = os.path.join(folder, f"{safe_name(terrain)}.npz")
    numpy.savez_compressed(file, cell_size=grid.cell_size, origin=grid.origin, **arrays)


def _write_tif(terrain, folder, wanted):
    from .geotiff import write_geotiff

    grid = terrain.grid
    west, north = grid.origin[0], grid.origin[1] + grid.ny * grid.cell_size
    for name in wanted.fields:
        write_geotiff(
            os.path.join(folder, f"{name}.tif"),
            terrain[name][::-1],
            grid.cell_size,
            west,
            north,
            terrain.recipe.projection,
            name,
            _field_infos()[name]["unit"],
        )


def _write_exr(terrain, folder, wanted):
    from .image_files import write_exr

    for name in wanted.fields:
        write_exr(os.path.join(folder, f"{name}.exr"), terrain[name][::-1])


def _write_png16(terrain, folder, wanted):
    import numpy

    from .image_files import write_png

    for name in wanted.fields:
        array = terrain[name]
        info = _field_infos()[name]
        low, high = float(array.min()), float(array.max())
        step = (high - low) / 65535 if info["type"] == "float32" and high > low else 1.0
        pixels = numpy.rint((array[::-1].astype(numpy.float64) - low) / step).astype(numpy.uint16)
        file = os.path.join(folder, f"{name}.png")
        write_png(file, pixels)
        unit = info["unit"]
        scale = {"metres_per_unit" if unit == "m" else "value_per_unit": step, "offset": low}
        _write_json(file + ".json", {"field": name, "unit": unit, **scale})


def _write_vdb(terrain, folder, _wanted):
    terrain._core.write_ground(os.path.join(folder, "ground.vdb"), 0)
    if terrain.rocks:
        terrain.rocks.write_volume(os.path.join(folder, "rock.vdb"))


def _write_section(terrain, folder, wanted):
    for suffix in (".svg", ".png", ".ply") if "ply" in wanted.formats else (".svg", ".png"):
        file = os.path.join(folder, "section" + suffix)
        rock_files.write_section(terrain.rocks, wanted.section, file, terrain.grid.origin)


def _write_ply(terrain, folder, _wanted):
    rocks, origin = terrain.rocks, terrain.grid.origin
    rock_files.write_ply(os.path.join(folder, "block.ply"), rocks.block_diagram(), origin)
    for k in range(len(rocks.horizons)):
        file = os.path.join(folder, f"horizon_{k}.ply")
        rock_files.write_ply(file, rocks.horizon_mesh(k), origin)


def _write_tin(terrain, folder, _wanted):
    rock_files.write_tin(os.path.join(folder, "tin.ply"), terrain.tin, terrain.grid.origin)


def _write_folds(terrain, folder, _wanted):
    fold_files.write_folds(os.path.join(folder, "folds.geojson"), terrain)


def _field_infos():
    return {info["name"]: info for info in _core.schema()["fields"]}


_WRITERS = {
    "tif": _write_tif,
    "exr": _write_exr,
    "png16": _write_png16,
    "npz": _write_npz,
    "vdb": _write_vdb,
    "section": _write_section,
    "ply": _write_ply,
    "tin": _write_tin,
    "folds": _write_folds,
}
