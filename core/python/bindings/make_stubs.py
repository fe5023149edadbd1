"""Writes the type stubs of the compiled module from what it says about itself.

python core/python/bindings/make_stubs.py          writes core/python/orogen/*.pyi
python core/python/bindings/make_stubs.py --check  fails if they are not up to date
"""

import argparse
import inspect
import pathlib
import re
import sys

import orogen
from orogen import _core

PACKAGE = pathlib.Path(__file__).resolve().parents[1] / "orogen"
ROOMS = (
    "inputs",
    "tectonics",
    "folding",
    "strata",
    "hydrology",
    "climate",
    "island",
    "sculpting",
    "erosion",
    "vegetation",
)
FIRST_LINE = "# Made by core/python/bindings/make_stubs.py; do not edit.\n"
IMPORTS = (
    ("collections.abc", "Callable"),
    ("collections.abc", "Sequence"),
    ("os", "PathLike"),
    ("typing", "Any"),
    ("typing", "Literal"),
    ("numpy.typing", "ArrayLike"),
    ("numpy.typing", "NDArray"),
)
_PARAMETER = re.compile(r"^(\w+) : (.+?)(?:, optional|, default .*)?$")
_SIGNATURE = re.compile(r"^\w*\((?P<arguments>.*)\) -> (?P<returns>.+)$")


def type_of(text, is_argument):
    """A type in words, as docstrings have it, as an annotation."""
    if text.startswith("{"):
        return f"Literal[{text[1:-1]}]"
    if " or " in text and not text.startswith("array"):
        parts = [type_of(part, is_argument) for part in text.split(" or ")]
        return " | ".join(dict.fromkeys(parts))
    if text.startswith("callable"):
        return "Callable[[str, float], bool | None]"
    if text.startswith("array"):
        optional = " | None" if text.endswith("or None") else ""
        item = text.split(" of ")[1].split(" ")[0].rstrip(",")
        return f"ArrayLike{optional}" if is_argument else f"NDArray[np.{item}]"
    if text.startswith("tuple"):
        return "tuple[Any, ...]"
    return text


def documented_function(name, function):
    """A stub from a numpydoc docstring."""
    lines = function.__doc__.splitlines()
    types = {m[1]: m[2] for m in map(_PARAMETER.match, lines) if m}
    returns = lines[lines.index("Returns") + 2]
    parts, keyword_only = [], False
    for parameter in inspect.signature(function).parameters.values():
        if parameter.kind is parameter.KEYWORD_ONLY and not keyword_only:
            parts.append("*")
            keyword_only = True
        text = f"{parameter.name}: {type_of(types[parameter.name], True)}"
        if parameter.default is not parameter.empty:
            # Declared defaults are not repeated: they may be tuned.
            text += " = ..." if keyword_only else f" = {parameter.default!r}"
        parts.append(text)
    arguments = "".join(f"    {part},\n" for part in parts)
    return f"def {name}(\n{arguments}) -> {type_of(returns, False)}: ...\n"


def plain(annotation):
    """pybind11's annotation in the stub's own names."""
    annotation = re.sub(r"orogen\._core\.(?:\w+\.)?(\w+)", r"\1", annotation)
    annotation = re.sub(r"typing\.SupportsInt(?: \| typing\.SupportsIndex)?", "int", annotation)
    annotation = re.sub(r"typing\.SupportsFloat(?: \| typing\.SupportsIndex)?", "float", annotation)
    annotation = re.sub(r"collections\.abc\.Sequence", "Sequence", annotation)
    annotation = re.sub(r"numpy\.ndarray(\[.*\])?", "NDArray[Any]", annotation)
    annotation = re.sub(r"\bos\.PathLike\b", "PathLike[str]", annotation)
    annotation = re.sub(r"pathlib\.Path|os\.PathLike", "PathLike[str]", annotation)
    annotation = re.sub(r"PathLike\[str\] \| str \| bytes", "str | PathLike[str]", annotation)
    return annotation.replace("object", "Any")


