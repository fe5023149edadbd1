"""The worker: a process that holds the core, so that its host (Blender) does not.

It stays warm with the pipeline's cache, takes jobs as JSON lines on standard input and answers with
JSON lines on standard output. Arrays go through one file per job, which the host maps into memory.

Requests:
    {"do": "generate", "job": 7, "recipe": {...} or "path", "resolution": 512, "threads": 0}
    {"do": "rocks", "job": 8, "recipe": ..., "kind": "block" or "section" or "horizons" ..., ...}
        what worker_rocks.py makes of that terrain: meshes of the rocks below, lines, files; the
        terrain is at hand if it was made last
    {"do": "growth", "job": 9, "recipe": ...}
        as generate, and the frames of growth that the recipe asks for
    {"do": "cancel", "job": 7}
    {"do": "quit"}
Answers:
    {"say": "ready", "protocol": 1, "version": "0.1.0", "pid": 4711}
    {"say": "progress", "job": 7, "stage": "folds", "fraction": 0.4}
    {"say": "done", "job": 7, "file": "...", "arrays": [{"name", "dtype", "shape", "offset"}],
     "grid": {"nx", "ny", "cell_size", "origin"}, "warnings": [...],
     "rocks": [{"layer", "sub_layer", "number", "name", "lithology", "color"}]}
        of rocks the arrays are called "MESH/vertices", "MESH/faces", "MESH/color" and so on;
        of growth there are heights too, "growth/0" and so on, and "years" is a list beside them
    {"say": "failed", "job": 7, "kind": "input" or "memory" or "error", "message": "..."}
    {"say": "cancelled", "job": 7}

Every job is answered by exactly one of done, failed and cancelled. The latest job wins: a new one
cancels the one that runs and replaces the one that waits. When standard input ends (the host quit
or died) the worker removes its files and exits, at the latest after EXIT_GRACE seconds.

    python -m orogen.worker --exchange DIRECTORY
"""

import argparse
import faulthandler
import json
import os
import shutil
import sys
import threading
import traceback

import orogen
from orogen.worker_results import write_arrays
from orogen.worker_rocks import describe_rocks, make_meshes

PROTOCOL = 1
EXIT_GRACE = 2.0  # s


class Jobs:
    """The job that runs, the one that waits, and what was asked of them; shared by two threads."""

    def __init__(self):
        self._changed = threading.Condition()
        self._waiting = None
        self._running = None  # number of the running job
        self._cancelled = False
        self._closed = False

    def put(self, request):
        """Takes a new job; returns the number of a waiting one that it replaces, or None."""
        with self._changed:
            replaced = self._waiting["job"] if self._waiting else None
            self._waiting = request
            self._cancelled = self._running is not None
            self._changed.notify()
            return replaced

    def cancel(self, number):
        """Cancels a job; returns True if it had not started, so that no one else answers it."""
        with self._changed:
            if self._waiting and self._waiting["job"] == number:
                self._waiting = None
                return True
            self._cancelled = self._cancelled or self._running == number
            return False

    def close(self):
        with self._changed:
            self._closed = self._cancelled = True
            self._changed.notify()

    def take(self):
        """Waits for the next job; None when there will be no more."""
        with self._changed:
            self._running = None
            self._changed.wait_for(lambda: self._waiting or self._closed)
            if self._closed:
                return None
            request, self._waiting = self._waiting, None
            self._running = request["job"]
            self._cancelled = False
            return request

    @property
    def cancelled(self):
        return self._cancelled


