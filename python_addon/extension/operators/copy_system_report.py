"""What helps to find the cause of a problem, ready to be pasted."""

import bpy

from .. import system_report


class OROGEN_OT_copy_system_report(bpy.types.Operator):
    """Copy versions, the machine and the last message, to be pasted into a report of a problem. In
    the background they are printed"""

    bl_idname = "orogen.copy_system_report"
    bl_label = "Copy System Report"

    def execute(self, context):
        text = system_report.make(context)
        if bpy.app.background:
            print(text)
        else:
            context.window_manager.clipboard = text
            self.report({"INFO"}, "The system report is in the clipboard")
        return {"FINISHED"}
