"""All that is drawn as lines: grease pencil and curve objects."""

from .curves import read_curves
from .strokes import read_strokes


def read_lines(ob, frame):
    """The lines of an object at a frame as strokes in world coordinates; none of other objects."""
    return read_curves(ob) if ob.type == "CURVE" else read_strokes(ob, frame)
