"""GeoTIFF of one band, without a library: Blender's own Python has none for it.

Tags as in TIFF 6.0 and the notes on deflate and the floating-point predictor (Adobe 2002, 2005);
keys as in OGC GeoTIFF 1.1. All projections that maps may have (core/inputs/projection.h) have keys.
"""

import struct
import zlib
from xml.sax.saxutils import escape

import numpy as np

_STRIP = 1 << 19  # bytes before compression, about
_TYPES = {"H": 3, "I": 4, "d": 12, "s": 2}

# Projections: GeoTIFF's code of the method, and the key of each word of the PROJ string.
_OFFSET = {"x_0": 3082, "y_0": 3083}
_CENTRE = {"lon_0": 3088, "lat_0": 3089, **_OFFSET}
_NATURAL = {"lon_0": 3080, "lat_0": 3081, "k": 3092, **_OFFSET}
_PARALLELS = {"lat_1": 3078, "lat_2": 3079}
_METHODS = {
    "tmerc": (1, _NATURAL),
    "merc": (7, _NATURAL),
    "lcc": (
        8,
        {**_PARALLELS, "lon_0": 3084, "lat_0": 3085, "x_0": 3086, "y_0": 3087},
    ),
    "lcc with one parallel": (9, _NATURAL),
    "laea": (10, _CENTRE),
    "aea": (11, {**_PARALLELS, "lon_0": 3080, "lat_0": 3081, **_OFFSET}),
    "aeqd": (12, _CENTRE),
    "stere": (15, {"lon_0": 3095, "lat_0": 3081, "k": 3092, **_OFFSET}),
}
_ELLIPSOIDS = {  # name: code of the degrees on it, of the ellipsoid, its half axis, 1 / flattening
    "WGS84": (4326, 7030, 6378137.0, 298.257223563),
    "GRS80": (32767, 7019, 6378137.0, 298.257222101),
    "NAD83": (4269, 7019, 6378137.0, 298.257222101),
}


