"""What is wrong with what is drawn, kept where the panel and the overlay find it."""

import bpy


class OROGEN_PG_problem(bpy.types.PropertyGroup):
    text: bpy.props.StringProperty(options={"HIDDEN"})
    is_error: bpy.props.BoolProperty(options={"HIDDEN"})
    has_place: bpy.props.BoolProperty(options={"HIDDEN"})
    place: bpy.props.FloatVectorProperty(size=2, options={"HIDDEN"})  # on the terrain's plane, m


def keep(terrain, problems):
    """Lists these problems, and no others, with the terrain."""
    kept = terrain.orogen.problems
    kept.clear()
    for problem in problems:
        item = kept.add()
        item.text, item.is_error = problem.text, problem.is_error
        item.has_place = problem.place is not None
        item.place = problem.place or (0.0, 0.0)
