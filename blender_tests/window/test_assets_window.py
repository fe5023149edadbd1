"""Presets to choose from, and the asset library, in a real Blender window; see assets_script.py."""

import pytest

PRESETS = ["Corsica", "Digne", "Jura", "Rift", "Southern_Alps", "Volcanic_Island", "Zagros"]


@pytest.fixture(scope="module")
def found(run_script):
    return run_script("assets", timeout=600)


def test_no_complaint(found):
    assert "Traceback" not in found["output"]


def test_esc_stops_and_keeps_what_is_written(found):
    count = len(found["after_esc"])
    assert 0 < count < len(PRESETS) and not any(".part" in name for name in found["after_esc"])
    assert found["message_after_esc"] == f"Stopped: {count} of 7 terrains are in the folder"
    assert found["left_over"] == []


def test_all_presets_are_written(found):
    files = [*(f"{name}.blend" for name in PRESETS), "Parts.blend", "blender_assets.cats.txt"]
    assert found["written"] == sorted(files) and "asset library is in" in found["message"]


def test_a_terrain_is_appended_with_its_sea(found):
    assert any("Sea" in name for name in found["children"])
