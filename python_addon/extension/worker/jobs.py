"""Jobs: one warm worker for the whole session, and at most one job that counts.

A job is a plain object that is polled. Starting another one makes the earlier one `superseded`.
"""

import itertools
import time
from dataclasses import dataclass, field

from .launch import NoCore
from .process import WorkerProcess
from .result import Result

RUNNING, DONE, FAILED, CANCELLED, SUPERSEDED = (
    "RUNNING",
    "DONE",
    "FAILED",
    "CANCELLED",
    "SUPERSEDED",
)


@dataclass
class Job:
    number: int
    state: str = RUNNING
    stage: str = "starting"
    fraction: float = 0.0
    message: str = ""
    result: Result | None = field(default=None, repr=False)


class Jobs:
    def __init__(self):
        self._worker = None
        self._numbers = itertools.count(1)
        self._current = None
        self.temporary_folder = None

    @property
    def worker_pid(self):
        return self._worker.pid if self._worker and self._worker.alive else None

    def start(self, recipe, resolution=None, threads=0):
        """Starts to grow a terrain; raises NoCore or OSError where no worker can be had."""
        return self._start("generate", recipe=recipe, resolution=resolution, threads=threads)

    def start_rocks(self, recipe, kind, **more):
        """Starts to make meshes of the rocks below the terrain of a recipe; raises the same."""
        return self._start("rocks", recipe=recipe, kind=kind, **more)

    def start_growth(self, recipe):
        """Starts to grow a terrain with the frames that its recipe asks for; raises the same."""
        return self._start("growth", recipe=recipe)

    def _start(self, what, **request):
        if self._current and self._current.state == RUNNING:
            self._current.state = SUPERSEDED
        if self._worker is None or not self._worker.alive:
            self._worker = WorkerProcess(self.temporary_folder)
        self._current = Job(next(self._numbers))
        self._worker.send(what, job=self._current.number, **request)
        return self._current

    def cancel(self, job):
        """The job counts as cancelled at once, whatever the worker still says about it."""
        if job.state == RUNNING:
            job.state = CANCELLED
            self._worker.send("cancel", job=job.number)

    def poll(self):
        """Takes in what the worker has said so far. Never waits."""
        while self._worker and (answer := self._worker.poll()):
            self._take(answer)

    def wait(self, job, timeout=None):
        """Waits until the job is over (scripts, background)."""
        end = time.monotonic() + timeout if timeout else None
        while job.state == RUNNING:
            if answer := self._worker.poll(timeout=0.1):
                self._take(answer)
            elif end and time.monotonic() > end:
                self.cancel(job)
        return job

    def shutdown(self):
        if self._worker:
            self._worker.stop()
        self._worker = self._current = None

    def _take(self, answer):
        job, say = self._current, answer["say"]
        if say == "died":
            self._worker = None
            if job and job.state == RUNNING:
                job.state, job.message = FAILED, answer["message"]
        elif say == "done" and not (job and job.number == answer["job"] and job.state == RUNNING):
            Result(answer).close()  # nobody wants it any more
        elif not job or job.state != RUNNING or answer.get("job") != job.number:
            return
        elif say == "progress":
            job.stage, job.fraction = answer["stage"], answer["fraction"]
        elif say == "done":
            self._finish(job, answer)
        elif say == "failed":
            job.state, job.message = FAILED, answer["message"]
        elif say == "cancelled":
            job.state = CANCELLED

    @staticmethod
    def _finish(job, answer):
        try:
            job.result = Result(answer)
            job.state, job.fraction = DONE, 1.0
        except OSError as error:  # the worker died after its answer, and its files with it
            job.state, job.message = FAILED, f"The worker's result is gone: {error}"


jobs = Jobs()

__all__ = ["CANCELLED", "DONE", "FAILED", "RUNNING", "SUPERSEDED", "Job", "Jobs", "NoCore", "jobs"]
