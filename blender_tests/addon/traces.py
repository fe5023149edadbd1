"""What Blender holds of the extension. Imported in the process with bpy."""

import sys

import bpy

ADDON = "bl_ext.user_default.orogen"


def find():
    """All traces, as sorted lines; none where the extension is off."""
    return sorted([*_classes(), *_on_types(), *_handlers(), *_timers(), *_in_preferences()])


def classes():
    """The registered classes of the extension."""
    return [cls for cls in _subclasses(bpy.types.bpy_struct) if _registered(cls)]


def is_gone(command):
    """Whether a command of Blender's command line is no longer registered."""
    try:
        bpy.utils.unregister_cli_command(command)
    except ValueError:
        return True
    return False


def _registered(cls):
    return _is_ours(cls) and getattr(cls, "is_registered", False)  # a tool's class never is


def _is_ours(thing):
    return (getattr(thing, "__module__", None) or "").startswith(ADDON)


def _subclasses(cls):
    for sub in cls.__subclasses__():
        yield sub
        yield from _subclasses(sub)


def _classes():
    yield from (f"class {cls.__name__}" for cls in set(classes()))
    yield from (f"class {name}" for name in dir(bpy.types) if "OROGEN" in name)
    yield from (f"operator {name}" for name in dir(bpy.ops.orogen))


def _on_types():
    """Properties, and entries of menus, panels and headers."""
    for name in dir(bpy.types):
        kind = getattr(bpy.types, name)
        members = getattr(kind, "__dict__", ())
        yield from (f"property {name}.{key}" for key in members if "orogen" in key.lower())
        for function in getattr(getattr(kind, "draw", None), "_draw_funcs", ()):
            if _is_ours(function):
                yield f"menu entry {name}"
        if "orogen" in str(getattr(kind, "_tools", "")):
            yield f"tool {name}"


def _handlers():
    for name in dir(bpy.app.handlers):
        functions = getattr(bpy.app.handlers, name)
        if isinstance(functions, list):
            yield from (f"handler {name}" for function in functions if _is_ours(function))


def _timers():
    for module in [m for name, m in sys.modules.items() if name.startswith(ADDON)]:
        for function in vars(module).values():
            if _is_ours(function) and not isinstance(function, type) and callable(function):
                if bpy.app.timers.is_registered(function):
                    yield f"timer {function.__name__}"


def _in_preferences():
    for keymap in bpy.context.window_manager.keyconfigs.addon.keymaps:
        yield from (f"key {i.idname}" for i in keymap.keymap_items if "orogen" in i.idname.lower())
    for library in bpy.context.preferences.filepaths.asset_libraries:
        if "orogen" in library.path.lower():
            yield f"asset library {library.name}"
    yield from (f"preset path {path}" for path in bpy.utils.preset_paths("") if "orogen" in path)
