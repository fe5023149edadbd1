"""Parameters back to their defaults."""

import bpy

from .. import terrains
from ..declarations import STAGES
from ..settings_recipe import reset


class OROGEN_OT_reset_parameters(bpy.types.Operator):
    """Set the parameters of a stage, or of all stages, to their defaults"""

    bl_idname = "orogen.reset_parameters"
    bl_label = "Reset Parameters"
    bl_options = {"REGISTER", "UNDO"}

    stage: bpy.props.StringProperty(name="Stage", description="Its name. Empty: all stages")

    @classmethod
    def poll(cls, context):
        return terrains.active(context) is not None

    def execute(self, context):
        settings = terrains.active(context).orogen
        meant = [stage for stage in STAGES if self.stage in ("", stage.name)]
        if not meant:
            self.report({"ERROR"}, f"No stage is called '{self.stage}'")
            return {"CANCELLED"}
        reset(settings, meant)
        return {"FINISHED"}


class OROGEN_OT_reset_parameter(bpy.types.Operator):
    """Set this parameter to its default"""

    bl_idname = "orogen.reset_parameter"
    bl_label = "Reset Parameter"
    bl_options = {"REGISTER", "UNDO"}

    stage: bpy.props.StringProperty(name="Stage", description="Its name")
    parameter: bpy.props.StringProperty(name="Parameter", description="Its name")

    @classmethod
    def poll(cls, context):
        return terrains.active(context) is not None

    def execute(self, context):
        stage = next((stage for stage in STAGES if stage.name == self.stage), None)
        if stage is None or self.parameter not in {p.name for p in stage.parameters}:
            self.report({"ERROR"}, f"There is no parameter '{self.stage}.{self.parameter}'")
            return {"CANCELLED"}
        group = getattr(terrains.active(context).orogen.stages, stage.name)
        group.property_unset(self.parameter)
        return {"FINISHED"}
