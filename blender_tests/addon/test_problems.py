"""What is wrong with a drawing is told where it is wrong."""


def island(**settings):
    import bpy
    from test_starts import draw_island, started

    terrain = started("DRAWING")
    draw_island(terrain)
    bpy.context.scene.cursor.location = (0, 0, 0)
    return terrain, terrain.orogen.drawing.objects[0]


def problems(terrain):
    return [(p.text, tuple(p.place) if p.has_place else None) for p in terrain.orogen.problems]


def test_peak_at_sea_is_marked_and_shown():
    import bpy
    import numpy as np
    import steps

    terrain, _ = island()
    terrain.location = (5, 5, 0)
    steps.addon("scene.new_inputs").add_peak(terrain, "Lost", (32e3, 30e3), 900.0)
    assert "out at sea" in steps.refused(bpy.ops.orogen.check_drawing)
    (problem,) = terrain.orogen.problems
    assert problem.is_error and np.allclose(problem.place, (32e3, 30e3), atol=1.0)
    assert bpy.ops.orogen.show_problem(index=0) == {"FINISHED"}
    assert np.allclose(bpy.context.scene.cursor.location, (37, 35, 0), atol=0.01)
    assert "no place" in steps.refused(bpy.ops.orogen.show_problem, index=1)
    assert len(terrain.data.vertices) == 0, "checking grows nothing"


def test_crossing_coasts_are_marked():
    import bpy
    import numpy as np
    import steps
    from test_drawing import add_stroke

    terrain, pencil = island()
    add_stroke(pencil, "Coast", [(20, 0, 0), (33, 0, 0), (33, 9, 0), (20, 9, 0)], cyclic=True)
    assert "crosses" in steps.refused(bpy.ops.orogen.grow)
    (problem,) = terrain.orogen.problems
    x, y = np.array(problem.place) / 1000
    assert 25 < x < 30 and (abs(y) < 0.01 or abs(y - 9) < 0.01)


def test_what_was_mended_is_marked_and_goes_when_it_is_right():
    import bpy
    import numpy as np
    import steps
    from test_drawing import add_stroke

    terrain, pencil = island()
    terrain.orogen.resolution = 64
    steps.grow()
    before = problems(terrain)
    add_stroke(pencil, "Rivers", [(-10, -10, 0), (-14, -12, 0), (-17, -13, 0)])
    assert bpy.ops.orogen.check_drawing() == {"FINISHED"}
    added = [found for found in problems(terrain) if found not in before]
    assert added and all("river" in text for text, _ in added)
    assert any(np.allclose(place, (-17e3, -13e3), atol=2e3) for _, place in added), added
    terrain.orogen.input.join_tolerance = 0.001
    add_stroke(pencil, "Coast", [(-33, -38, 0), (-30, -38, 0), (-31, -36, 0)])
    steps.grow()
    told = {place: text for text, place in problems(terrain) if "The coast is open" in text}
    place = min(told, key=lambda place: np.hypot(place[0] + 32e3, place[1] + 37e3))
    assert "gap of 2.8 km" in told[place] and np.allclose(place, (-32e3, -37e3), atol=1.0)


def test_plates_that_meet_are_marked():
    import bpy
    import numpy as np
    import steps
    from test_plates_in import arrows, plates_terrain

    terrain = plates_terrain()
    for arrow in arrows(terrain, "South"):
        arrow.empty_display_size = 90.0
    bpy.context.view_layer.update()
    assert "after the move" in steps.refused(bpy.ops.orogen.check_drawing)
    (problem,) = terrain.orogen.problems
    assert problem.is_error and problem.has_place and np.hypot(*problem.place) < 30e3
    assert problem.text.startswith("South and North: their rigid parts meet")
    for arrow in arrows(terrain, "South"):
        arrow.rotation_euler = (0, 0, 0)
    bpy.context.view_layer.update()
    bpy.ops.orogen.check_drawing()
    assert "No plate moves" in terrain.orogen.problems[0].text


def test_no_marks_for_places_that_are_not_of_the_scene():
    """A map in degrees names degrees."""
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    assert terrain.orogen.problems and not any(p.has_place for p in terrain.orogen.problems)
