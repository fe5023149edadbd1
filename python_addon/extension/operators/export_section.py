"""A section through the rocks as a picture: in a file, and in the scene."""

import bpy

from ..mesh import picture_object
from ..scene import section_line
from .add_rocks import BEARING
from .export_operator import ExportOperator
from .product_operator import RocksOperator


class OROGEN_OT_export_section(ExportOperator, RocksOperator, bpy.types.Operator):
    """Write a section as a drawing (SVG), a picture (PNG) or a mesh (PLY): along what is selected,
    as Add Section"""

    bl_idname = "orogen.export_section"
    bl_label = "Export Section"
    bl_options = {"REGISTER"}
    kind = "section_file"

    filename_ext = ".svg"
    check_extension = None  # .png and .ply are right too
    filter_glob: bpy.props.StringProperty(default="*.svg;*.png;*.ply", options={"HIDDEN"})
    bearing: BEARING

    def wishes(self, context, terrain):
        line = section_line.find(context, terrain, self.bearing)
        return {"line": line, "file": self.file()}

    def take(self, context, terrain, result):
        self.report({"INFO"}, f"Wrote {self.filepath}")


class OROGEN_OT_add_section_picture(RocksOperator, bpy.types.Operator):
    """Make a picture of a section, heights exaggerated as in a book, and stand it up beside the
    terrain. It is an image of the file: any Image Editor shows it"""

    bl_idname = "orogen.add_section_picture"
    bl_label = "Add Picture of Section"
    kind = "picture"

    bearing: BEARING

    def wishes(self, context, terrain):
        return {"line": section_line.find(context, terrain, self.bearing)}

    def take(self, context, terrain, result):
        picture_object.write(terrain, result.meshes()["picture"])
