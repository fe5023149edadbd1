"""The growth of a terrain as an animation that plays without the extension.

Frames go into a point cache (.pc2) that a Mesh Cache modifier of Blender's own reads: at any time
two of them are in memory, and the .blend holds none (docs/blender_animation.md says more).
"""

import os
import struct
from pathlib import Path

import numpy as np

from . import attributes, grid_mesh, paths

MODIFIER = "Orogen Growth"
YEARS = "orogen_years"  # custom property of the terrain, keyed: years since growth began
KEYS = "orogen_years_keys"  # the scene's frames of those keys
SUFFIX = ".pc2"
_HEADER = struct.Struct("<12siiffi")  # magic, version, points, start, sampling, samples


class NoAnimation(ValueError):
    """The frames are not those of the terrain; the message says why."""


def write(ob, frames, file, start=1, step=1):
    """Writes the cache and lets the terrain play it.

    `frames`: an iterable of (years, elevation (ny, nx) in metres), the last one being the terrain
    as it is; only one is held at a time. Frame i plays at the scene's frame `start + i * step`;
    between, Blender interpolates. Returns the scene's frame of the last. Where it raises
    NoAnimation or OSError, nothing has changed.
    """
    partial = Path(f"{file}.part")
    try:
        years = _write_cache(ob, frames, partial, start)
        os.replace(partial, file)
    finally:
        partial.unlink(missing_ok=True)
    remove(ob)
    _add_modifier(ob, file, start, step)
    keys = [start + i * step for i in range(len(years))]
    for frame, value in zip(keys, years, strict=True):
        ob[YEARS] = float(value)
        ob.keyframe_insert(f'["{YEARS}"]', frame=frame)
    ob[KEYS] = keys
    return keys[-1]


def ending_in(frames, still):
    """Frames that end in the terrain itself. What the core adds to the grown ground afterwards (the
    detail of rock on slopes) comes in by and by, in proportion to the years."""
    frames = list(frames)  # views of the worker's file: they take no memory
    end, grown = frames[-1]
    detail = still - grown
    for years, elevation in frames[:-1]:
        yield years, elevation + np.float32(years / end) * detail
    yield end, still


def remove(ob):
    """Takes the animation off; its file stays. Returns whether there was one."""
    modifier = ob.modifiers.get(MODIFIER)
    if modifier is None:
        return False
    ob.modifiers.remove(modifier)
    for frame in ob.pop(KEYS, ()):
        ob.keyframe_delete(f'["{YEARS}"]', frame=frame)
    ob.pop(YEARS, None)
    return True


def _write_cache(ob, frames, file, start):
    mesh = ob.data
    nx, ny = mesh["orogen_grid"]
    grid, offset = {"cell_size": mesh["orogen_cell_size"]}, mesh["orogen_offset"]
    scale = ob.orogen.local_scale()
    still = attributes.read(mesh, "elevation", (ny, nx))
    years, elevation = [], None
    with open(file, "wb") as stream:
        stream.write(bytes(_HEADER.size))
        for when, elevation in frames:
            elevation = np.asarray(elevation, np.float32)
            if elevation.shape != (ny, nx):
                raise NoAnimation(
                    f"frames[{len(years)}]: has the shape {elevation.shape}; {(ny, nx)} is wanted"
                )
            stream.write(grid_mesh.positions(grid, offset, elevation, scale).data)
            years.append(when)
        stream.seek(0)
        stream.write(_HEADER.pack(b"POINTCACHE2\0", 1, nx * ny, start, 1.0, len(years)))
    if elevation is None or not np.array_equal(elevation, still):
        raise NoAnimation("The last frame is not the terrain as it is")
    return years


def _add_modifier(ob, file, start, step):
    modifier = ob.modifiers.new(MODIFIER, "MESH_CACHE")
    ob.modifiers.move(len(ob.modifiers) - 1, 0)  # it replaces the mesh's own vertices
    modifier.cache_format = "PC2"
    modifier.filepath = paths.relative(file)
    # The cache's frame is scale * scene frame - start. A hair more than that: rounding must not
    # fall short of the last frame, which is the terrain to the last bit.
    modifier.frame_scale = 1.0 / step
    modifier.frame_start = start / step - (0.0 if step == 1 else 1e-4)
