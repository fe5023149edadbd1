"""Many terrains from one file of jobs, in any process that is at hand.

A file has one job a line, as JSON: `recipe` (a file, the name of a shipped recipe, or the recipe
itself), and if wanted `name` (of the job and its folder), `seed`, `resolution` and `set`, as in
{"recipe": "corsica", "name": "soft", "seed": 3, "set": {"folds.fold_strength": 0.5}}.

`run` is a plain function of plain arguments: any executor takes it (`concurrent.futures`, Dask).
A folder that holds a report is complete, so a job that is done is not done again, and a run that
was killed goes on where it was.
"""

import concurrent.futures
import json
import multiprocessing
import os
import re
import signal
import threading

from . import _core, files, pipeline

KEYS = ("recipe", "name", "seed", "resolution", "set")
NAME = re.compile(r"\w[\w.-]*")


def read_jobs(file):
    """The jobs of a file, as dictionaries; empty lines do not count.

    A job without a name is called by its number, from 0. Each gets a `place` (for messages) and a
    `folder`, where the files that it names are looked for: that of the file.

    Raises
    ------
    InputError
        A line is no job, or two have one name; the message names the line.
    """
    file = os.fspath(file)
    try:
        with open(file, encoding="utf-8") as stream:
            lines = stream.read().split("\n")
    except UnicodeDecodeError:
        raise _core.InputError(f"{file}: is no text in UTF-8") from None
    folder = os.path.dirname(os.path.abspath(file))
    jobs, place_of = [], {}
    for number, line in enumerate(lines, 1):
        if not line.strip():
            continue
        place = f"{os.path.basename(file)}, line {number}"
        job = _read_job(line, place, len(jobs))
        if other := place_of.get(job["name"].casefold()):
            raise _core.InputError(f"{place}: name: '{job['name']}' is taken by {other}")
        place_of[job["name"].casefold()] = place
        jobs.append({**job, "place": place, "folder": folder})
    return jobs


def _read_job(line, place, index):
    try:
        job = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise _core.InputError(f"{place}: is no JSON ({error})") from None
    if not isinstance(job, dict) or not isinstance(job.get("recipe"), str | dict):
        raise _core.InputError(f'{place}: is no job; {{"recipe": ...}} is wanted')
    if unknown := [key for key in job if key not in KEYS]:
        raise _core.InputError(f"{place}: '{unknown[0]}' is unknown; {', '.join(KEYS)} are known")
    job.setdefault("name", f"{index:04}")
    if not isinstance(job["name"], str) or not NAME.fullmatch(job["name"]):
        raise _core.InputError(
            f"{place}: name: {job['name']!r} is not allowed; letters, digits and _ . - are"
        )
    return job


def check(jobs, formats=("npz",)):
    """Raises InputError, naming the line, if one of these jobs cannot be done."""
    files.check_formats(formats)
    for job in jobs:
        recipe_of(job, formats)


def recipe_of(job, formats=()):
    """The recipe that a job asks for, an `orogen.Recipe`.

    InputError where it cannot be used, or its terrain cannot be written in these formats.
    """
    try:
        recipe = _recipe_of(job)
        files.check_recipe(recipe, formats)
        return recipe
    except _core.InputError as error:
        raise _core.InputError(f"{job.get('place', job['name'])}: {error}") from None


def _recipe_of(job):
    folder, wanted = job.get("folder", "."), job["recipe"]
    if isinstance(wanted, dict):
        recipe = pipeline.Recipe.from_dict(wanted, folder=folder)
    else:
        file = os.path.join(folder, wanted)
        recipe = pipeline.Recipe.load(file if os.path.exists(file) else wanted)
    document = recipe.to_dict()
    document |= {key: job[key] for key in ("seed", "resolution") if key in job}
    if not isinstance(job.get("set", {}), dict):
        raise _core.InputError('set: {"stage.parameter": value} is wanted')
    for name, value in job.get("set", {}).items():
        _set(document, name, value)
    return pipeline.Recipe.from_dict(document)


def _set(document, name, value):
    stage, _, parameter = name.partition(".")
    items = [item for item in document["stages"] if item["stage"] == stage]
    if not items:
        names = ", ".join(item["stage"] for item in document["stages"])
        raise _core.InputError(f"set: there is no stage '{stage}' in the recipe; it has {names}")
    for item in items:
        item["parameters"][parameter] = value


def run(job, folder, formats=("npz",), threads=0, progress=None):
    """Does a job, unless it is done.

    Parameters
    ----------
    job : dict
        As `read_jobs` gives it: `name`, `recipe` and so on.
    folder : path
        Where each job has a folder by its name.
    formats : sequence of str, optional
        See `orogen.files.save_terrain`.
    threads : int, optional
        Most threads to use; 0: all cores. The result does not depend on it.
    progress : callable, optional
        As in `orogen.generate`.

    Returns
    -------
    dict or None
        The report of the terrain that was made; None if it was there.
    """
    files.check_formats(formats)
    recipe = recipe_of(job, formats)
    place = os.path.join(os.fspath(folder), job["name"])
    if is_done(place, recipe, formats):
        return None
    terrain = pipeline.generate(recipe, threads=threads, progress=progress)
    os.makedirs(place, exist_ok=True)
    files.remove_unfinished(place)
    return terrain.save(place, formats)


def is_done(place, recipe, formats=("npz",)):
    """Whether a folder holds the recipe's terrain, of this version, in these formats."""
    try:
        with open(os.path.join(place, files.REPORT), encoding="utf-8") as stream:
            report = json.load(stream)
    except (OSError, ValueError):
        return False
    return (
        report.get("recipe_sha256") == recipe.hash
        and report.get("version") == _core.__version__
        and set(formats) <= set(report.get("formats", ()))
    )


def run_all(jobs, folder, formats=("npz",), threads=0, processes=1, progress=None):
    """Does jobs one after the other, or several at a time in processes of their own.

    Yields (job, result) as each ends; the result is what `run` returns, or the exception with
    which the job failed. The others go on.
    """
    if processes == 1:
        for job in jobs:
            yield job, _result(lambda job=job: run(job, folder, formats, threads, progress))
        return
    # A process that was forked from one with threads, such as the core's, may hang.
    context = multiprocessing.get_context("spawn")
    threads = threads or max(1, (os.cpu_count() or 1) // processes)
    with concurrent.futures.ProcessPoolExecutor(processes, context, _end_in_time) as pool:
        running = {pool.submit(run, job, folder, formats, threads): job for job in jobs}
        try:
            for future in concurrent.futures.as_completed(running):
                yield running[future], _result(future.result)
        finally:
            pool.shutdown(cancel_futures=True)


def _result(call):
    try:
        return call()
    except (_core.InputError, MemoryError, OSError, concurrent.futures.BrokenExecutor) as error:
        return error


def _end_in_time():
    """In a process of the pool: it ends at Ctrl-C, and when the process that started it is gone."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent():
    multiprocessing.parent_process().join()
    os._exit(1)
