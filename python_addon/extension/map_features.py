"""From plain points in metres to a GeoJSON map. No bpy here.

Points are arrays (n, 2): metres east and north. The map written has `units` "m" and a `frame`, and
its numbers count from the frame's lower-left corner.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from .join_lines import join
from .problems import Problem

MARGIN = 0.06  # of the longer side: sea kept around the drawing
SHORTEST_STEP = 1e-5  # of the longer side: nearer points are one point


class NothingDrawn(ValueError):
    """There is nothing on the map from which a terrain could grow."""


@dataclass
class Peak:
    position: tuple[float, float]  # m
    height: float | None  # m
    name: str = ""
    volcano: bool = False


@dataclass
class Drawing:
    coasts: list = field(default_factory=list)  # rings
    rivers: list = field(default_factory=list)  # lines
    lakes: list = field(default_factory=list)  # rings
    peaks: list = field(default_factory=list)
    problems: list = field(default_factory=list)


def close_coasts(drawing, lines, tolerance):
    """Adds to the coasts the rings of open lines. Gaps wider than a share `tolerance` of the longer
    side of all coasts are told as problems."""
    if not lines:
        return
    points = np.concatenate([*drawing.coasts, *lines])
    joined = join(lines, tolerance * np.ptp(points, axis=0).max())
    drawing.coasts += joined.rings
    for (x, y), (u, v) in joined.gaps:
        text = f"The coast is open: a gap of {math.hypot(u - x, v - y) / 1000:.1f} km, now straight"
        drawing.problems.append(Problem(text, (0.5 * (x + u), 0.5 * (y + v))))


def to_geojson(drawing, name="drawing", frame_size=None):
    """The drawing as a GeoJSON collection, a dict. `frame_size` (m) lays the mapped rectangle
    around (0, 0); else it is the drawing's, and a margin."""
    lower, size = frame_of(drawing, frame_size)
    step = SHORTEST_STEP * size.max()
    features = [_coast(rings, lower, size) for rings in nest(_rings(drawing.coasts, step))]
    features += [
        _feature("lake", "Polygon", [_closed(ring, lower)]) for ring in _rings(drawing.lakes, step)
    ]
    features += [
        _feature("river", "LineString", _listed(line, lower))
        for line in (thin(line, step) for line in drawing.rivers)
        if len(line) > 1
    ]
    for peak in drawing.peaks:
        position = _listed([peak.position], lower)[0]
        said = {"name": peak.name}
        if peak.height is not None:
            said["height_m"] = round(float(peak.height), 2)
        if peak.volcano:
            said["volcano"] = True
        features.append(_feature("peak", "Point", position, **said))
    return {
        "type": "FeatureCollection",
        "name": name,
        "units": "m",
        "frame": {"origin_m": lower.tolist(), "size_km": (size / 1000.0).tolist()},
        "features": features,
    }


def frame_of(drawing, frame_size=None):
    """Lower-left corner and size (m) of the mapped rectangle: a frame around (0, 0), or the drawing
    and a margin of sea."""
    parts = [*drawing.coasts, *drawing.rivers, *drawing.lakes]
    parts += [[peak.position] for peak in drawing.peaks]
    if not parts:
        raise NothingDrawn(
            "Nothing is drawn: a grease-pencil layer named Coast or Rivers, or an empty as a peak"
        )
    if frame_size is not None:
        size = np.array(frame_size, float)
        return -0.5 * size, size
    points = np.concatenate([np.asarray(part, float).reshape(-1, 2) for part in parts])
    lower, upper = points.min(axis=0), points.max(axis=0)
    longest = (upper - lower).max()
    if not longest > 0:
        raise NothingDrawn("The drawing has no extent: draw a coast, or more than one peak")
    margin = MARGIN * longest if drawing.coasts else 0.15 * longest
    lower, upper = np.floor(lower - margin), np.ceil(upper + margin)
    return lower, upper - lower


def thin(line, step):
    """The line without points that lie nearer than `step` to the one before."""
    points = np.asarray(line, float).reshape(-1, 2).tolist()
    kept = points[:1]
    for point in points[1:]:
        if math.dist(point, kept[-1]) > step:
            kept.append(point)
    return np.array(kept).reshape(-1, 2)


def _rings(lines, step):
    rings = [thin(line, step) for line in lines]
    rings = [r[:-1] if len(r) > 1 and np.hypot(*(r[-1] - r[0])) <= step else r for r in rings]
    return [ring for ring in rings if len(ring) > 2]


def nest(rings):
    """Groups rings into polygons: a ring inside an odd number of others is a hole of the smallest
    that holds it; the rest are islands."""
    holders = [
        [j for j, other in enumerate(rings) if j != i and contains(other, ring[0])]
        for i, ring in enumerate(rings)
    ]
    polygons = {i: [ring] for i, ring in enumerate(rings) if len(holders[i]) % 2 == 0}
    for i, ring in enumerate(rings):
        if i not in polygons:
            polygons[max(holders[i], key=lambda j: len(holders[j]))].append(ring)
    return list(polygons.values())


def contains(ring, point):
    """Whether a point lies inside a ring (even-odd rule)."""
    x, y = point
    ax, ay = ring.T
    bx, by = np.roll(ring, -1, axis=0).T
    crosses = (ay > y) != (by > y)
    rise = np.where(crosses, by - ay, 1.0)
    return bool(np.count_nonzero(crosses & (x < ax + (y - ay) * (bx - ax) / rise)) % 2)


def _listed(points, lower):
    return np.round(np.asarray(points, float).reshape(-1, 2) - lower, 2).tolist()


def _coast(rings, lower, size):
    """Land goes on where a coast leaves the mapped rectangle."""
    leaves = ((rings[0] < lower) | (rings[0] > lower + size)).any()
    clipped = {"clipped": True} if leaves else {}
    return _feature("coast", "Polygon", [_closed(ring, lower) for ring in rings], **clipped)


def _closed(ring, lower):
    return _listed(np.vstack([ring, ring[:1]]), lower)


def _feature(kind, geometry, coordinates, **properties):
    return {
        "type": "Feature",
        "properties": {"kind": kind, **properties},
        "geometry": {"type": geometry, "coordinates": coordinates},
    }
