"""The ground beyond a terrain's frame, as far as the eye reaches: what its border is like goes on,
and fades into a plain, or into the floor of the sea. A child of the terrain that follows it."""

import bpy
import numpy as np

from . import children, grid_mesh
from . import ground as grounds
from .roles import with_role

ROLE = "surroundings"
RINGS = 1.0 + np.array([0, 0.01, 0.025, 0.05, 0.09, 0.15, 0.25, 0.4, 0.7, 1.5, 4, 12, 60, 300.0])
FADE = 0.25  # of the frame's half size: over so much the border's heights fade


def of(terrain):
    return next(iter(with_role(terrain, ROLE)), None)


def reach(terrain):
    """How many times as large as the frame they make the ground."""
    return RINGS[-1] if of(terrain) else 1.0


def add(terrain):
    children.renew(terrain, ROLE, [ROLE], bpy.data.meshes.new)
    update(terrain)


def update(terrain):
    """Lets them fit the terrain's ground as it is, where there are any."""
    ob = of(terrain)
    if ob is None:
        return
    border = _border(terrain.data)
    rings = np.stack([_ring(border, scale) for scale in RINGS])
    nx, ny = len(border), len(RINGS)
    if not grid_mesh.has_topology(ob.data, nx, ny):
        grid_mesh.build_topology(ob.data, nx, ny)
    grid_mesh.set_positions(ob.data, rings)
    grounds.dress(ob, terrain)


def _border(mesh):
    """Its vertices' positions against the clock, the first one again at the end."""
    nx, ny = mesh["orogen_grid"]
    points = np.empty((ny, nx, 3), np.float32)
    mesh.attributes["position"].data.foreach_get("vector", points.ravel())
    sides = points[0, :-1], points[:-1, -1], points[-1, :0:-1], points[:0:-1, 0]
    loop = np.concatenate(sides)
    return np.concatenate([loop, loop[:1]])


def _ring(border, scale):
    """The border, `scale` times as large, the smoother and flatter the farther out."""
    middle = 0.5 * (border[:, :2].min(axis=0) + border[:, :2].max(axis=0))
    ring = border.copy()
    ring[:, :2] = middle + scale * (border[:, :2] - middle)
    heights = border[:-1, 2]
    smooth = _smooth(heights, 0.5 * (scale - 1.0))
    share = np.exp(-(((scale - 1.0) / FADE) ** 2))
    ring[:-1, 2] = share * smooth + (1.0 - share) * np.median(heights)
    ring[-1, 2] = ring[0, 2]
    return ring


def _smooth(loop, width):
    """A closed line of numbers under a Gaussian, `width` of its length wide."""
    waves = np.fft.rfftfreq(len(loop), 1.0 / len(loop))
    return np.fft.irfft(np.fft.rfft(loop) * np.exp(-2.0 * (np.pi * width * waves) ** 2), len(loop))