class Worker:
    def __init__(self, requests, answers, exchange):
        self._requests = requests
        self._answers = answers
        self._answer_lock = threading.Lock()
        self._exchange = exchange
        self._jobs = Jobs()
        self._latest = None  # what asked for the latest terrain, and that terrain

    def run(self):
        threading.Thread(target=self._read_requests, daemon=True).start()
        self._say("ready", protocol=PROTOCOL, version=orogen.__version__, pid=os.getpid())
        while request := self._jobs.take():
            self._answer(request)
        shutil.rmtree(self._exchange, ignore_errors=True)

    def _read_requests(self):
        for line in self._requests:
            request = json.loads(line)
            if request["do"] in ("generate", "rocks", "growth"):
                replaced = self._jobs.put(request)
                if replaced is not None:
                    self._say("cancelled", job=replaced)
            elif request["do"] == "cancel":
                if self._jobs.cancel(request["job"]):
                    self._say("cancelled", job=request["job"])
            elif request["do"] == "quit":
                break
        self._jobs.close()
        threading.Timer(EXIT_GRACE, self._abandon).start()

    def _abandon(self):
        shutil.rmtree(self._exchange, ignore_errors=True)
        os._exit(1)

    def _answer(self, request):
        number = request["job"]
        path = os.path.join(self._exchange, f"job-{number}.bin")
        try:
            done = self._hand_over(request, path)
        except orogen.Cancelled:
            self._say("cancelled", job=number)
        except orogen.InputError as error:
            self._say("failed", job=number, kind="input", message=str(error))
        except MemoryError as error:
            self._say("failed", job=number, kind="memory", message=str(error) or "out of memory")
        except Exception as error:
            traceback.print_exc()
            message = f"{type(error).__name__}: {error}"
            self._say("failed", job=number, kind="error", message=message)
        else:
            self._say("done", job=number, file=path, **done)

    def _hand_over(self, request, path):
        terrain = self._terrain(request)
        more = {}
        if request["do"] == "rocks":
            meshes = make_meshes(terrain, request)
            arrays = {f"{name}/{k}": v for name, mesh in meshes.items() for k, v in mesh.items()}
        else:
            arrays = {name: terrain[name] for name in terrain.fields}
        if request["do"] == "growth":
            frames = terrain.frames
            more["years"] = [frame["years"] for frame in frames]
            arrays |= {f"growth/{i}": frame["elevation"] for i, frame in enumerate(frames)}
        if self._jobs.cancelled:
            raise orogen.Cancelled("cancelled")
        grid = terrain.grid
        return {
            "arrays": write_arrays(path, arrays),
            "grid": {
                "nx": grid.nx,
                "ny": grid.ny,
                "cell_size": grid.cell_size,
                "origin": list(grid.origin),
            },
            "warnings": terrain.warnings,
            "rocks": describe_rocks(terrain),
            **more,
        }

    def _terrain(self, request):
        """The terrain of a request's recipe; that of the request before if it is the same."""
        number = request["job"]
        recipe = request["recipe"]
        if isinstance(recipe, str):
            recipe = orogen.Recipe.load(recipe)
        else:
            recipe = orogen.Recipe.from_dict(recipe)
        wanted = (recipe.hash, request.get("resolution"))
        if request["do"] == "rocks" and self._latest and self._latest[0] == wanted:
            return self._latest[1]
        self._latest = None  # its memory is wanted

        def progress(stage, fraction):
            self._say("progress", job=number, stage=stage, fraction=fraction)
            return not self._jobs.cancelled

        terrain = orogen.generate(
            recipe,
            resolution=request.get("resolution"),
            threads=request.get("threads", 0),
            progress=progress,
        )
        self._latest = (wanted, terrain)
        return terrain

    def _say(self, what, **more):
        line = json.dumps({"say": what, **more}) + "\n"
        with self._answer_lock:
            try:
                self._answers.write(line)
                self._answers.flush()
            except OSError:  # the host is gone; standard input says so too
                pass


def private_output():
    """Standard output for answers alone: whatever else prints goes to standard error."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8", newline="\n")
    os.dup2(2, 1)
    sys.stdout = sys.stderr
    return answers


def main():
    parser = argparse.ArgumentParser(prog="python -m orogen.worker", description=__doc__)
    parser.add_argument("--exchange", required=True, help="folder for the arrays; removed at exit")
    arguments = parser.parse_args()
    faulthandler.enable()
    answers = private_output()
    requests = open(0, encoding="utf-8", closefd=False)
    os.makedirs(arguments.exchange, exist_ok=True)
    Worker(requests, answers, arguments.exchange).run()


if __name__ == "__main__":
    main()
