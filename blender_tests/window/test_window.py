"""The extension in a real Blender window: modal progress, Esc, undo; pictures to look at.

Needs root, debootstrap and a few minutes the first time: a small Debian with Blender 4.3 is made in
.env/window-trixie. The pictures stay in out/window/.
"""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

HERE = Path(__file__).parent
PROJECT = HERE.parent.parent
ROOT = Path(os.environ.get("OROGEN_WINDOW_ROOT", PROJECT / ".env/window-trixie"))
PICTURES = PROJECT / "out/window"


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    if "OROGEN_ZIP" not in os.environ:
        pytest.skip("OROGEN_ZIP does not name the extension's zip")
    if os.geteuid() != 0 or not shutil.which("debootstrap"):
        pytest.skip("a window needs root and debootstrap")
    if not (ROOT / "usr/bin/blender").exists():
        subprocess.run([HERE / "make_root.sh", "trixie", ROOT], check=True, timeout=1200)
    job = tmp_path_factory.mktemp("window")
    shutil.copy(os.environ["OROGEN_ZIP"], job)
    shutil.copy(HERE / "window_script.py", job)
    shutil.rmtree(ROOT / "tmp/blender_user", ignore_errors=True)
    command = [HERE / "run_window.sh", ROOT, job, "window_script.py"]
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
