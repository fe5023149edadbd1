"""Drawing and plates in a real Blender window. The pictures stay in out/drawing/."""

import json
import os
import shutil
import subprocess

import pytest
from test_window import HERE, PROJECT, ROOT

PICTURES = PROJECT / "out/drawing"


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    if "OROGEN_ZIP" not in os.environ or not (ROOT / "usr/bin/blender").exists():
        pytest.skip("a zip and the window of test_window.py are wanted")
    job = tmp_path_factory.mktemp("drawing")
    shutil.copy(os.environ["OROGEN_ZIP"], job)
    shutil.copy(HERE / "drawing_script.py", job)
    shutil.rmtree(ROOT / "tmp/blender_user", ignore_errors=True)
    command = [HERE / "run_window.sh", ROOT, job, "drawing_script.py"]
    output = subprocess.run(command, timeout=400, capture_output=True, text=True)
    shutil.rmtree(PICTURES, ignore_errors=True)
    shutil.copytree(job / "out", PICTURES)
    if not (job / "out/result.json").exists():
        pytest.fail(output.stdout[-4000:] + output.stderr[-4000:], pytrace=False)
    result = json.loads((job / "out/result.json").read_text())
    if result["error"]:
        pytest.fail(result["error"], pytrace=False)
    result["output"] = output.stdout + output.stderr
    return result


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
