"""Maps and recipes dropped into a 3D view."""

import bpy


class OROGEN_FH_map(bpy.types.FileHandler):
    bl_idname = "OROGEN_FH_map"
    bl_label = "Orogen map or recipe"
    bl_import_operator = "orogen.load_map"
    bl_file_extensions = ".geojson;.json"

    @classmethod
    def poll_drop(cls, context):
        return context.area is not None and context.area.type == "VIEW_3D"
