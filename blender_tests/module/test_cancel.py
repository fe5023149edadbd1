"""Stopping: within half a second, at any moment, with nothing broken afterwards."""

import hashlib
import os
import random
import signal
import subprocess
import sys
import threading
import time

import orogen
import pytest

LIMIT = 0.5  # s


@pytest.fixture(autouse=True)
def sigint_counts():
    """A shell lets what it starts in the background ignore SIGINT."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="module")
def duration_and_digest(request):
    from conftest import ISLAND

    recipe = orogen.Recipe.from_dict({"orogen": 1, "name": "i", "resolution": 384, "map": ISLAND})
    durations = []
    for _ in range(3):  # the first run is the slowest, and machines are busy
        start = time.monotonic()
        terrain = orogen.generate(recipe, cache=None)
        durations.append(time.monotonic() - start)
    return recipe, min(durations), hashlib.sha256(terrain["elevation"].data).hexdigest()


def test_cancelled_at_random_moments(duration_and_digest):
    recipe, duration, digest = duration_and_digest
    moments = random.Random(1)
    late = []
    cache = orogen.Cache(1 << 28)
    for _ in range(50):
        moment = time.monotonic() + moments.uniform(0, duration)
        try:
            orogen.generate(
                recipe, cache=None, progress=lambda s, f, m=moment: time.monotonic() < m
            )
        except orogen.Cancelled:
            late.append(time.monotonic() - moment)
    assert len(late) > 10
    assert max(late) < LIMIT
    terrain = orogen.generate(recipe, cache=cache)
    assert hashlib.sha256(terrain["elevation"].data).hexdigest() == digest


def test_ctrl_c_without_progress(duration_and_digest):
    recipe, duration, digest = duration_and_digest
    for share in (0.02, 0.1, 0.2):
        timer = threading.Timer(share * duration, os.kill, (os.getpid(), signal.SIGINT))
        start = time.monotonic()
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            orogen.generate(recipe, cache=None)
        assert time.monotonic() - start < share * duration + LIMIT
    terrain = orogen.generate(recipe, cache=None)
    assert hashlib.sha256(terrain["elevation"].data).hexdigest() == digest


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
def test_ctrl_c_on_the_command_line_leaves_nothing(duration_and_digest, tmp_path):
    recipe, duration, _ = duration_and_digest
    file = tmp_path / "i.orogen.json"
    recipe.save(file)
    moments = random.Random(2)
    stopped = 0
    for run in range(6):
        output = tmp_path / f"out{run}"
        process = subprocess.Popen(
            [sys.executable, "-m", "orogen", "generate", file, "-o", output],
            stderr=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        time.sleep(0.2 + moments.uniform(0, duration))
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        if process.returncode == 0:
            continue
        stopped += 1
        # Before main is reached, or after it is done, Python itself says so: by the signal, or by 1
        # where it was importing.
        early = "KeyboardInterrupt" in errors and "in main" not in errors
        assert process.returncode in (130, -signal.SIGINT) or early, errors
        if process.returncode == 130:
            assert errors.strip() == "orogen: interrupted; nothing was written"
            assert not output.exists()
        assert not [name for name in os.listdir(tmp_path) if name.startswith(".orogen")]
    assert stopped > 0
