"""Open lines joined end to end into rings, as a hand draws a coast in several strokes. No bpy here.

Lines are arrays (n, 2) in metres. End 2 i is the beginning of line i, end 2 i + 1 its end.
"""

from dataclasses import dataclass

import numpy as np


@dataclass
class Joined:
    rings: list  # without the first point repeated
    gaps: list  # ((x, y), (x, y)): ends that were joined although they lie farther apart


def join(lines, tolerance):
    """Joins the two nearest ends again and again until no line is open, and tells the gaps wider
    than `tolerance` (m). A tolerance of 0 closes each line by itself."""
    lines = [np.asarray(line, float) for line in lines]
    ends = np.array([end for line in lines for end in (line[0], line[-1])])
    gaps = np.hypot(*(ends[:, None] - ends).transpose(2, 0, 1))
    links = _links(gaps, alone=tolerance == 0)
    done = set()
    rings = [_ring(i, lines, links, done) for i in range(len(lines)) if i not in done]
    wide = [(a, b) for a, b in links.items() if a < b and gaps[a, b] > tolerance]
    return Joined(rings, [(tuple(ends[a]), tuple(ends[b])) for a, b in wide])


def _links(gaps, alone):
    """Which end meets which."""
    first, second = np.nonzero(np.triu(np.ones_like(gaps), 1))
    if alone:
        first = np.arange(0, len(gaps), 2)
        second = first + 1
    links = {}
    for k in np.argsort(gaps[first, second], kind="stable"):
        a, b = int(first[k]), int(second[k])
        if a not in links and b not in links:
            links[a], links[b] = b, a
    return links


def _ring(line, lines, links, done):
    """The points from a line's beginning on, round all lines that hang together."""
    pieces, end = [], 2 * line
    while end // 2 not in done:
        done.add(end // 2)
        pieces.append(lines[end // 2][:: -1 if end % 2 else 1])
        end = links[end ^ 1]
    return np.vstack(pieces)
