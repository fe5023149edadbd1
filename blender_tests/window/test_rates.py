"""Previews that follow a drag in a real Blender window; see rates_script.py."""

import pytest


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("rates", timeout=600)


def test_no_complaint(found):
    assert "Traceback" not in found["output"]


def test_previews_follow_a_drag(found):
    """The rates that the project promises (10 and 20 a second) are of an idle machine."""
    assert found["map_moved"] and found["plates_moved"]
    for name, least in (("map", 3.0), ("corsica", 3.0), ("plates", 6.0)):
        rates = found[f"{name}_not_drawn"], found[f"{name}_grabbed"]
        assert rates[0]["updates_per_second"] > least
        assert rates[1]["updates_per_second"] > 0.1 and rates[1]["moved"] > 0.2
        spent = rates[0]["main_thread_ms"]
        assert spent["read"]["median"] < 10.0 and spent["write"]["median"] < 10.0
