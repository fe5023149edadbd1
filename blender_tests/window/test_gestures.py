"""Arrows of plates in a real Blender window; see gestures_script.py."""

import pytest


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("gestures")


def test_no_complaint(found):
    assert "Traceback" not in found["output"]


@pytest.mark.parametrize("name", ["move", "turn"])
def test_arrows_follow_an_edit_in_its_undo_step(found, name):
    assert [key for key, holds in found[name].items() if not holds] == []


def test_each_edit_is_one_step(found):
    assert found["twice"] == [True] * 4 and found["twice_differ"] and found["given_up"]


def test_the_tool_draws_an_arrow(found):
    (x, y), (east, north) = found["drawn_arrow"]
    assert abs(x + 10e3) < 500.0 and abs(y - 24e3) < 500.0
    assert abs(east - 10e3) < 500.0 and abs(north + 10e3) < 500.0
    assert found["drawn_LEFTMOUSE"] == 1 and found["drawn_undone"] == 0


def test_given_up_it_leaves_nothing(found):
    assert found["drawn_ESC"] == found["drawn_RIGHTMOUSE"] == 0


def test_the_answer_comes_at_once(found):
    assert found["latency_not_drawn_ms"][0] < 200.0
