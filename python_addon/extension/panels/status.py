"""Progress where it can be seen: the panel and the status bar."""


def begin(context, name):
    session = context.window_manager.orogen
    session.running, session.stop, session.terrain = True, False, name
    session.stage, session.fraction = "starting", 0.0
    _redraw(context)


def show(context, job):
    session = context.window_manager.orogen
    if (session.stage, session.fraction) != (job.stage, job.fraction):
        session.stage, session.fraction = job.stage, job.fraction
        context.workspace.status_text_set(f"Orogen: {text(session)}   Esc: cancel")
        _redraw(context)


def end(context):
    session = context.window_manager.orogen
    session.running = session.stop = False
    for workspace in _workspaces(context):
        workspace.status_text_set(None)
    _redraw(context)


def text(session):
    return f"{session.stage.replace('_', ' ')} {100 * session.fraction:.0f}%"


def _workspaces(context):
    return {window.workspace for window in context.window_manager.windows}


def _redraw(context):
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()
