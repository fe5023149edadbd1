"""Whether Blender's properties can hold what a recipe says; the core checks everything else.

Properties clamp in silence, so what they would change is refused before. No bpy here.
"""

from .declarations import COLUMNS, LAYER_NUMBERS, LITHOLOGIES, SPRING_NUMBERS, STAGES
from .recipe import NotARecipe

LARGEST = 2**31 - 1  # of Blender's integers


def check(document):
    """Raises NotARecipe, naming the place, if a value does not fit."""
    _integer(document, "seed", 0, LARGEST)
    _integer(document, "resolution", 2, 65536)
    if "column" in document:
        _check_column(document["column"])
    _check_springs(document.get("river_sources", []))
    stages = document.get("stages", [])
    if not isinstance(stages, list):
        raise NotARecipe("stages: a list is wanted")
    for i, item in enumerate(stages):
        place = f"stages[{i}]"
        if not isinstance(item, dict) or not isinstance(item.get("parameters", {}), dict):
            raise NotARecipe(f'{place}: {{"stage": ..., "parameters": {{...}}}} is wanted')
        stage = next((stage for stage in STAGES if stage.name == item.get("stage")), None)
        if stage is None:
            raise NotARecipe(f"{place}: no stage is called {item.get('stage')!r}")
        known = {parameter.name: parameter for parameter in stage.parameters}
        for name, value in item.get("parameters", {}).items():
            if name not in known:
                raise NotARecipe(f"{place}.parameters: '{stage.name}' has no parameter {name!r}")
            _check_value(known[name], value, f"{place}.parameters")


def _check_springs(sources):
    if not isinstance(sources, list):
        raise NotARecipe("river_sources: a list is wanted")
    for i, source in enumerate(sources):
        place = f"river_sources[{i}]"
        at = source.get("position") if isinstance(source, dict) else None
        if not isinstance(at, list) or len(at) != 2 or not all(map(_is_number, at)):
            raise NotARecipe(f"{place}.position: two numbers are wanted")
        if not isinstance(source.get("name", ""), str):
            raise NotARecipe(f"{place}.name: text is wanted")
        for number in SPRING_NUMBERS:
            _check_value(number, source.get(number.name), place)


def _check_column(column):
    if not isinstance(column, dict):
        raise NotARecipe("column: a preset, or basement and layers, are wanted")
    if "preset" in column:
        if column["preset"] not in list(COLUMNS):
            raise NotARecipe(f"column.preset: there is no column {column['preset']!r}")
        return
    if not isinstance(column.get("layers"), list):
        raise NotARecipe("column.layers: a list is wanted")
    _check_layer(column.get("basement"), "column.basement")
    for i, layer in enumerate(column["layers"]):
        _check_layer(layer, f"column.layers[{i}]")


def _check_layer(layer, place):
    beds = layer.get("sub_layers") if isinstance(layer, dict) else None
    if not isinstance(beds, list) or not beds:
        raise NotARecipe(f"{place}.sub_layers: a list of rocks is wanted")
    for bed in beds:
        lithology = bed.get("lithology") if isinstance(bed, dict) else None
        if not isinstance(lithology, str) or lithology not in LITHOLOGIES:
            raise NotARecipe(f"{place}.sub_layers: there is no rock {lithology!r}")
        if not _is_number(bed.get("share", 1)) or not _is_number(bed.get("resistance", 0)):
            raise NotARecipe(f"{place}.sub_layers: share and resistance are numbers")
    for number in LAYER_NUMBERS:
        _check_value(number, layer.get(number.name, number.default), place)
    rows = layer.get("thickness_map", [[0]])
    if not isinstance(rows, list) or not all(isinstance(row, list) for row in rows):
        raise NotARecipe(f"{place}.thickness_map: a list of rows is wanted")
    if len({len(row) for row in rows}) != 1 or not all(
        map(_is_number, (value for row in rows for value in row))
    ):
        raise NotARecipe(f"{place}.thickness_map: rows of as many numbers each are wanted")


def _is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _integer(document, name, low, high):
    value = document.get(name, low)
    if type(value) is not int or not low <= value <= high:
        raise NotARecipe(f"{name}: {value!r}, but {low} to {high} is wanted")


def _check_value(parameter, value, place):
    if not _fits(parameter, value):
        allowed = _allowed(parameter)
        raise NotARecipe(f"{place}.{parameter.name}: {value!r}, but {allowed} is wanted")


def _fits(parameter, value):
    if parameter.type == "bool":
        return isinstance(value, bool)
    if parameter.type == "choice":
        return value in parameter.choices
    if parameter.type == "int" and not isinstance(value, int):
        return False
    return _is_number(value) and parameter.min <= value <= parameter.max


def _allowed(parameter):
    if parameter.type == "bool":
        return "true or false"
    if parameter.type == "choice":
        return " or ".join(parameter.choices)
    return f"{parameter.min:g} to {parameter.max:g} {parameter.unit}".rstrip()
