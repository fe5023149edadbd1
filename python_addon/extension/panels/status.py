"""Progress where it can be seen: the panel and the status bar."""

from ..worker import remaining


def begin(context, name):
    session = context.window_manager.orogen
    session.running, session.stop, session.terrain = True, False, name
    session.stage, session.fraction, session.left = "starting", 0.0, ""
    _redraw(context)


def show(context, job):
    left = "paused" if job.paused else remaining.in_words(remaining.seconds_left(job.history))
    show_step(context, job.stage, job.fraction, left)


def show_step(context, stage, fraction, left=""):
    session = context.window_manager.orogen
    before = text(session)
    session.stage, session.fraction, session.left = stage, fraction, left
    if text(session) != before:
        context.workspace.status_text_set(f"Orogen: {text(session)}   Esc: Cancel")
        _redraw(context)


def end(context):
    session = context.window_manager.orogen
    session.running = session.stop = False
    for workspace in _workspaces(context):
        workspace.status_text_set(None)
    _redraw(context)


def text(session):
    stage = session.stage.replace("_", " ").title()
    parts = (f"{stage} {100 * session.fraction:.0f}%", session.left)
    return ", ".join(part for part in parts if part)


def _workspaces(context):
    return {window.workspace for window in context.window_manager.windows}


def _redraw(context):
    """The sidebars alone: drawing the scene may take long."""
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            for region in area.regions if area.type == "VIEW_3D" else ():
                if region.type == "UI":
                    region.tag_redraw()
