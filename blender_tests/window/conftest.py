"""Runs a script in a real Blender window and hands over what it found.

Needs root, debootstrap and a few minutes the first time: a small Debian with Blender is made in
.env/window-SUITE. The pictures stay in out/window/NAME/.
"""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

HERE = Path(__file__).parent
PROJECT = HERE.parent.parent
SUITE = os.environ.get("OROGEN_WINDOW_SUITE", "trixie")
ROOT = Path(os.environ.get("OROGEN_WINDOW_ROOT", PROJECT / f".env/window-{SUITE}"))


@pytest.fixture(scope="session")
def root():
    """The folder of the small Debian."""
    if "OROGEN_ZIP" not in os.environ:
        pytest.skip("OROGEN_ZIP does not name the extension's zip")
    if os.geteuid() != 0 or not shutil.which("debootstrap"):
        pytest.skip("a window needs root and debootstrap")
    if not (ROOT / "usr/bin/blender").exists():
        subprocess.run([HERE / "make_root.sh", SUITE, ROOT], check=True, timeout=1200)
    return ROOT


@pytest.fixture(scope="session")
def run_script(root, tmp_path_factory):
    """A function: runs NAME_script.py in the window; what it found, as a dictionary. `changes`:
    text of the script, and what takes its place."""

    def run(name, timeout=400, changes=None):
        job = tmp_path_factory.mktemp(name)
        shutil.copy(os.environ["OROGEN_ZIP"], job)
        shutil.copy(HERE / "window_tools.py", job)
        script = (HERE / f"{name}_script.py").read_text()
        for before, after in (changes or {}).items():
            script = script.replace(before, after)
        (job / "script.py").write_text(f"import sys\nsys.path.insert(0, '/job')\n{script}")
        shutil.rmtree(root / "tmp/blender_user", ignore_errors=True)
        command = [HERE / "run_window.sh", root, job, "script.py"]
        output = subprocess.run(command, timeout=timeout, capture_output=True, text=True)
        pictures = PROJECT / "out/window" / name
        shutil.rmtree(pictures, ignore_errors=True)
        shutil.copytree(job / "out", pictures)
        said = output.stdout + output.stderr
        if not (job / "out/result.json").exists():
            pytest.fail(said[-6000:], pytrace=False)
        result = json.loads((job / "out/result.json").read_text())
        if result["error"]:
            pytest.fail(f"{json.dumps(result, indent=1)}\n{result['error']}", pytrace=False)
        return {**result, "output": said}

    return run
