"""A newcomer's way in a real Blender window, from the empty file to a saved terrain."""

import pytest


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("walk")


def test_no_complaint(found):
    assert "Traceback" not in found["output"]


def test_esc_stops_and_keeps_the_terrain(found):
    assert found["kept"]
    assert found["seconds_to_esc"] < 3.0  # 0.1 to 0.3 where the machine has nothing else to do


def test_keys_undo_and_redo(found):
    assert found["undone"] and found["redone"]


def test_a_loaded_file_grows_the_same_bytes(found):
    assert found["loaded"] and found["same_bytes"]
