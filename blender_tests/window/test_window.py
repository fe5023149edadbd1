"""The extension in a real Blender window: modal progress, Esc, undo; pictures to look at."""

import pytest


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("window")


def test_panels_draw_without_complaint(found):
    assert "Traceback" not in found["output"]
    assert "orogen" not in "".join(x for x in found["output"].splitlines() if "Warning" in x)


def test_growing_leaves_blender_free(found):
    assert found["invoke"] == ["RUNNING_MODAL"] and found["running"]
    assert found["vertices"] > 5000 and found["message"] == ""


def test_esc_stops_and_keeps_the_terrain(found):
    assert found["kept"] and "Cancelled" in found["message_after_esc"]
    assert found["seconds_to_cancel"] < 3.0  # 0.1 to 0.3 where the machine has nothing else to do


def test_cancel_button(found):
    assert found["cancel_button"]


def test_latest_job_wins(found):
    assert found["latest_wins"] and found["second_differs"]


def test_growth_is_one_undo_step(found):
    assert found["undone"] and found["redone"]


@pytest.mark.parametrize("kind", ["block", "section", "horizons"])
def test_rocks_come_in_the_background(found, kind):
    assert found[f"invoke_{kind}"] == ["RUNNING_MODAL"] and found[f"message_{kind}"] == ""
    assert found["rock_objects"] > 3


def test_growth_is_animated_and_esc_leaves_nothing(found):
    assert found["invoke_growth"] == ["RUNNING_MODAL"] and found["growth_kept"]
    assert found["growth_seconds_to_cancel"] < 3.0
    assert found["growth_frames"]


def test_deleted_terrain_costs_a_message(found):
    assert "gone" in found["message_when_gone"]


def test_loading_another_file_ends_the_job(found):
    assert not found["running_after_load"]
