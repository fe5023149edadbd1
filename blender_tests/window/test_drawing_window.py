"""Drawing and plates in a real Blender window."""

import pytest


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("drawing")


def test_a_drawn_map_grows(found):
    assert "Traceback" not in found["output"]
    assert found["strokes"] == ["coast", "river"], "two strokes of coast are one"
    assert found["points"] > 40 and found["off_the_plane"] < 1e-5
    assert found["peaks"] == 2 and found["gaps"] == 2
    assert found["vertices"] == 192 * 128 and found["message_draw_3_grown"] == ""


def test_a_start_is_one_undo_step(found):
    assert (found["objects"], found["undone"], found["redone"]) == (9, 0, 9)


def test_plates_grow_and_say_what_is_wrong(found):
    assert found["message_plates_2_grown"] == ""
    assert "rigid parts meet" in found["message_plates_3_problem"]
    assert found["placed"] == [True]
