"""The recipes that come along: the core's, in the wheel's folder `orogen/recipes`, and this
extension's own, in `recipes`."""

import functools
import json
import zlib
from pathlib import Path

from . import recipe
from .titles import title
from .worker.launch import NoCore, core_folder

SUFFIX = ".orogen.json"
JOIN = "corsica_folded_strata"
FIRST = "corsica"  # what a new terrain shows


OWN = Path(__file__).parent / "recipes"


def folder():
    return core_folder() / "orogen" / "recipes"


def path_of(name):
    own = OWN / f"{name}{SUFFIX}"
    return own if own.exists() else folder() / own.name


@functools.cache
def join_stages():
    """The stages by which the plates of a map fold layers of rock, as the example has them."""
    return recipe.stage_names(json.loads(path_of(JOIN).read_text(encoding="utf-8")))


def items():
    """For an enumeration, its default first. The number that a .blend keeps comes from the name,
    not the order."""
    try:
        paths = [*folder().glob(f"*{SUFFIX}"), *OWN.glob(f"*{SUFFIX}")]
        names = sorted(path.name.removesuffix(SUFFIX) for path in paths)
        names.sort(key=lambda name: name != FIRST)
    except NoCore:
        names = []
    return [(name, title(name), f"The recipe '{name}'", number(name)) for name in names or ["none"]]


def number(name):
    return zlib.crc32(name.encode()) & 0x7FFFFFFF
