"""*Make Ready Scene* in a real Blender window; see ready_script.py."""

import pytest

LONGEST = 0.5  # s that the window's thread works between two looks at its events


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("ready", timeout=900)


def test_no_complaint(found):
    assert "Traceback" not in found["output"]


def test_esc_ends_the_rendering_and_keeps_the_scene(found):
    assert found["seconds_to_cancel"] < 1.0 and "Cancelled" in found["message_after_esc"]
    assert found["kept"]
    assert found["folders_while_rendering"] > 0 and found["folders_left"] == 0


def test_the_window_lives_on_and_shows_progress(found):
    assert found["worked_s"] < LONGEST
    assert found["in_order"] and len(found["fractions"]) > 3 and found["fractions"][-1] <= 1.0


def test_a_forest_stands_with_its_pictures(found):
    assert "The scene is ready" in found["message"] and found["impostors"] > 3
    assert {"trees", "ground_cover", "surroundings"} <= set(found["roles"])


def test_it_is_one_step_of_undo(found):
    assert found["undone"] and found["redone"]


def test_what_is_there_is_used_again(found):
    assert found["seconds_again"] < 0.7 * found["seconds"]


def test_plants_stand_on_ground_that_grew_anew(found):
    assert found["above_ground_m"] < 0.5
