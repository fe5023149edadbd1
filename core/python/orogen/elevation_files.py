"""Elevation models from files, as ground to start from: GeoTIFF, SRTM's .hgt, .npy and 16-bit PNG.

Values are metres. Of a file in degrees the size is taken along its middle parallel; of one without
a place on Earth a cell counts as `DEFAULT_CELL` metres.
"""

import math
import os
from dataclasses import dataclass

from . import _core

DEFAULT_CELL = 30.0  # m
METRES_PER_DEGREE = 111_195.0  # of a great circle
SUFFIXES = (".tif", ".tiff", ".hgt", ".npy", ".png")
_LEAST, _MOST = -12e3, 12e3  # m; beyond lie the numbers that files write where they know nothing
_SRTM_VOID = -32768


@dataclass
class Elevation:
    """Heights (rows, columns) in metres, row 0 in the south, and where they lie."""

    values: object
    size: tuple  # m, east and north
    origin: tuple = (0.0, 0.0)  # m, lower-left corner in the file's own projection


def read_elevation(file):
    """The heights of a file. Cells that it knows nothing of take the nearest known height.

    Raises
    ------
    InputError
        The file cannot be read, holds no heights, or needs a library that is not installed.
    """
    suffix = os.path.splitext(file)[1].lower()
    if suffix not in SUFFIXES:
        raise _core.InputError(f"{file}: '{suffix}' is no elevation; {', '.join(SUFFIXES)} are")
    try:
        values, cell, origin = _READERS[suffix](file)
    except OSError as error:
        raise _core.InputError(f"{file}: {error.strerror or error}") from None
    except _core.InputError:
        raise
    except Exception as error:  # whatever a library says of a broken file
        raise _core.InputError(f"{file}: {error}") from None
    if values.ndim != 2 or min(values.shape) < 2:
        raise _core.InputError(f"{file}: rows and columns of heights are wanted")
    values = _without_gaps(file, values[::-1])
    rows, columns = values.shape
    return Elevation(values, (columns * cell[0], rows * cell[1]), origin)


def elevation_recipe(file):
    """A recipe that starts from the heights of a file, a cell of it a cell, as a dictionary."""
    name = os.path.basename(file).split(".")[0]
    document = {"orogen": 1, "name": name, "rasters": {"elevation": {"file": file}}}
    document = with_files_read(document, "")
    packed = document["rasters"]["elevation"]
    return {**document, "resolution": max(packed["rows"], packed["columns"])}


def with_files_read(document, folder, read=read_elevation):
    """A recipe's dictionary in which rasters that name a file, beside the recipe or anywhere, hold
    its values. Without an extent, the terrain lies where the file of `elevation` does. `read` gives
    the Elevation in a file."""
    from .pipeline import pack_raster

    rasters = document.get("rasters") if isinstance(document, dict) else None
    if not isinstance(rasters, dict):
        return document
    document = {**document, "rasters": dict(rasters)}
    for name, raster in rasters.items():
        if not isinstance(raster, dict) or not isinstance(raster.get("file"), str):
            continue
        found = read(os.path.join(folder, raster["file"]))
        document["rasters"][name] = pack_raster(found.values)
        if name == "elevation" and "extent" not in document and "map" not in document:
            document["extent"] = {"origin": list(found.origin), "size": list(found.size)}
    return document


def _read_tiff(file):
    import numpy
    import tifffile

    with tifffile.TiffFile(file) as tiff:
        page = tiff.pages[0]
        values = numpy.asarray(page.asarray(), numpy.float32)
        tags = page.geotiff_tags or {}
        nothing = page.tags.get("GDAL_NODATA")
    if nothing is not None:
        values[values == numpy.float32(str(nothing.value).strip("\0 "))] = numpy.nan
    scale = tags.get("ModelPixelScale")
    if scale is None:
        return values, (DEFAULT_CELL, DEFAULT_CELL), (0.0, 0.0)
    column, row, _, x, y = tags.get("ModelTiepoint", [0.0] * 6)[:5]
    west = x - column * scale[0]
    south = y - (values.shape[0] - row) * scale[1]
    if "GeographicTypeGeoKey" in tags and "ProjectedCSTypeGeoKey" not in tags:
        return values, _degrees(scale, south + 0.5 * values.shape[0] * scale[1]), (0.0, 0.0)
    return values, (scale[0], scale[1]), (west, south)


def _read_hgt(file):
    import numpy

    values = numpy.fromfile(file, ">i2").astype(numpy.float32)
    side = math.isqrt(len(values))
    if side * side != len(values):
        raise _core.InputError(f"{file}: {len(values)} heights are no square")
    values[values == _SRTM_VOID] = numpy.nan
    name = os.path.basename(file)
    try:
        south = float(name[1:3]) * (-1 if name[0] in "sS" else 1)
    except ValueError:
        south = 0.0
    cell = 1.0 / (side - 1)
    return values.reshape(side, side), _degrees((cell, cell), south + 0.5), (0.0, 0.0)


def _read_npy(file):
    import numpy

    values = numpy.load(file, allow_pickle=False).astype(numpy.float32)
    return values[::-1], (DEFAULT_CELL, DEFAULT_CELL), (0.0, 0.0)  # they come from the south


def _read_png(file):
    import numpy

    try:
        from PIL import Image
    except ImportError:
        raise _core.InputError(f"{file}: PNG needs the package pillow: pip install it") from None
    with Image.open(file) as image:
        values = numpy.asarray(image, numpy.float32)
    return values, (DEFAULT_CELL, DEFAULT_CELL), (0.0, 0.0)


_READERS = {
    ".tif": _read_tiff,
    ".tiff": _read_tiff,
    ".hgt": _read_hgt,
    ".npy": _read_npy,
    ".png": _read_png,
}


def _degrees(scale, latitude):
    """A cell's size in metres."""
    parallel = math.cos(math.radians(latitude))
    return scale[0] * METRES_PER_DEGREE * parallel, scale[1] * METRES_PER_DEGREE


def _without_gaps(file, values):
    import numpy

    known = (values >= _LEAST) & (values <= _MOST)  # false for what is no number
    if not known.any():
        raise _core.InputError(f"{file}: holds no heights in metres")
    if known.all():
        return numpy.ascontiguousarray(values)
    return numpy.ascontiguousarray(values[_nearest(known)])


def _nearest(known):
    """Row and column of a known cell near to each: along its row, else in the nearest row."""
    import numpy

    rows, columns = known.shape
    full = numpy.flatnonzero(known.any(axis=1))
    row = full[numpy.abs(numpy.arange(rows)[:, None] - full).argmin(axis=1)]
    index = numpy.arange(columns)
    west = numpy.maximum.accumulate(numpy.where(known[row], index, -columns), axis=1)
    east = numpy.where(known[row], index, 2 * columns)
    east = numpy.minimum.accumulate(east[:, ::-1], axis=1)[:, ::-1]
    return row[:, None], numpy.where(index - west <= east - index, west, east)
