"""PNG and OpenEXR of one array, without a library: Blender's own Python has none for them.

Rows are written in the order given, the first at the top.
"""

import itertools
import struct
import zlib

import numpy as np


def write_png(file, pixels):
    """Writes (h, w) of uint8 or uint16, or RGBA as (h, w, 4) of uint8."""
    height, width = pixels.shape[:2]
    depth = 8 * pixels.dtype.itemsize
    rows = np.ascontiguousarray(pixels, pixels.dtype.newbyteorder(">"))
    rows = rows.view(np.uint8).reshape(height, -1)
    filtered = np.full((height, 1 + rows.shape[1]), 2, np.uint8)  # filter 2: less the row above
    filtered[0, 1:] = rows[0]
    filtered[1:, 1:] = rows[1:] - rows[:-1]
    kind = 6 if pixels.ndim == 3 else 0
    header = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0)
    with open(file, "wb") as stream:
        stream.write(b"\x89PNG\r\n\x1a\n")
        for name, data in (
            (b"IHDR", header),
            (b"IDAT", zlib.compress(filtered.tobytes(), 6)),
            (b"IEND", b""),
        ):
            stream.write(struct.pack(">I", len(data)) + name + data)
            stream.write(struct.pack(">I", zlib.crc32(name + data)))


_EXR_BLOCK = 16  # rows that are compressed together


def write_exr(file, pixels):
    """Writes (h, w) as one channel Y of 32-bit floats, ZIP-compressed."""
    pixels = np.ascontiguousarray(pixels, "<f4")
    height, width = pixels.shape
    header = _exr_header(width, height)
    blocks = [
        struct.pack("<ii", row, len(data)) + data
        for row in range(0, height, _EXR_BLOCK)
        for data in [_exr_block(pixels[row : row + _EXR_BLOCK])]
    ]
    first = len(header) + 8 * len(blocks)
    places = itertools.accumulate(map(len, blocks[:-1]), initial=first)
    with open(file, "wb") as stream:
        stream.write(header)
        stream.write(struct.pack(f"<{len(blocks)}Q", *places))
        stream.writelines(blocks)


def _exr_header(width, height):
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"Y\0" + struct.pack("<iB3xii", 2, 0, 1, 1) + b"\0"  # 2: float
    attributes = (
        ("channels", "chlist", channels),
        ("compression", "compression", b"\3"),  # ZIP
        ("dataWindow", "box2i", window),
        ("displayWindow", "box2i", window),
        ("lineOrder", "lineOrder", b"\0"),
        ("pixelAspectRatio", "float", struct.pack("<f", 1.0)),
        ("screenWindowCenter", "v2f", bytes(8)),
        ("screenWindowWidth", "float", struct.pack("<f", 1.0)),
    )
    parts = [struct.pack("<ii", 20000630, 2)]
    for name, kind, value in attributes:
        parts.append(f"{name}\0{kind}\0".encode() + struct.pack("<i", len(value)) + value)
    return b"".join([*parts, b"\0"])


def _exr_block(rows):
    raw = rows.view(np.uint8).ravel()
    halves = np.concatenate([raw[0::2], raw[1::2]])
    steps = halves.copy()
    steps[1:] = halves[1:] - halves[:-1] + np.uint8(128)
    data = zlib.compress(steps.tobytes(), 6)
    return data if len(data) < raw.size else raw.tobytes()
