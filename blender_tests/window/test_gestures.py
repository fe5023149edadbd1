"""Arrows of plates in a real Blender window; see gestures_script.py. Figures and pictures stay in
out/gestures/."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

HERE = Path(__file__).parent
PROJECT = HERE.parent.parent
ROOT = Path(os.environ.get("OROGEN_WINDOW_ROOT", PROJECT / ".env/window-trixie"))
PICTURES = PROJECT / "out/gestures"


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    if "OROGEN_ZIP" not in os.environ:
        pytest.skip("OROGEN_ZIP does not name the extension's zip")
    if os.geteuid() != 0 or not shutil.which("debootstrap"):
        pytest.skip("a window needs root and debootstrap")
    if not (ROOT / "usr/bin/blender").exists():
        subprocess.run([HERE / "make_root.sh", "trixie", ROOT], check=True, timeout=1200)
    job = tmp_path_factory.mktemp("gestures")
    for file in (os.environ["OROGEN_ZIP"], HERE / "gestures_script.py", HERE / "window_tools.py"):
        shutil.copy(file, job)
    shutil.rmtree(ROOT / "tmp/blender_user", ignore_errors=True)
    command = [HERE / "run_window.sh", ROOT, job, "gestures_script.py"]
    output = subprocess.run(command, timeout=300, capture_output=True, text=True)
    shutil.rmtree(PICTURES, ignore_errors=True)
    shutil.copytree(job / "out", PICTURES)
    if not (job / "out/result.json").exists():
        pytest.fail(output.stdout[-4000:] + output.stderr[-4000:], pytrace=False)
    result = json.loads((job / "out/result.json").read_text())
    if result["error"]:
        pytest.fail(result["error"], pytrace=False)
    result["output"] = output.stdout + output.stderr
    return result


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
