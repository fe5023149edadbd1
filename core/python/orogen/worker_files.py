"""Pictures and files that a worker makes of a terrain.

A file that a host asks for is written beside its place and moved there when it is complete.
"""

import os
import tempfile

import numpy as np

from . import _core, files, rock_files


def rocks_of(terrain):
    if terrain.rocks is None:
        raise _core.InputError("column: the recipe has none, so there are no rocks to show")
    return terrain.rocks


def section_of(terrain, request):
    line = [tuple(place) for place in request["line"]]
    return rocks_of(terrain).section(line, base=request.get("base"))


def picture(terrain, request):
    """A section as a picture: `pixels` (h, w, 4), its upper row first, transparent above ground;
    `extent`: its length and height in metres."""
    section = section_of(terrain, request)
    height = float(section.surface.max()) - section.base
    pixels = section.picture(*rock_files.picture_size(section))
    extent = np.array([section.distance[-1], height], np.float64)
    return {"picture": {"pixels": pixels, "extent": extent}}


def section_file(terrain, request):
    """Writes a section to `file`, by its suffix .svg, .png or .ply."""
    line = [tuple(place) for place in request["line"]]
    file = request["file"]
    suffix = os.path.splitext(file)[1].lower()
    if suffix not in rock_files.SECTION_SUFFIXES:
        raise _core.InputError(
            f"file: '{suffix}' is not allowed; {', '.join(rock_files.SECTION_SUFFIXES)} are"
        )
    with _beside(file) as folder:
        part = os.path.join(folder, "section" + suffix)
        rock_files.write_section(rocks_of(terrain), line, part, terrain.grid.origin)
        os.replace(part, file)
    return {}


def volume(terrain, request):
    """Writes the rocks as an index volume to `file`."""
    rocks, file = rocks_of(terrain), request["file"]
    with _beside(file) as folder:
        part = os.path.join(folder, "rock.vdb")
        rocks.write_volume(part, voxel_height=request["voxel_height"])
        os.replace(part, file)
    return {}


def save(terrain, request):
    """Writes the terrain to `file`, in one of files.FORMATS; of a `field` where a format holds one.

    What `save_terrain` writes beside (a PNG's scale) stands beside.
    """
    name, file, field = request["format"], request["file"], request.get("field")
    fields = [field] if name in files.FIELD_FORMATS else None
    with _beside(file) as folder:
        files.save_terrain(terrain, folder, [name], pictures=False, fields=fields)
        written = _WRITTEN[name].format(field=field, name=files.safe_name(terrain))
        for suffix in ("", ".json"):
            part = os.path.join(folder, written + suffix)
            if os.path.exists(part):
                os.replace(part, file + suffix)
    return {}


_WRITTEN = {
    "tif": "{field}.tif",
    "exr": "{field}.exr",
    "png16": "{field}.png",
    "npz": "{name}.npz",
    "vdb": "ground.vdb",
    "tin": "tin.ply",
    "ply": "block.ply",
    "folds": "folds.geojson",
}


def _beside(file):
    """A folder on the drive where the file is to be."""
    try:
        return tempfile.TemporaryDirectory(prefix=".orogen-", dir=os.path.dirname(file))
    except OSError as error:
        raise _core.InputError(f"{file}: cannot be written ({error.strerror})") from None
