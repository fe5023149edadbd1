"""GeoTIFF of one band. tifffile writes the file; what says where on Earth it lies is put together
here, as Blender's own Python can have no GDAL.

Keys as in OGC GeoTIFF 1.1. All projections that maps may have (core/inputs/projection.h) have keys.
"""

from xml.sax.saxutils import escape

_STRIP = 1 << 19  # bytes before compression, about

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
    import tifffile

    keys, numbers = _geo_keys(projection)
    tags = [
        (33550, "d", 3, (cell_size, cell_size, 0.0)),
        (33922, "d", 6, (0.0, 0.0, 0.0, west, north, 0.0)),
        (34735, "H", len(keys), keys),
        (42112, "s", 0, _gdal_metadata(name, unit)),
    ]
    if numbers:
        tags.append((34736, "d", len(numbers), numbers))
    tifffile.imwrite(
        file,
        pixels,
        photometric="minisblack",
        compression="zlib",
        rowsperstrip=max(1, min(pixels.shape[0], _STRIP // (4 * pixels.shape[1]))),
        metadata=None,
        software=False,
        extratags=[(*tag, True) for tag in tags],
    )


def _gdal_metadata(name, unit):
    items = "".join(
        f'<Item name="{key}" sample="0" role="{key.lower()}">{escape(value)}</Item>'
        for key, value in (("DESCRIPTION", name), ("UNITTYPE", unit))
    )
    return f"<GDALMetadata>{items}</GDALMetadata>"


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
