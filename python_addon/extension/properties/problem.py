"""What is wrong with what is drawn, kept where the panel and the overlay find it."""

import bpy


class OROGEN_PG_problem(bpy.types.PropertyGroup):
    text: bpy.props.StringProperty()
    is_error: bpy.props.BoolProperty()
    has_place: bpy.props.BoolProperty()
    place: bpy.props.FloatVectorProperty(size=2, description="On the terrain's plane, m")


def keep(terrain, problems):
    """Lists these problems, and no others, with the terrain."""
    kept = terrain.orogen.problems
    kept.clear()
    for problem in problems:
        item = kept.add()
        item.text, item.is_error = problem.text, problem.is_error
        item.has_place = problem.place is not None
        item.place = problem.place or (0.0, 0.0)
