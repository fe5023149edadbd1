"""One worker process and the lines that go to and fro.

Two threads read its output into queues, so that `poll` never waits. They touch nothing else.
"""

import json
import queue
import shutil
import signal
import subprocess
import tempfile
import threading
from collections import deque
from pathlib import Path

from . import launch

QUIT_PATIENCE = 3.0  # s


class WorkerProcess:
    def __init__(self, temporary_folder=None):
        self.exchange = Path(tempfile.mkdtemp(prefix="orogen-", dir=temporary_folder))
        self._answers = queue.SimpleQueue()
        self._complaints = deque(maxlen=20)  # the last lines of its standard error
        try:
            self._process = subprocess.Popen(
                launch.command(self.exchange),
                env=launch.environment(),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                encoding="utf-8",
                errors="replace",
                **launch.APART,
            )
        except BaseException:
            self._remove_files()
            raise
        self._readers = [
            threading.Thread(target=self._read_answers, daemon=True),
            threading.Thread(target=self._read_complaints, daemon=True),
        ]
        for reader in self._readers:
            reader.start()

    @property
    def pid(self):
        return self._process.pid

    @property
    def alive(self):
        return self._process.poll() is None

    def send(self, what, **more):
        """Sends a request; a worker that is gone is noticed by `poll`, not here."""
        try:
            self._process.stdin.write(json.dumps({"do": what, **more}) + "\n")
            self._process.stdin.flush()
        except (OSError, ValueError):
            pass

    def poll(self, timeout=0.0):
        """The next answer as a dict, or None. A dead worker's last one is {"say": "died"}."""
        try:
            return self._answers.get(timeout=timeout) if timeout else self._answers.get_nowait()
        except queue.Empty:
            return None

    def stop(self):
        """Ends the worker: asks first, then insists. Its files are gone afterwards."""
        self.send("quit")
        try:
            self._process.stdin.close()
        except OSError:
            pass
        try:
            self._process.wait(QUIT_PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._remove_files()

    def _read_answers(self):
        for line in self._process.stdout:
            try:
                self._answers.put(json.loads(line))
            except json.JSONDecodeError:
                self._complaints.append(line.rstrip())
        code = self._process.wait()
        self._readers[1].join(1.0)
        self._remove_files()
        self._answers.put({"say": "died", "message": self._obituary(code)})

    def _read_complaints(self):
        for line in self._process.stderr:
            self._complaints.append(line.rstrip())

    def _obituary(self, code):
        if code < 0:
            try:
                return f"The core crashed ({signal.Signals(-code).name}). Grow again to restart it"
            except ValueError:
                pass
        last = next((line for line in reversed(self._complaints) if line), "no message")
        return f"The worker process ended with status {code}: {last}"

    def _remove_files(self):
        shutil.rmtree(self.exchange, ignore_errors=True)
