"""What is wrong with a drawing, in words and at its place. No bpy here.

The core names places in its messages, as "(1200.0 m, 350.0 m)" from the corner of the map's frame,
and plates, points of feature curves and springs by their numbers.
"""

import re
from dataclasses import dataclass

PLACE = re.compile(r"\((-?[\d.]+) m, (-?[\d.]+) m\)")
NAMED = re.compile(r"(features|river_sources)\[(\d+)\](?:\.points\[(\d+)\]|\.position)?\.?")
PLATES = re.compile(r"phases\[(\d+)\]\.plates\[(\d+)\](?: and \[(\d+)\])?")


@dataclass
class Problem:
    text: str
    place: tuple[float, float] | None = None  # m on the terrain's plane
    is_error: bool = False


def located(text, recipe, is_error=False, shift=(0.0, 0.0)):
    """The core's message about a recipe, with the place that it speaks of. Plates, feature curves
    and springs get their names, and plates a place amid their points. `shift` (m) leads from the
    terrain's plane to the recipe's coordinates."""
    found = NAMED.match(text)
    mine = is_error or text.startswith("river_sources")  # a warning's "features" are the map's
    if found and mine and found[1] in recipe:
        return _of_named(text, found, recipe, is_error, shift)
    plates = _plates(text, recipe)
    if not plates:
        return Problem(text, _map_place(text, recipe), is_error)
    names = " and ".join(plate["name"] for plate in plates)
    points = [point for plate in plates for point in plate["points"]]
    middle = tuple(sum(values) / len(points) for values in zip(*points, strict=True))
    return Problem(PLATES.sub(names, text, count=1), middle, is_error)


def _of_named(text, found, recipe, is_error, shift):
    """Of a feature curve or a spring."""
    member, number, point = found.groups()
    thing = recipe[member][int(number)]
    placed = thing["points"][int(point or 0)] if member == "features" else thing
    x, y = placed["position"][:2]
    name = thing.get("name", f"{member}[{number}]")
    said = text[found.end() :].lstrip(": ")
    return Problem(f"{name}: {said}", (x - shift[0], y - shift[1]), is_error)


def _map_place(text, recipe):
    found = PLACE.search(text)
    if found is None or recipe.get("map", {}).get("units") != "m":
        return None
    x, y = recipe["map"]["frame"]["origin_m"]
    return x + float(found[1]), y + float(found[2])


def _plates(text, recipe):
    """Those that a message such as "phases[0].plates[0] and [1]: ..." names."""
    found = PLATES.match(text)
    if found is None:
        return []
    phase, *named = (int(number) for number in found.groups() if number)
    return [recipe["phases"][phase]["plates"][number] for number in named]
