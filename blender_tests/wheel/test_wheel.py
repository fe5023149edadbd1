"""The wheel as users get it, installed into an environment that holds little else."""

import importlib.metadata
import os
import re
import subprocess
import sys
from pathlib import Path

import orogen
import pytest

MODULE = Path(orogen._core.__file__)
SYSTEM_LIBRARIES = {
    "libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6", "libpthread.so.0", "libdl.so.2",
    "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1",
}  # fmt: skip


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def test_it_is_the_installed_one():
    assert Path(orogen.__file__).is_relative_to(sys.prefix)
    assert importlib.metadata.version("orogen").split("+")[0] == orogen.__version__


def test_nothing_but_the_entry_point_is_seen_from_outside():
    symbols = [line.split()[-1] for line in run("nm", "-D", "--defined-only", MODULE).splitlines()]
    assert symbols == ["PyInit__core"]


def test_what_blender_has_too_is_linked_in():
    needed = set(re.findall(r"\(NEEDED\).*\[(.+)\]", run("readelf", "-d", MODULE)))
    bundled = {name for name in needed if name.startswith("libGeographic")}
    assert needed and needed - bundled <= SYSTEM_LIBRARIES
    folder = MODULE.parent.parent / "orogen.libs"
    assert bundled == {file.name for file in folder.glob("*")}


def test_it_is_small():
    wheel = os.environ.get("OROGEN_WHEEL")
    if not wheel:
        pytest.skip("OROGEN_WHEEL names no wheel")
    assert Path(wheel).stat().st_size < 15e6


def test_it_grows_a_terrain(tmp_path):
    run(sys.executable, "-m", "orogen", "generate", "corsica", "-o", tmp_path, "--resolution", "64",
        "--format", "vdb")  # fmt: skip
    assert {"corsica.npz", "report.json", "ground.vdb"} <= {p.name for p in tmp_path.iterdir()}
