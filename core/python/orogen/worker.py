"""The worker: a process that holds the core, so that its host (Blender) does not.

It stays warm with the pipeline's cache, takes jobs as JSON lines on standard input and answers with
JSON lines on standard output. Arrays go through one file per job, which the host maps into memory.

Requests:
    {"do": "generate", "job": 7, "recipe": {...} or "path", "resolution": 512, "threads": 0,
     "watch": false}
        with `watch`, frames of mountains that grow, or are worn, are answered meanwhile
    {"do": "preview", "job": 7, "recipe": {...}}
        the terrain of preview.py; it has a cache of its own
    {"do": "variations", "job": 7, "recipe": {...}, "seeds": [1, 2, 3]}
        previews of each seed; their arrays are called "SEED/elevation" and so on
    {"do": "rocks", "job": 8, "recipe": ..., "kind": "block" or "section" or "horizons" ..., ...}
        what worker_rocks.py makes of that terrain: meshes of the rocks below, lines, files; the
        terrain is at hand if it was made last
    {"do": "plants", "job": 8, "recipe": ..., "layers": {"trees": {"most_plants": 1000000}}, ...}
        what worker_plants.py makes of that terrain: where plants stand, and their meshes; stages
        that plants need and the recipe lacks are done as well
    {"do": "growth", "job": 9, "recipe": ...}
        as generate, and the frames of growth that the recipe asks for
    {"do": "gestures", "ask": 3, "plates": [...], "origin": [x, y], "size": [width, height]}
        what worker_gestures.py says of plates as recipes have them, within that rectangle if
        there is one; a question, not a job: it is answered at once, whatever job runs
    {"do": "polygons", "ask": 4, "recipe": {...}}
        what worker_polygons.py says of that recipe's island; a question too
    {"do": "pause", "job": 7, "paused": true}
        growth that is watched rests, or goes on
    {"do": "cancel", "job": 7}
    {"do": "quit"}
Answers:
    {"say": "ready", "protocol": 1, "version": "0.1.0", "pid": 4711}
    {"say": "progress", "job": 7, "stage": "folds", "fraction": 0.4}
    {"say": "frame", "job": 7, "years": 2e6, "file": "...", "arrays": [...], "grid": {...}}
        the array "elevation" of growth that is watched, on a coarse grid; while water wears the
        ground, "water_depth" and "change" too
    {"say": "done", "job": 7, "file": "...", "arrays": [{"name", "dtype", "shape", "offset"}],
     "grid": {"nx", "ny", "cell_size", "origin"}, "warnings": [...],
     "rocks": [{"layer", "sub_layer", "number", "name", "lithology", "color"}]}
        of rocks the arrays are called "MESH/vertices", "MESH/faces", "MESH/color" and so on;
        of plants as worker_plants.py says, and "plants" is a list beside them;
        of growth there are heights too, "growth/0" and so on, and "years" is a list beside them
    {"say": "failed", "job": 7, "kind": "input" or "memory" or "error", "message": "..."}
    {"say": "cancelled", "job": 7}
    {"say": "answer", "ask": 3, "plates": [...], ...} or {"say": "answer", "ask": 3, "error": "..."}
        of polygons "centers" and so on

Every job is answered by exactly one of done, failed and cancelled. The latest job wins: a new one
cancels the one that runs and replaces the one that waits. When standard input ends (the host quit
or died) the worker removes its files and exits, at the latest after EXIT_GRACE seconds.

    python -m orogen.worker --exchange DIRECTORY
"""

import argparse
import faulthandler
import itertools
import json
import os
import shutil
import sys
import threading
import traceback

import orogen
from orogen.preview import generate_preview
from orogen.report import describe_grid
from orogen.worker_gestures import describe_gestures
from orogen.worker_jobs import Jobs
from orogen.worker_plants import make_plants, with_plants
from orogen.worker_polygons import describe_polygons
from orogen.worker_results import write_arrays
from orogen.worker_rocks import describe_rocks, make_meshes

