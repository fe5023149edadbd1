"""The shortest way to a rendered range, in a real Blender window."""

import pytest


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("path", timeout=1200)


def test_at_most_twelve_keys_and_clicks(found):
    assert "Traceback" not in found["output"]
    assert len(found["presses"]) <= 12


def test_the_whole_frame_comes_into_view(found):
    assert found["seen"] > 90.0


def test_what_is_set_up_is_one_undo_step(found):
    assert found["taken_back"] == ["Orogen Camera", "Orogen Sun", "Terrain Surroundings"]


def test_the_picture_is_of_a_range_under_a_sky(found):
    sky, ground, contrast = found["picture"]
    assert sky > 0.4 and 0.1 < ground < sky and contrast > 0.05
