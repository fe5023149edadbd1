"""Runs a script in a real Blender window and hands over what it found.

Needs root, debootstrap and a few minutes the first time: a small Debian with Blender is made in
.env/window-SUITE (OROGEN_WINDOW_SUITE: trixie with Blender 4.3, sid with 5.2), and where its Python
is none of the zip's, a wheel for it. The pictures stay in out/window/NAME/.
"""

import json
import os
import shutil
import subprocess
import zipfile
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
def archive(root, tmp_path_factory):
    """The extension's zip, with a wheel for this Blender's Python."""
    zip_file = Path(os.environ["OROGEN_ZIP"])
    (python,) = (path.name for path in root.glob("usr/bin/python3.[0-9][0-9]"))
    tag = f"-cp{python.removeprefix('python').replace('.', '')}-"
    if any(tag in name for name in zipfile.ZipFile(zip_file).namelist()):
        return zip_file
    subprocess.run([HERE / "make_wheel.sh", root], check=True, timeout=3600)
    (wheel,) = root.glob(f"wheel/*{tag}*.whl")
    return with_wheel(zip_file, wheel, tmp_path_factory.mktemp("zip") / zip_file.name)


def with_wheel(zip_file, wheel, file):
    with zipfile.ZipFile(zip_file) as before, zipfile.ZipFile(file, "w") as after:
        for name in before.namelist():
            data = before.read(name)
            if name == "blender_manifest.toml":
                line = f'wheels = ["./wheels/{wheel.name}", '.encode()
                data = data.replace(b"wheels = [", line)
            after.writestr(name, data)
        after.write(wheel, f"wheels/{wheel.name}")
    return file


@pytest.fixture(scope="session")
def run_script(root, archive, tmp_path_factory):
    """A function: runs NAME_script.py in the window; what it found, as a dictionary. `changes`:
    text of the script, and what takes its place."""

    def run(name, timeout=400, changes=None):
        job = tmp_path_factory.mktemp(name)
        shutil.copy(archive, job)
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
