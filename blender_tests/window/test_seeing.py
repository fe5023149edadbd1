"""Fields, their legend, an export, in a real Blender window. The pictures stay in out/seeing/."""

import json
import os
import shutil
import subprocess

import pytest
from test_window import HERE, PROJECT, ROOT

PICTURES = PROJECT / "out/seeing"


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    if "OROGEN_ZIP" not in os.environ or not (ROOT / "usr/bin/blender").exists():
        pytest.skip("a zip and the window of test_window.py are wanted")
    job = tmp_path_factory.mktemp("seeing")
    shutil.copy(os.environ["OROGEN_ZIP"], job)
    shutil.copy(HERE / "seeing_script.py", job)
    shutil.rmtree(ROOT / "tmp/blender_user", ignore_errors=True)
    command = [HERE / "run_window.sh", ROOT, job, "seeing_script.py"]
    output = subprocess.run(command, timeout=300, capture_output=True, text=True)
    shutil.rmtree(PICTURES, ignore_errors=True)
    shutil.copytree(job / "out", PICTURES)
    if not (job / "out/result.json").exists():
        pytest.fail(output.stdout[-4000:] + output.stderr[-4000:], pytrace=False)
    result = json.loads((job / "out/result.json").read_text())
    if result["error"]:
        pytest.fail(f"{json.dumps(result, indent=1)}\n{result['error']}", pytrace=False)
    result["output"] = output.stdout + output.stderr
    return result


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
