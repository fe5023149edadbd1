"""Fields, their legend, an export, in a real Blender window."""

import pytest


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("seeing")


def test_legend_and_panels_draw_without_complaint(found):
    assert "Traceback" not in found["output"]


def test_a_field_shows_in_solid_view_and_its_choice_is_undone(found):
    assert found["solid"] == ["SOLID", "VERTEX"]
    assert found["undone"] == ["elevation", "Elevation"]


def test_lines_and_tiles_come(found):
    assert found["message_add_traces"] == found["message_add_rivers"] == ""
    assert found["add_traces"] == ["RUNNING_MODAL"] and found["tiles"] == 9


def test_export_goes_on_in_the_background(found):
    assert found["written"] and found["message_export"] == ""
