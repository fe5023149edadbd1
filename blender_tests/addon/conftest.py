"""Tests of the built zip, each in a process of its own with the bpy of the running Python.

OROGEN_ZIP names the zip. It is installed once, into an empty folder of user resources. A test is a
plain function without fixtures other than `tmp_path`; its body runs in the other process.
"""

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
TIMEOUT = 400  # s


def _run(arguments, resources):
    command = [sys.executable, "-P", str(HERE / "in_blender.py"), *map(str, arguments)]
    environment = {**os.environ, "BLENDER_USER_RESOURCES": str(resources)}
    environment.pop("PYTHONPATH", None)  # the zip must bring what it needs
    try:
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, timeout=TIMEOUT
        )
    except subprocess.TimeoutExpired as expired:
        output = (expired.stdout or b"").decode() + (expired.stderr or b"").decode()
        pytest.fail(f"no end after {TIMEOUT} s\n{output[-6000:]}", pytrace=False)
    if done.returncode:
        output = (done.stdout + done.stderr)[-6000:]
        pytest.fail(f"exit status {done.returncode}\n{output}", pytrace=False)


@pytest.fixture(scope="session")
def resources(tmp_path_factory):
    if importlib.util.find_spec("bpy") is None:
        pytest.skip("this Python has no bpy")
    if "OROGEN_ZIP" not in os.environ:
        pytest.skip("OROGEN_ZIP does not name the extension's zip")
    folder = tmp_path_factory.mktemp("resources")
    _run(["install", Path(os.environ["OROGEN_ZIP"]).resolve()], folder)
    return folder


@pytest.fixture(autouse=True)
def _installed(resources):
    pass


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem):
    resources = pyfuncitem.funcargs["resources"]
    arguments = ["test", pyfuncitem.path, pyfuncitem.name]
    if "tmp_path" in pyfuncitem.funcargs:
        arguments.append(pyfuncitem.funcargs["tmp_path"])
    _run(arguments, resources)
    return True
