"""Jobs: one warm worker for the whole session, and at most one job that counts.

A job is a plain object that is polled. Starting another one makes the earlier one `superseded`.
Questions are answered beside the job that runs.
"""

import itertools
import time
from dataclasses import dataclass, field

from . import raster_files
from .launch import NoCore
from .process import WorkerProcess
from .remaining import note
from .result import Result, remove

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
    history: list = field(default_factory=list, repr=False)  # of the fraction: see remaining.py
    watched: bool = False
    paused: bool = False
    frame: Result | None = field(default=None, repr=False)  # the newest of growth that is watched
    result: Result | None = field(default=None, repr=False)

    def take_frame(self):
        """The newest frame, once; None if there is no new one. The taker closes it."""
        frame, self.frame = self.frame, None
        return frame

    def end(self, state, message=""):
        self.state, self.message = state, message
        if frame := self.take_frame():
            frame.close()


@dataclass
class Question:
    number: int
    answer: dict | None = None  # with "error" where there is none to be had


class Jobs:
    def __init__(self):
        self._worker = None
        self._questions = {}  # those without an answer, by number
        self._numbers = itertools.count(1)
        self._current = None
        self.temporary_folder = None

    @property
    def worker_pid(self):
        return self._worker.pid if self._worker and self._worker.alive else None

    @property
    def busy(self):
        return self._current is not None and self._current.state == RUNNING

    @property
    def watched(self):
        """The running job if its growth is watched, else None."""
        return self._current if self.busy and self._current.watched else None

    def start(self, recipe, resolution=None, threads=0, watch=False):
        """Starts to grow a terrain, with frames of mountains that grow if they are to be watched;
        raises NoCore or OSError where no worker can be had."""
        return self._start(
            "generate", recipe=recipe, resolution=resolution, threads=threads, watch=watch
        )

    def pack(self, values):
        """A raster for a preview's recipe, in a file of the worker's; raises the same."""
        if self.busy and not self._worker.alive:
            raise OSError("The worker process ended")  # poll ends its job first
        self._ensure_worker()
        return raster_files.pack(self._worker.exchange, values)

    def start_preview(self, recipe):
        """Starts to grow a terrain as a preview; raises the same."""
        return self._start("preview", recipe=recipe)

    def start_variations(self, recipe, seeds):
        """Starts to grow previews of several seeds; raises the same."""
        return self._start("variations", recipe=recipe, seeds=seeds)

    def start_rocks(self, recipe, kind, **more):
        """Starts to make meshes of the rocks below the terrain of a recipe; raises the same."""
        return self._start("rocks", recipe=recipe, kind=kind, **more)

    def start_plants(self, recipe, layers, **more):
        """Starts to place the plants of a recipe's terrain, and to make meshes of them, as the
        core's worker_plants.py has it; raises the same."""
        return self._start("plants", recipe=recipe, layers=layers, **more)

    def start_growth(self, recipe):
        """Starts to grow a terrain with the frames that its recipe asks for; raises the same."""
        return self._start("growth", recipe=recipe)

    def _start(self, what, **request):
        if self.busy:
            self._current.end(SUPERSEDED)
        self._ensure_worker()
        self._current = Job(next(self._numbers), watched=request.get("watch", False))
        self._worker.send(what, job=self._current.number, **request)
        return self._current

    def ask(self, what, **request):
        """Asks what the worker answers at once; raises the same."""
        question = Question(next(self._numbers))
        if self.busy and not self._worker.alive:
            question.answer = {"error": "The worker process ended"}  # poll ends its job first
            return question
        self._ensure_worker()
        self._questions[question.number] = question
        self._worker.send(what, ask=question.number, **request)
        return question

    def _ensure_worker(self):
        if self._worker is None or not self._worker.alive:
            self._lose_questions("The worker process ended")
            self._worker = WorkerProcess(self.temporary_folder)

    def _lose_questions(self, message):
        while self._questions:
            self._questions.popitem()[1].answer = {"error": message}

    def cancel(self, job):
        """The job counts as cancelled at once, whatever the worker still says about it."""
        if job.state == RUNNING:
            job.end(CANCELLED)
            self._worker.send("cancel", job=job.number)

    def pause(self, job, paused):
        """Lets growth that is watched rest, or go on."""
        if job.state == RUNNING:
            job.paused, job.history = paused, []
            self._worker.send("pause", job=job.number, paused=paused)

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

    def wait_for_answer(self, question, timeout=5.0):
        """The answer to a question (operators); one with "error" if it does not come in time."""
        end = time.monotonic() + timeout
        while question.answer is None and time.monotonic() < end:
            if answer := self._worker.poll(timeout=0.02):
                self._take(answer)
        return question.answer or {"error": "The worker does not answer"}

    def shutdown(self):
        if self._worker:
            self._worker.stop()
        self._lose_questions("The worker was stopped")
        self._worker = self._current = None

    def _take(self, answer):
        job, say = self._current, answer["say"]
        if say == "died":
            self._worker = None
            self._lose_questions(answer["message"])
            if self.busy:
                job.end(FAILED, answer["message"])
        elif say == "answer":
            if question := self._questions.pop(answer["ask"], None):
                question.answer = answer
        elif not self.busy or answer.get("job") != job.number:
            if "file" in answer:
                remove(answer["file"])  # nobody wants it any more
        elif say == "progress":
            job.stage, job.fraction = answer["stage"], answer["fraction"]
            job.history = note(job.history, time.monotonic(), job.fraction)
        elif say == "frame":
            self._take_frame(job, answer)
        elif say == "done":
            self._finish(job, answer)
        elif say == "failed":
            job.end(FAILED, answer["message"])
        elif say == "cancelled":
            job.end(CANCELLED)

    @staticmethod
    def _take_frame(job, answer):
        if older := job.take_frame():
            older.close()
        try:
            job.frame = Result(answer)
        except OSError:  # the worker died, which it will be told soon
            pass

    @staticmethod
    def _finish(job, answer):
        try:
            job.result = Result(answer)
        except OSError as error:  # the worker died after its answer, and its files with it
            job.end(FAILED, f"The worker's result is gone: {error}")
        else:
            job.end(DONE)
            job.fraction = 1.0


jobs = Jobs()

__all__ = ["CANCELLED", "DONE", "FAILED", "RUNNING", "SUPERSEDED", "Job", "Jobs", "NoCore", "jobs"]
