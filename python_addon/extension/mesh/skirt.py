"""Faces of a grid, of walls below its rim, and of a floor. No bpy here."""

import numpy as np


def quads(nx, ny):
    """(m, 4) vertices of a grid's faces, seen from above anticlockwise."""
    corners = np.arange(nx * ny).reshape(ny, nx)
    sides = (corners[:-1, :-1], corners[:-1, 1:], corners[1:, 1:], corners[1:, :-1])
    return np.stack(sides, axis=-1).reshape(-1, 4)


def rim(nx, ny):
    """The vertices around a grid, anticlockwise, each once."""
    corners = np.arange(nx * ny).reshape(ny, nx)
    sides = (corners[0, :-1], corners[:-1, -1], corners[-1, :0:-1], corners[:0:-1, 0])
    return np.concatenate(sides)


def walls(rim, first_foot):
    """(k, 4) from the rim down to its feet, which are numbered from `first_foot` on."""
    feet = first_foot + np.arange(len(rim))
    return np.stack([feet, np.roll(feet, -1), np.roll(rim, -1), rim], axis=-1)


def floor(count, first_foot):
    """One face (1, k) over all feet, seen from below."""
    return first_foot + np.arange(count)[None, ::-1]
