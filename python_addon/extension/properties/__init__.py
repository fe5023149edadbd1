"""The settings of a terrain (on its object, saved in the .blend) and the state of the session."""

import bpy

from . import (
    column,
    feature,
    ground,
    input,
    live,
    migration,
    paint,
    plate,
    problem,
    session,
    settings,
    spring,
    stages,
    view,
)

CLASSES = (
    *stages.GROUPS,
    stages.OROGEN_PG_stages,
    live.OROGEN_PG_live,
    view.OROGEN_PG_view,
    ground.OROGEN_PG_ground,
    paint.OROGEN_PG_paint,
    paint.OROGEN_PG_polygon_edit,
    paint.OROGEN_PG_paints,
    column.OROGEN_PG_layer,
    column.OROGEN_PG_column,
    input.OROGEN_PG_input,
    plate.OROGEN_PG_plate,
    feature.OROGEN_PG_feature_points,
    feature.OROGEN_PG_feature,
    spring.OROGEN_PG_spring,
    problem.OROGEN_PG_problem,
    settings.OROGEN_PG_terrain,
    session.OROGEN_PG_session,
)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.orogen = bpy.props.PointerProperty(type=settings.OROGEN_PG_terrain)
    bpy.types.Object.orogen_feature = bpy.props.PointerProperty(type=feature.OROGEN_PG_feature)
    bpy.types.Object.orogen_spring = bpy.props.PointerProperty(type=spring.OROGEN_PG_spring)
    bpy.types.Collection.orogen_plate = bpy.props.PointerProperty(type=plate.OROGEN_PG_plate)
    bpy.types.WindowManager.orogen = bpy.props.PointerProperty(type=session.OROGEN_PG_session)
    bpy.app.handlers.load_post.append(migration.migrate_file)


def unregister():
    bpy.app.handlers.load_post.remove(migration.migrate_file)
    del bpy.types.WindowManager.orogen
    del bpy.types.Collection.orogen_plate
    del bpy.types.Object.orogen_spring
    del bpy.types.Object.orogen_feature
    del bpy.types.Object.orogen
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
