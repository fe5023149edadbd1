"""The polygons of the active terrain's island over its ground: in the colours of their biomes, with
their sides, rivers, and which way water goes."""

import bpy
import numpy as np

from .. import terrains
from ..declarations import BIOMES
from ..live import loop
from ..live.polygons import is_wanted
from ..mesh import colors, middle, terrain_mesh
from ..mesh.relief import Relief
from ..scene.plane import Plane
from . import lines

FILL = 0.5  # opacity
SIDE, RIVER, DOWN = (0.03, 0.03, 0.03, 0.35), (0.10, 0.42, 0.95, 1.0), (0.10, 0.30, 0.80, 0.75)
THIN, WIDE = 1.0, 2.5
PIECES = 3  # of a side, to lie on the ground
_shown = {}  # what was drawn last: the key, and what draws it


def draw():
    context = bpy.context
    terrain, shown = terrains.active(context), loop.polygons_shown()
    if terrain not in lines.shown_terrains(context) or not is_wanted(terrain):
        return
    if not shown or shown[1] is None or shown[0][0] != terrain.session_uid:
        return
    with_down = terrain.orogen.input.show_downslopes
    key = (shown[0], terrain_mesh.grown_from(terrain), Plane(terrain).key, with_down)
    if _shown.get("key") != key:
        _shown.update(key=key, parts=list(make(terrain, shown[1], with_down)))
    for part in _shown["parts"]:
        part()


def make(terrain, found, with_down):
    lay = Draped(terrain)
    corners, centers = (np.array(found[name]) for name in ("corners", "centers"))
    yield lines.Triangles(*fill(lay, corners, centers, found["rings"], found["biomes"]))
    yield lines.Lines(lay.pairs(corners, found["edges"]), SIDE, THIN)
    rivers = np.reshape(found["rivers"], (-1, 3)).astype(int)
    yield lines.Lines(lay.pairs(corners, rivers[:, :2]), RIVER, WIDE)
    if with_down:
        yield lines.Lines(lay.pairs(corners, found["downslopes"]), DOWN, THIN)


def fill(lay, corners, centers, rings, biomes):
    """Triangles from each center to its corners, and their colours."""
    sides = [len(ring) for ring in rings]
    of_center = np.repeat(np.arange(len(rings)), sides)
    first = np.concatenate([ring for ring in rings]).astype(int)
    second = np.concatenate([np.roll(ring, -1) for ring in rings]).astype(int)
    places = np.stack([centers[of_center], corners[first], corners[second]], axis=1)
    rgb = colors.unpack(np.array([biome.color for biome in BIOMES])[np.array(biomes)])
    rgba = np.column_stack([rgb / 255.0, np.full(len(rgb), FILL)])
    return lay(places.reshape(-1, 2)), np.repeat(rgba[of_center], 3, axis=0)


class Draped:
    """Puts places of the island on the ground, in the world."""

    def __init__(self, terrain):
        self._plane, self._relief = Plane(terrain), Relief(terrain)
        self._shift = middle.shift(terrain) or (0.0, 0.0)

    def __call__(self, places):
        places = places - self._shift
        return self._plane.places(np.column_stack([places, self._relief.at(places)]))

    def pairs(self, corners, ends):
        """Lines between pairs of corners, in pieces that lie on the ground."""
        ends = np.reshape(ends, (-1, 2)).astype(int)
        a, b = corners[ends[:, 0]], corners[ends[:, 1]]
        at = np.linspace(0.0, 1.0, PIECES + 1)[:, None, None]
        points = a + at * (b - a)  # (PIECES + 1, n, 2)
        pieces = np.stack([points[:-1], points[1:]], axis=2)  # (PIECES, n, 2, 2)
        return self(pieces.reshape(-1, 2))


def forget():
    _shown.clear()