PROTOCOL = 1
EXIT_GRACE = 2.0  # s
JOBS = ("generate", "preview", "variations", "rocks", "plants", "growth")
QUESTIONS = {"gestures": describe_gestures, "polygons": describe_polygons}


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
            if request["do"] in JOBS:
                replaced = self._jobs.put(request)
                if replaced is not None:
                    self._say("cancelled", job=replaced)
            elif request["do"] in QUESTIONS:
                self._say("answer", ask=request["ask"], **self._reply(request))
            elif request["do"] == "cancel":
                if self._jobs.cancel(request["job"]):
                    self._say("cancelled", job=request["job"])
            elif request["do"] == "pause":
                self._jobs.pause(request["job"], request["paused"])
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
        make = {
            "preview": self._preview,
            "variations": self._variations,
            "rocks": self._rocks,
            "plants": self._plants,
            "growth": self._growth,
        }.get(request["do"], self._generate)
        terrain, arrays, more = make(request)
        if self._jobs.cancelled:
            raise orogen.Cancelled("cancelled")
        return {
            "arrays": write_arrays(path, arrays),
            "grid": describe_grid(terrain.grid),
            "warnings": terrain.warnings,
            "rocks": describe_rocks(terrain),
            **more,
        }

    @staticmethod
    def _reply(request):
        try:
            return QUESTIONS[request["do"]](request)
        except Exception as error:  # whatever it is, the next request is read
            return {"error": str(error)}

    def _generate(self, request):
        terrain = self._terrain(request)
        return terrain, _fields(terrain), {}

    def _growth(self, request):
        terrain = self._terrain(request)
        frames = terrain.frames
        heights = {f"growth/{i}": frame["elevation"] for i, frame in enumerate(frames)}
        years = [frame["years"] for frame in frames]
        return terrain, _fields(terrain) | heights, {"years": years}

    def _rocks(self, request):
        terrain = self._terrain(request)
        meshes = make_meshes(terrain, request)
        arrays = {f"{name}/{k}": v for name, mesh in meshes.items() for k, v in mesh.items()}
        return terrain, arrays, {}

    def _plants(self, request):
        terrain = self._terrain(request)
        progress = self._progress(request)

        def go_on(stage, fraction):
            if not progress(stage, fraction):
                raise orogen.Cancelled("cancelled")

        arrays, plants = make_plants(terrain, request, go_on)
        return terrain, arrays, {"plants": plants}

    def _preview(self, request):
        terrain = generate_preview(request["recipe"], progress=self._progress(request))
        return terrain, _fields(terrain), {}

    def _variations(self, request):
        seeds, arrays = request["seeds"], {}
        for i, seed in enumerate(seeds):
            progress = self._progress(request, i / len(seeds), 1 / len(seeds))
            terrain = generate_preview(request["recipe"], seed, progress)
            arrays |= {f"{seed}/{name}": values for name, values in _fields(terrain).items()}
        return terrain, arrays, {}

    def _terrain(self, request):
        """The terrain of a request's recipe; that of the request before if it is the same."""
        recipe = request["recipe"]
        if isinstance(recipe, str):
            recipe = orogen.Recipe.load(recipe)
        else:
            recipe = orogen.Recipe.from_dict(recipe)
        if request["do"] == "plants":
            document = with_plants(recipe.to_dict(), orogen.schema()["stages"])
            recipe = orogen.Recipe.from_dict(document)
        wanted = (recipe.hash, request.get("resolution"))
        if request["do"] in ("rocks", "plants") and self._latest and self._latest[0] == wanted:
            return self._latest[1]
        self._latest = None  # its memory is wanted
        terrain = orogen.generate(
            recipe,
            resolution=request.get("resolution"),
            threads=request.get("threads", 0),
            progress=self._progress(request),
            watch=self._watch(request) if request.get("watch") else None,
        )
        self._latest = (wanted, terrain)
        return terrain

    def _progress(self, request, done=0.0, share=1.0):
        """Tells of a part of the whole work: the next `share`, after what is `done`."""

        def progress(stage, fraction):
            fraction = done + share * fraction
            self._say("progress", job=request["job"], stage=stage, fraction=fraction)
            return not self._jobs.cancelled

        return progress

    def _watch(self, request):
        number, count = request["job"], itertools.count()

        def watch(years, fields, grid):
            path = os.path.join(self._exchange, f"frame-{number}-{next(count)}.bin")
            arrays = write_arrays(path, fields)
            frame = {"arrays": arrays, "grid": describe_grid(grid), "years": years}
            self._say("frame", job=number, file=path, **frame)
            self._jobs.rest()

        return watch

    def _say(self, what, **more):
        line = json.dumps({"say": what, **more}) + "\n"
        with self._answer_lock:
            try:
                self._answers.write(line)
                self._answers.flush()
            except OSError:  # the host is gone; standard input says so too
                pass


def _fields(terrain):
    return {name: terrain[name] for name in terrain.fields}


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
