"""Grow, previews, the browser of seeds; and how far the job is."""

from .. import recipe
from ..mesh import terrain_mesh, variations
from ..worker.jobs import jobs
from . import status


def draw_grow(layout, terrain):
    settings = terrain.orogen
    missing = settings.source == "FILE" and not settings.path
    column = layout.column()
    column.enabled = not missing
    row = column.row(align=True)
    row.scale_y = 1.4
    row.operator("orogen.grow", icon="RNDCURVE")
    row.prop(settings.live, "enabled", text="", icon="PLAY", toggle=True)
    if missing:
        layout.label(text="Pick a map first", icon="INFO")
    elif terrain_mesh.is_preview(terrain):
        layout.label(text="A preview: Grow makes it in full", icon="INFO")
    if not recipe.WATCHED_STAGES.isdisjoint(settings.stage_names()):
        layout.prop(settings.live, "watch")
    if settings.live.watch and recipe.WATER_STAGE in settings.stage_names():
        layout.prop(settings.live, "watch_shows")
    draw_seeds(layout, terrain)
    if "orogen_grid" in terrain.data:
        layout.operator("orogen.set_up_scene", icon="CAMERA_DATA")
        layout.operator("orogen.make_ready_scene", icon="SCENE_DATA")


def draw_seeds(layout, terrain):
    row = layout.row(align=True)
    shown = bool(variations.of(terrain))
    if shown:
        row.operator("orogen.pick_seed", icon="CHECKMARK")
    text = "More" if shown else "Browse Seeds"
    browse = row.operator("orogen.browse_seeds", text=text, icon="MESH_GRID")
    browse.count = terrain.orogen.live.variations
    if shown:
        row.operator("orogen.clear_seeds", text="", icon="X")
    else:
        row.prop(terrain.orogen.live, "variations", text="")


def draw_progress(layout, session):
    layout.progress(factor=session.fraction, text=status.text(session))
    row = layout.row(align=True)
    if job := jobs.watched:
        icon = "PLAY" if job.paused else "PAUSE"
        row.operator("orogen.pause_growth", text="Resume" if job.paused else "Pause", icon=icon)
    row.operator("orogen.cancel", icon="CANCEL")
