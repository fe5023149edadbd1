"""The presets that Blender finds, the extension's own first, and their pictures: NAME.jpg beside
NAME.py."""

from pathlib import Path

import bpy
import bpy.utils.previews

FOLDER = "orogen/terrain"  # of presets, as Blender has them
OWN = Path(__file__).parent / "presets" / FOLDER

_pictures = None


def found():
    """Their files."""
    folders = sorted(map(Path, bpy.utils.preset_paths(FOLDER)), key=lambda path: path != OWN)
    return [file for folder in folders for file in sorted(folder.glob("*.py"))]


def name_of(file):
    return bpy.path.display_name(file.name)


def icon(file):
    """The number of a preset's picture, for layouts; 0 without one."""
    picture = file.with_suffix(".jpg")
    if str(file) not in _pictures and picture.is_file():
        _pictures.load(str(file), str(picture), "IMAGE")
    return _pictures[str(file)].icon_id if str(file) in _pictures else 0


def register():
    global _pictures
    _pictures = bpy.utils.previews.new()


def unregister():
    global _pictures
    bpy.utils.previews.remove(_pictures)
    _pictures = None
