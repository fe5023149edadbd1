"""What the session knows and the file does not keep: the running job, the last message."""

import bpy


class OROGEN_PG_session(bpy.types.PropertyGroup):
    running: bpy.props.BoolProperty(options={"SKIP_SAVE"})
    terrain: bpy.props.StringProperty(options={"SKIP_SAVE"}, description="Name of what grows")
    stage: bpy.props.StringProperty(options={"SKIP_SAVE"})
    fraction: bpy.props.FloatProperty(options={"SKIP_SAVE"}, min=0.0, max=1.0)
    left: bpy.props.StringProperty(options={"SKIP_SAVE"}, description="Time that remains")
    message: bpy.props.StringProperty(options={"SKIP_SAVE"})
    is_error: bpy.props.BoolProperty(options={"SKIP_SAVE"})
    stop: bpy.props.BoolProperty(options={"SKIP_SAVE"}, description="Asks the job to stop")


def tell(context, message, is_error=False):
    """Puts a message where the panel shows it."""
    session = context.window_manager.orogen
    session.message, session.is_error = message, is_error
