"""Pictures of plants from a Blender of its own, beside the one that the user works with."""

import json
import shutil
import subprocess
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path

import bpy
import numpy as np

from ..mesh.terrain_mesh import NotNow
from ..worker.launch import APART
from . import plant_mesh

SCRIPT = Path(__file__).with_name("picture_process.py")


class PictureProcess:
    """Renders in the order of `wanted`, dictionaries with `mesh` (arrays), `colors`, `tile` and
    `angles`. To be used with `with`: at its end the process is gone, and its files."""

    def __init__(self, wanted):
        self._folder = Path(tempfile.mkdtemp(prefix="orogen-", dir=bpy.app.tempdir or None))
        try:
            self._write(wanted)
            self._process = self._start()
        except BaseException:
            self._remove_files()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.kill()
        self._process.wait()
        self._remove_files()

    def picture(self, number):
        """Colours and normals of one of what is wanted, or None if they are not there yet."""
        ended = self._process.poll() is not None
        path = self._folder / f"{number}.npy"
        if path.exists():
            return np.load(path)
        if ended:
            raise NotNow(f"Pictures of plants could not be rendered: {self._obituary()}")
        return None

    def _obituary(self):
        """The last error that the process told of."""
        lines = (self._folder / "log").read_text("utf-8", "replace").splitlines()
        return next((line for line in reversed(lines) if "Error" in line), "it ended early")

    def _write(self, wanted):
        meshes = {
            f"{number}/{name}": one["mesh"][name]
            for number, one in enumerate(wanted)
            for name in plant_mesh.ARRAYS
        }
        np.savez(self._folder / "meshes.npz", **meshes)
        described = [
            {"colors": one["colors"], "angles": one["angles"], "tile": asdict(one["tile"])}
            for one in wanted
        ]
        (self._folder / "wanted.json").write_text(json.dumps(described), "utf-8")

    def _start(self):
        with open(self._folder / "log", "wb") as log:
            return subprocess.Popen(
                [*_blender(), "--", str(self._folder)],
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
                **APART,
            )

    def _remove_files(self):
        shutil.rmtree(self._folder, ignore_errors=True)


def _blender():
    """The program that this is, or the Python whose module it is."""
    if not bpy.app.binary_path:
        return [sys.executable, str(SCRIPT)]
    plain = ("--background", "--factory-startup", "--python-exit-code", "1")
    return [bpy.app.binary_path, *plain, "--python", str(SCRIPT)]
