"""What operators share that write a file through the worker.

The browser of files runs in the window's own time; what is chosen there is then written in the
background, as other jobs are.
"""

import os

import bpy
from bpy_extras.io_utils import ExportHelper

from ..mesh.terrain_mesh import NotNow


class ExportOperator(ExportHelper):
    """Stands before JobOperator among the bases."""

    bl_options = {"REGISTER"}
    _browsed = False

    def invoke(self, context, event):
        if bpy.app.background:
            return self.execute(context)
        self._browsed = True
        return ExportHelper.invoke(self, context, event)

    def execute(self, context):
        if self._browsed:
            return self.begin_modal(context)
        return super().execute(context)

    def file(self):
        """Where to write: an absolute path in a folder that is there. Raises NotNow."""
        file = bpy.path.abspath(self.filepath)
        if not os.path.isdir(os.path.dirname(os.path.abspath(file))):
            raise NotNow(f"There is no folder {os.path.dirname(file) or file}")
        return os.path.abspath(file)
