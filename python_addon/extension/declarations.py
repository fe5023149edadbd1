"""The core's declarations of stages, parameters and fields, from the `schema.json` that the build
puts beside this file: registering the extension loads no native code.
"""

import json
import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from .titles import title


@dataclass(frozen=True)
class Parameter:
    name: str
    type: str  # bool, int, float, choice
    default: object
    min: float | None
    max: float | None
    unit: str
    description: str
    choices: tuple[str, ...]

    @cached_property
    def scale(self):
        """A power of ten: what one unit of the shown number is worth. 1 except for numbers that a
        field of six decimals cannot show, such as an erodibility of 2e-6 1/yr or a viscosity of
        1e20 Pa s."""
        if self.type != "float" or self.default == 0 or 1e-3 <= abs(self.default) < 1e15:
            return 1.0
        return 10.0 ** math.floor(math.log10(abs(self.default)))

    @property
    def shown_unit(self):
        scale = "" if self.scale == 1.0 else f"1e{round(math.log10(self.scale))}"
        unit = "" if self.unit == "1" else self.unit
        return " ".join(part for part in (scale, unit) if part)

    @property
    def label(self):
        label = title(self.name.removesuffix("_" + self.unit.replace("/", "_per_")))
        return f"{label} ({self.shown_unit})" if self.shown_unit else label

    @property
    def tooltip(self):
        """The declared sentence and the allowed range. Blender adds the full stop."""
        text = self.description.rstrip(".")
        if self.type not in ("int", "float"):
            return text
        return f"{text}.\nFrom {self.min:g} to {self.max:g} {self.unit}".rstrip()


@dataclass(frozen=True)
class Stage:
    name: str
    text: str
    citation: str
    parameters: tuple[Parameter, ...]

    @property
    def label(self):
        return title(self.name)


@dataclass(frozen=True)
class Field:
    name: str
    type: str  # float32, int32
    unit: str
    description: str

    @property
    def label(self):
        return title(self.name)


@dataclass(frozen=True)
class Lithology:
    name: str
    resistance: float
    map: int  # colours of the two palettes, sRGB 0xRRGGBB
    natural: int


@dataclass(frozen=True)
class Biome:
    name: str
    color: int  # sRGB, 0xRRGGBB

    @property
    def label(self):
        return title(self.name)


def _parameter(item):
    return Parameter(
        name=item["name"],
        type=item["type"],
        default=item["default"],
        min=item["min"],
        max=item["max"],
        unit=item["unit"],
        description=item["description"],
        choices=tuple(item["choices"]),
    )


def _parameters(items):
    return tuple(_parameter(item) for item in items)


def read(path):
    """All stages, the names of those of the default recipes (of maps, of colliding plates, of given
    heights, of islands), and all fields; columns of rock by name, the numbers of a layer, all
    lithologies, all biomes, and the numbers of a spring.
    """
    schema = json.loads(Path(path).read_text(encoding="utf-8"))
    stages = tuple(
        Stage(
            stage["name"],
            stage["text"],
            stage["citation"],
            _parameters(stage["parameters"]),
        )
        for stage in schema["stages"]
    )
    keys = ("default_stages", "collision_stages", "height_stages", "island_stages")
    names = (tuple(schema[key]) for key in keys)
    fields = tuple(Field(**item) for item in schema["fields"])
    lithologies = {item["name"]: Lithology(**item) for item in schema["lithologies"]}
    biomes = tuple(Biome(item["name"], item["color"]) for item in schema["biomes"])
    layer, spring = (_parameters(schema[key]) for key in ("layer", "river_source"))
    return stages, *names, fields, schema["columns"], layer, lithologies, biomes, spring


(
    STAGES,
    MAP_STAGES,
    COLLISION_STAGES,
    HEIGHT_STAGES,
    ISLAND_STAGES,
    FIELDS,
    COLUMNS,
    LAYER_NUMBERS,
    LITHOLOGIES,
    BIOMES,
    SPRING_NUMBERS,
) = read(Path(__file__).with_name("schema.json"))
