"""Every class is named and labelled as Blender's own are."""

import re

PREFIXES = {
    "Operator": "OT",
    "Panel": "PT",
    "Menu": "MT",
    "UIList": "UL",
    "PropertyGroup": "PG",
    "FileHandler": "FH",
    "AssetShelf": "AST",
    "Gizmo": "GT",
    "GizmoGroup": "GGT",
    "AddonPreferences": "AP",
}
SMALL = (
    "a an and as at but by for from in into nor of off on or over per the to up via with".split()
)
UNITS = {"km", "m", "mm", "km/m"}
SESSION = {"OROGEN_PG_session"}  # state that is not shown as properties
# What operators begin with that need no undo step: they change no data of the file.
READING = ("cancel", "copy", "export", "open", "pause", "save", "show", "add_terrain_preset")


def is_title(label):
    """Whether each word has a capital, apart from small words in the middle, and units."""
    words = re.sub(r"\(.*\)", "", label).split()
    return bool(words) and all(
        not word[0].isalpha() or word[0].isupper() or word in UNITS or (i and word in SMALL)
        for i, word in enumerate(words)
    )


def faults_of_text(place, text):
    if not text:
        yield f"{place}: no tooltip"
    elif text.endswith(".") or not (text[0].isupper() or text[0].isdigit()) or "\n  " in text:
        yield f"{place}: {text!r}"


def faults_of_properties(cls, rna):
    """Of those that a user may see. Groups inside groups have no label of their own."""
    for prop in rna.properties:
        declared = any(prop.identifier in vars(k).get("__annotations__", ()) for k in cls.__mro__)
        if not declared or prop.is_hidden or prop.type in ("POINTER", "COLLECTION"):
            continue
        place = f"{cls.__name__}.{prop.identifier}"
        yield from faults_of_text(place, prop.description)
        if not is_title(prop.name):
            yield f"{place}: label {prop.name!r}"
        for item in prop.enum_items_static if prop.type == "ENUM" else ():
            if not is_title(item.name):
                yield f"{place}: choice {item.name!r}"


def faults_of_operator(cls):
    import bpy

    if not re.fullmatch(r"orogen\.[a-z][a-z0-9_]*", cls.bl_idname):
        yield f"{cls.__name__}: bl_idname {cls.bl_idname}"
    name = cls.bl_idname.partition(".")[2]
    if cls.__name__ != f"OROGEN_OT_{name}":
        yield f"{cls.__name__}: is called {cls.bl_idname}"
    if not is_title(cls.bl_label):
        yield f"{cls.__name__}: label {cls.bl_label!r}"
    if not hasattr(cls, "execute"):
        yield f"{cls.__name__}: does not run in the background"
    rna = getattr(bpy.ops.orogen, name).get_rna_type()
    yield from faults_of_text(cls.__name__, rna.description)
    yield from faults_of_properties(cls, rna)
    undoes = {"UNDO", "UNDO_GROUPED"} & set(getattr(cls, "bl_options", ()))
    if not undoes and not name.startswith(READING):
        yield f"{cls.__name__}: has no undo step"


def faults_of_panel(cls):
    if getattr(cls, "bl_idname", cls.__name__) != cls.__name__:
        yield f"{cls.__name__}: bl_idname {cls.bl_idname}"
    if "HIDE_HEADER" not in getattr(cls, "bl_options", ()) and not is_title(cls.bl_label):
        yield f"{cls.__name__}: label {cls.bl_label!r}"


def test_classes_are_named_and_labelled():
    import bpy
    import traces

    faults, kinds = [], set()
    for cls in traces.classes():
        kind = next(k for k in PREFIXES if issubclass(cls, getattr(bpy.types, k)))
        kinds.add(kind)
        if not re.fullmatch(rf"OROGEN_{PREFIXES[kind]}_[a-z][a-z0-9_]*", cls.__name__):
            faults.append(f"{cls.__name__}: name")
        if kind == "Operator":
            faults += faults_of_operator(cls)
        elif kind == "PropertyGroup" and cls.__name__ not in SESSION:
            faults += faults_of_properties(cls, cls.bl_rna)
        elif kind == "Panel":
            faults += faults_of_panel(cls)
    assert {"Operator", "Panel", "PropertyGroup"} <= kinds
    assert not faults, "\n".join(sorted(set(faults)))


def test_title_case():
    assert all(map(is_title, ["Grow", "Units per km", "Size in the Scene", "Depth (m)", "2D Map"]))
    assert not any(map(is_title, ["", "With ground", "the Scene", "Size In the scene"]))