def write_geotiff(file, pixels, cell_size, west, north, projection="", name="", unit=""):
    """Writes an array (h, w) of float32 or int32, its first row the northern one.

    `west` and `north` are the outer sides in metres, `projection` is a PROJ string, if any; `name`
    and `unit` go along as GDAL's metadata.
    """
    height, width = pixels.shape
    real = pixels.dtype.kind == "f"
    rows = max(1, min(height, _STRIP // (4 * width)))
    strips = [_packed(pixels[r : r + rows], real) for r in range(0, height, rows)]
    keys, numbers = _geo_keys(projection)
    tags = {
        256: ("I", [width]),
        257: ("I", [height]),
        258: ("H", [32]),
        259: ("H", [8]),  # deflate
        262: ("H", [1]),
        277: ("H", [1]),
        278: ("I", [rows]),
        279: ("I", [len(strip) for strip in strips]),
        317: ("H", [3 if real else 2]),
        339: ("H", [3 if real else 2]),
        33550: ("d", [cell_size, cell_size, 0.0]),
        33922: ("d", [0.0, 0.0, 0.0, west, north, 0.0]),
        34735: ("H", keys),
        42112: ("s", _gdal_metadata(name, unit)),
    }
    if numbers:
        tags[34736] = ("d", numbers)
    with open(file, "wb") as stream:
        stream.write(bytes(8))
        places = []
        for strip in strips:
            places.append(stream.tell())
            stream.write(strip + bytes(len(strip) % 2))
        tags[273] = ("I", places)
        directory = _write_directory(stream, tags)
        stream.seek(0)
        stream.write(struct.pack("<2sHI", b"II", 42, directory))


def _packed(rows, real):
    """Rows predicted and deflated."""
    if real:  # bytes apart, the most significant first; then differences along a row
        parts = np.ascontiguousarray(rows, ">f4").view(np.uint8).reshape(*rows.shape, 4)
        flat = parts.transpose(0, 2, 1).reshape(len(rows), -1)
    else:
        flat = np.ascontiguousarray(rows, "<i4")
    steps = flat.copy()
    steps[:, 1:] -= flat[:, :-1]
    return zlib.compress(steps.tobytes(), 6)


def _write_directory(stream, tags):
    """Writes values that do not fit into the directory, and it; returns where it begins."""
    entries = []
    for tag, (kind, values) in sorted(tags.items()):
        data = values if kind == "s" else struct.pack(f"<{len(values)}{kind}", *values)
        if len(data) > 4:
            place = stream.tell()
            stream.write(data + bytes(len(data) % 2))
            data = struct.pack("<I", place)
        entries.append(struct.pack("<HHI4s", tag, _TYPES[kind], len(values), data))
    place = stream.tell()
    stream.write(struct.pack("<H", len(entries)) + b"".join(entries) + bytes(4))
    return place


def _gdal_metadata(name, unit):
    items = "".join(
        f'<Item name="{key}" sample="0" role="{key.lower()}">{escape(value)}</Item>'
        for key, value in (("DESCRIPTION", name), ("UNITTYPE", unit))
    )
    return f"<GDALMetadata>{items}</GDALMetadata>".encode() + b"\0"


def _geo_keys(projection):
    """The key directory and the numbers that it points to."""
    keys = {1025: 1}  # a pixel is an area
    if projection:
        keys |= _projection_keys(_words(projection))
    directory, numbers = [1, 1, 1, len(keys)], []
    for key, value in sorted(keys.items()):
        if isinstance(value, float):
            directory += [key, 34736, 1, len(numbers)]
            numbers.append(value)
        else:
            directory += [key, 0, 1, value]
    return directory, numbers


def _words(projection):
    words = {}
    for word in projection.split():
        key, _, value = word.removeprefix("+").partition("=")
        words[{"k_0": "k"}.get(key, key)] = value
    return words


def _projection_keys(words):
    keys = {1024: 1, 3076: 9001, **_ellipsoid_keys(words)}  # a plane, in metres
    method = words["proj"]
    if method == "utm":
        south = "south" in words
        words = {
            "lon_0": 6 * int(words["zone"]) - 183,
            "k": 0.9996,
            "x_0": 500_000,
            "y_0": 1e7 if south else 0,
        }
        method = "tmerc"
    elif method == "lcc":
        first = words.get("lat_1", words.get("lat_0"))
        second = words.get("lat_2", first)
        if second == first == words.get("lat_0", first):
            method, words = "lcc with one parallel", {**words, "lat_0": first}
        else:
            words = {"lat_0": 0, **words, "lat_1": first, "lat_2": second}
    elif method == "stere" and "lat_ts" in words:
        words = {**words, "lat_0": words["lat_ts"]}
    elif method == "aea":
        words = {"lat_2": words["lat_1"], **words}
    code, of_words = _METHODS[method]
    keys |= {3072: 32767, 3074: 32767, 3075: code}
    if method == "merc" and "lat_ts" in words:
        keys[3078] = float(words["lat_ts"])
        of_words = {k: v for k, v in of_words.items() if k != "k"}
    for word, key in of_words.items():
        keys[key] = float(words.get(word, 1.0 if word == "k" else 0.0))
    return keys


def _ellipsoid_keys(words):
    name = words.get("datum", words.get("ellps", "WGS84"))
    if "R" in words:
        return _own_ellipsoid(float(words["R"]), 0.0)
    if "a" in words:
        a = float(words["a"])
        if "b" in words:
            return _own_ellipsoid(a, (a - float(words["b"])) / a)
        flattening = float(words.get("f", 0.0))
        return _own_ellipsoid(a, 1.0 / float(words["rf"]) if "rf" in words else flattening)
    degrees, ellipsoid, a, inverse = _ELLIPSOIDS[name]
    keys = {2048: degrees, 2054: 9102}
    if degrees == 32767:
        keys |= {2050: 32767, 2056: ellipsoid, 2057: a, 2059: inverse}
    return keys


def _own_ellipsoid(a, flattening):
    keys = {2048: 32767, 2050: 32767, 2054: 9102, 2056: 32767, 2057: a}
    return {**keys, 2058: a * (1.0 - flattening)}
