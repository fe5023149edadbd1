"""A terrain of 4096 x 4096 cells in a real Blender window; see large_script.py.

It grows in tiles, and the window must not stand still for more than half a second. What steps of
undo cost is part of it, the drawing of 16 million faces by software is not.
"""

import pytest

LONGEST = 0.5  # s that the window's thread works between two looks at its events


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("large", timeout=900)


def test_no_complaint(found):
    assert "Traceback" not in found["output"]


def test_it_grows_in_tiles(found):
    assert found["tiles"] == 64 and found["message"] == ""


def test_the_window_lives_on(found):
    for gaps in (*(growth["gaps"] for growth in found["grown"]), found["shown"]["gaps"]):
        assert max(gap["worked_s"] for gap in gaps) < LONGEST
        assert gaps[0]["s"] < 4 * LONGEST  # by the clock, where other work goes on beside


def test_esc_while_tiles_are_made_keeps_the_older_ones(found):
    assert found["running_at_esc"] and found["kept"] and "Cancelled" in found["message_after_esc"]
    assert found["seconds_to_cancel"] < 1.0


def test_undo_goes_back_over_the_growth(found):
    assert found["undone"] == [[3, 64], [2, 64]]  # the seed, and how many tiles there are
    assert found["redone"] == [3, 64]
    assert max(found["seconds_to_undo"]) < 2 * LONGEST
