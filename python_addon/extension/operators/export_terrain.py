"""Writing a terrain to files for other programs, as it was grown."""

import os

import bpy

from ..declarations import FIELDS
from .export_operator import ExportOperator
from .product_operator import ProductOperator

FORMATS = (  # as the core calls them, with the suffix
    ("tif", "GeoTIFF", "A field as 32-bit numbers with its place on Earth", ".tif"),
    ("exr", "OpenEXR", "A field as 32-bit floats", ".exr"),
    ("png16", "PNG, 16 Bits", "A field in 65536 steps; a .json beside says what they mean", ".png"),
    ("npz", "NumPy", "All fields", ".npz"),
    ("vdb", "OpenVDB", "The ground as a level set in metres", ".vdb"),
    ("tin", "Triangles (PLY)", "What mountains between colliding plates grew on", ".ply"),
    ("folds", "Folds (GeoJSON)", "Crests and troughs of the layers that folded", ".geojson"),
)
SUFFIXES = {name: suffix for name, _, _, suffix in FORMATS}
OF_A_FIELD = ("tif", "exr", "png16")


class OROGEN_OT_export_terrain(ExportOperator, ProductOperator, bpy.types.Operator):
    """Write the active terrain, as it was grown, for other programs"""

    bl_idname = "orogen.export_terrain"
    bl_label = "Export Terrain"
    bl_options = {"REGISTER"}
    kind = "save"

    format: bpy.props.EnumProperty(
        name="Format", items=[item[:3] for item in FORMATS], description="What is written"
    )
    field: bpy.props.EnumProperty(
        name="Field",
        items=[(f.name, f.label, f.description.rstrip(".")) for f in FIELDS],
        description="Which of the terrain's fields",
    )
    filter_glob: bpy.props.StringProperty(
        default=";".join(f"*{suffix}" for suffix in SUFFIXES.values()), options={"HIDDEN"}
    )

    @property
    def filename_ext(self):
        return SUFFIXES[self.format]

    def draw(self, _context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "format")
        if self.format in OF_A_FIELD:
            layout.prop(self, "field")

    def check(self, _context):
        """The file's name follows the format."""
        stem, suffix = os.path.splitext(self.filepath)
        if suffix == self.filename_ext:
            return False
        known = suffix in SUFFIXES.values()
        self.filepath = (stem if known else self.filepath) + self.filename_ext
        return True

    def wishes(self, context, terrain):
        return {"format": self.format, "field": self.field, "file": self.file()}

    def take(self, context, terrain, result):
        self.report({"INFO"}, f"Wrote {self.filepath}")


def draw_menu(self, _context):
    self.layout.operator(OROGEN_OT_export_terrain.bl_idname, text="Orogen terrain (.tif, .exr ...)")
