"""What importing costs, and what the module shows to its host."""

import shutil
import subprocess
import sys

import orogen
import pytest
from orogen import _core


def python(code):
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    ).stdout


def test_import_takes_no_heavy_module_along():
    loaded = python("import sys, orogen; print(*sys.modules)").split()
    assert not {"numpy", "PIL", "rasterio", "OpenEXR", "json.tool"} & set(loaded)


@pytest.mark.skipif(not shutil.which("nm"), reason="no nm")
def test_only_the_init_function_is_exported():
    lines = subprocess.run(
        ["nm", "-D", "--defined-only", _core.__file__], capture_output=True, text=True, check=True
    ).stdout.splitlines()
    assert [line.split()[-1] for line in lines] == ["PyInit__core"]


def test_public_names_exist():
    for name in orogen.__all__:
        assert getattr(orogen, name) is not None
    assert orogen.InputError.__module__ == "orogen"
