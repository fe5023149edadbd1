"""Open lines joined end to end into rings, as a hand draws a coast in several strokes. No bpy here.

Lines are arrays (n, 2) in metres. End 2 i is the beginning of line i, end 2 i + 1 its end.
"""

from dataclasses import dataclass

import numpy as np


@dataclass
class Joined:
    rings: list  # without the first point repeated
    gaps: list  # ((x, y), (x, y)) where a ring was closed although its ends lie farther apart


def join(lines, tolerance):
    """Joins ends that lie within `tolerance` (m), the nearest first. What then stays open is
    closed straight, and the gap is told."""
    lines = [np.asarray(line, float) for line in lines]
    ends = np.array([end for line in lines for end in (line[0], line[-1])])
    links = _links(ends, tolerance)
    done = set()
    chains = [_chain(end, lines, links, done) for end in range(len(ends)) if end not in links]
    chains = [chain for chain in chains if len(chain)]
    rings = [_chain(2 * i, lines, links, done) for i in range(len(lines)) if i not in done]
    return Joined(rings + chains, [(tuple(chain[0]), tuple(chain[-1])) for chain in chains])


def _links(ends, tolerance):
    """Which end meets which."""
    gaps = np.hypot(*(ends[:, None] - ends).transpose(2, 0, 1))
    first, second = np.nonzero(np.triu(gaps <= tolerance, 1))
    links = {}
    for k in np.argsort(gaps[first, second], kind="stable"):
        a, b = int(first[k]), int(second[k])
        if a not in links and b not in links:
            links[a], links[b] = b, a
    return links


def _chain(end, lines, links, done):
    """The points from an end on, over all lines that hang together; none if they are done."""
    pieces = [np.empty((0, 2))]
    while end is not None and end // 2 not in done:
        done.add(end // 2)
        pieces.append(lines[end // 2][:: -1 if end % 2 else 1])
        end = links.get(end ^ 1)
    return np.vstack(pieces)
