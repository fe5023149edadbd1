"""The recipes that come with the core, in the wheel's folder `orogen/recipes`."""

import zlib

from .titles import title
from .worker.launch import NoCore, core_folder

SUFFIX = ".orogen.json"
FIRST = "corsica"  # what a new terrain shows


def folder():
    return core_folder() / "orogen" / "recipes"


def path_of(name):
    return folder() / f"{name}{SUFFIX}"


def items():
    """For an enumeration, its default first. The number that a .blend keeps comes from the name,
    not the order."""
    try:
        names = sorted(path.name.removesuffix(SUFFIX) for path in folder().glob(f"*{SUFFIX}"))
        names.sort(key=lambda name: name != FIRST)
    except NoCore:
        names = []
    return [(name, title(name), f"The recipe '{name}'", number(name)) for name in names or ["none"]]


def number(name):
    return zlib.crc32(name.encode()) & 0x7FFFFFFF