def method(name, function, static):
    match = _SIGNATURE.match(function.__doc__.strip().splitlines()[0])
    arguments = re.sub(r"self: [\w.]+", "self", plain(match["arguments"]))
    decorator = "    @staticmethod\n" if static else ""
    return f"{decorator}    def {name}({arguments}) -> {plain(match['returns'])}: ...\n"


def property_stub(name, value):
    match = _SIGNATURE.match((value.fget.__doc__ or "() -> Any").strip().splitlines()[0])
    return f"    @property\n    def {name}(self) -> {plain(match['returns'])}: ...\n"


def class_stub(name, value):
    if issubclass(value, Exception):
        bases = ", ".join(base.__name__ for base in value.__bases__)
        return f"class {name}({bases}): ...\n"
    base = value.__base__ if value.__base__.__module__.startswith("orogen") else None
    text = f"class {name}({base.__name__}):\n" if base else f"class {name}:\n"
    for member, attribute in sorted(vars(value).items()):
        if isinstance(attribute, property):
            text += property_stub(member, attribute)
        elif member == "__init__" and "->" in (attribute.__doc__ or ""):
            text += method(member, attribute, False)
        elif not member.startswith("_") or member in ("__len__",):
            text += method(member, getattr(value, member), isinstance(attribute, staticmethod))
    return text if text.count("\n") > 1 else text[:-1] + " ...\n"


def imports_for(text):
    """The import lines that a stub's text needs."""
    modules = {}
    for module, name in IMPORTS:
        if re.search(rf"\b{name}\b", text):
            modules.setdefault(module, []).append(name)
    lines = [f"from {module} import {', '.join(names)}\n" for module, names in modules.items()]
    numpy = ["import numpy as np\n"] if "np." in text else []
    standard = [line for line in lines if "numpy" not in line]
    third = numpy + [line for line in lines if "numpy" in line]
    return "".join(standard) + "\n" * bool(standard and third) + "".join(third)


def module_stub(module, imports=""):
    text = ""
    for name, value in sorted(vars(module).items()):
        if name == "__version__":
            text += "__version__: str\n"
        elif name.startswith("_") or inspect.ismodule(value):
            continue
        elif inspect.isclass(value):
            text += "\n" + class_stub(name, value)
        elif "Returns\n-------" in value.__doc__:
            text += "\n" + documented_function(name, value)
        else:
            text += "\n" + method(name, value, False).replace("    def", "def")
    needed = imports_for(text)
    return FIRST_LINE + needed + ("\n" + imports if needed and imports else imports) + text


def imports_of(module, room=None):
    """Names that the stub of a module, that of `room`, takes from other stubs."""
    names = set()
    for function in vars(module).values():
        names |= set(re.findall(r"^\w+ : (\w+)$", function.__doc__ or "", re.M))
        names |= set(re.findall(r"orogen\._core\.(?:\w+\.)?(\w+)", function.__doc__ or ""))
        for member in vars(function).values() if inspect.isclass(function) else ():
            doc = (getattr(member, "fget", None) or member).__doc__ or ""
            names |= set(re.findall(r"orogen\._core\.(?:\w+\.)?(\w+)", doc))
    own = set(vars(module))
    text = ""
    for name in sorted(names - own):
        if hasattr(_core, name):
            text += f"from ._core import {name}\n"
        for other in ROOMS:
            if other != room and hasattr(getattr(_core, other), name):
                text += f"from .{other} import {name}\n"
    return text


def all_stubs():
    stubs = {
        room: module_stub(getattr(_core, room), imports_of(getattr(_core, room), room))
        for room in ROOMS
    }
    stubs["_core"] = module_stub(_core, imports_of(_core))
    return {PACKAGE / f"{name}.pyi": text for name, text in stubs.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    check = parser.parse_args().check
    stale = [p for p, text in all_stubs().items() if not p.exists() or p.read_text() != text]
    for path in stale:
        if check:
            print(f"{path.name} is not up to date: run core/python/bindings/make_stubs.py")
        else:
            path.write_text(all_stubs()[path])
    return 1 if check and stale else 0


if __name__ == "__main__":
    assert orogen.__version__
    sys.exit(main())
