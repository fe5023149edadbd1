"""Feature curves and polygons of an island in a real Blender window."""

import pytest


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("island")


def test_outlines_of_curves_follow_edits_alone(found):
    assert "Traceback" not in found["output"] and found["message_curves"] == ""
    assert found["made_anew_without_an_edit"] == 0 and found["made_anew_after_an_edit"] > 0


def test_a_curve_is_edited_live_and_undone(found):
    assert found["rise"] > 1.0  # of 1.5 km, exaggerated
    assert found["undone"] and found["ground_undone"] < 1e-5


def test_a_moved_spring_is_followed_and_undone(found):
    assert found["spring_back"] and found["springs_after_undo"] == 0


def test_a_polygon_is_changed_by_a_click(found):
    assert found["edits_after_undo"] == 0
