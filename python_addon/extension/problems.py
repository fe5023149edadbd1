"""What is wrong with a drawing, in words and at its place. No bpy here.

The core names places in its messages, as "(1200.0 m, 350.0 m)" from the corner of the map's frame,
and plates by their numbers.
"""

import re
from dataclasses import dataclass

PLACE = re.compile(r"\((-?[\d.]+) m, (-?[\d.]+) m\)")
NUMBERS = re.compile(r"\[(\d+)\]")


@dataclass
class Problem:
    text: str
    place: tuple[float, float] | None = None  # m on the terrain's plane
    is_error: bool = False


def located(text, recipe, is_error=False):
    """The core's message about a recipe, with the place that it speaks of."""
    return Problem(text, _map_place(text, recipe) or _plate_place(text, recipe), is_error)


def _map_place(text, recipe):
    found = PLACE.search(text)
    if found is None or recipe.get("map", {}).get("units") != "m":
        return None
    x, y = recipe["map"]["frame"]["origin_m"]
    return x + float(found[1]), y + float(found[2])


def _plate_place(text, recipe):
    """Amid the plates that a message such as "phases[0].plates[0] and [1]: ..." names."""
    if not text.startswith("phases["):
        return None
    phase, *named = (int(number) for number in NUMBERS.findall(text.split(":")[0]))
    plates = recipe["phases"][phase]["plates"]
    points = [point for number in named[:2] for point in plates[number]["points"]]
    if not points:
        return None
    return tuple(sum(values) / len(points) for values in zip(*points, strict=True))
