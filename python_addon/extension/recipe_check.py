"""Whether Blender's properties can hold what a recipe says; the core checks everything else.

Properties clamp in silence, so what they would change is refused before. No bpy here.
"""

from .declarations import STAGES
from .recipe import NotARecipe

LARGEST = 2**31 - 1  # of Blender's integers


def check(document):
    """Raises NotARecipe, naming the place, if a value does not fit."""
    _integer(document, "seed", 0, LARGEST)
    _integer(document, "resolution", 2, 65536)
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
            if not _fits(known[name], value):
                allowed = _allowed(known[name])
                raise NotARecipe(f"{place}.parameters.{name}: {value!r}, but {allowed} is wanted")


def _integer(document, name, low, high):
    value = document.get(name, low)
    if type(value) is not int or not low <= value <= high:
        raise NotARecipe(f"{name}: {value!r}, but {low} to {high} is wanted")


def _fits(parameter, value):
    if parameter.type == "bool":
        return isinstance(value, bool)
    if parameter.type == "choice":
        return value in parameter.choices
    number = int if parameter.type == "int" else (int, float)
    is_number = isinstance(value, number) and not isinstance(value, bool)
    return is_number and parameter.min <= value <= parameter.max


def _allowed(parameter):
    if parameter.type == "bool":
        return "true or false"
    if parameter.type == "choice":
        return " or ".join(parameter.choices)
    return f"{parameter.min:g} to {parameter.max:g} {parameter.unit}".rstrip()
