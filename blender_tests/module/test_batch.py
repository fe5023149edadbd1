"""Many jobs from one file: in turn, in processes, on a cluster; and again after being killed."""

import concurrent.futures
import functools
import json
import multiprocessing
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import orogen
import pytest
from orogen import batch

COUNT = 100


def command(*arguments):
    return [sys.executable, "-m", "orogen", "batch", *map(str, arguments)]


def run(*arguments):
    return subprocess.run(command(*arguments), capture_output=True, text=True, timeout=300)


def write_jobs(file, jobs):
    file.write_text("".join(json.dumps(job) + "\n" for job in jobs), encoding="utf-8")
    return file


@pytest.fixture
def jobs_file(island, tmp_path):
    """A hundred tiny jobs: a map in a file, the recipe inside, other seeds, sizes, parameters."""
    (tmp_path / "island.geojson").write_text(json.dumps(island))
    inside = {"orogen": 1, "name": "inside", "map": {"file": "island.geojson"}}
    jobs = [
        {
            "recipe": inside if i % 2 else "island.geojson",
            "name": f"tile_{i}",
            "seed": i // 4,
            "resolution": (32, 40)[i // 2 % 2],
            "set": {"folds.octaves": 1 + i % 3},
        }
        for i in range(COUNT)
    ]
    return write_jobs(tmp_path / "jobs.jsonl", jobs)


def hashes(folder):
    found = {}
    for name in os.listdir(folder):
        report = folder / name / "report.json"
        if report.exists():
            found[name] = json.loads(report.read_text())["sha256"]
    return found


def in_turn(jobs, folder):
    for job in jobs:
        batch.run(job, folder)


def in_a_pool(jobs, folder):
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(2, context) as pool:
        list(pool.map(functools.partial(batch.run, folder=folder, threads=1), jobs))


def on_dask(jobs, folder):
    distributed = pytest.importorskip("distributed")
    with (
        pytest.importorskip("dask").config.set(temporary_directory=str(folder.parent)),
        distributed.LocalCluster(
            n_workers=2,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        assert len({w["id"] for w in client.scheduler_info()["workers"].values()}) == 2
        client.gather(client.map(functools.partial(batch.run, folder=folder, threads=1), jobs))


def test_every_executor_makes_the_same(jobs_file, tmp_path):
    jobs = batch.read_jobs(jobs_file)
    in_turn(jobs, tmp_path / "in_turn")
    expected = hashes(tmp_path / "in_turn")
    assert len(expected) == COUNT
    assert len({json.dumps(h) for h in expected.values()}) > COUNT // 2  # they do differ
    for executor in (in_a_pool, on_dask):
        executor(jobs, tmp_path / executor.__name__)
        assert hashes(tmp_path / executor.__name__) == expected


def test_command_line_makes_the_same(jobs_file, tmp_path):
    result = run(jobs_file, "-o", tmp_path / "out", "--jobs", 2)
    assert result.returncode == 0, result.stderr
    assert f"{COUNT} made, 0 already there, 0 failed" in result.stdout.splitlines()[-1]
    made = hashes(tmp_path / "out")
    assert len(made) == COUNT
    one = json.loads(jobs_file.read_text().splitlines()[42])
    document = orogen.Recipe.load(tmp_path / one["recipe"]).to_dict()
    document |= {"seed": one["seed"], "resolution": one["resolution"]}
    folds = next(item for item in document["stages"] if item["stage"] == "folds")
    folds["parameters"]["octaves"] = one["set"]["folds.octaves"]
    assert made["tile_42"] == orogen.generate(document).report["sha256"]


def test_killed_run_goes_on_where_it_was(jobs_file, tmp_path):
    out = tmp_path / "out"

    def reports():
        return {p.parent.name: p.stat().st_mtime_ns for p in out.glob("*/report.json")}

    done = {}
    for share in (0.2, 0.5, 0.7):  # killed three times, each time in the middle
        process = subprocess.Popen(
            command(jobs_file, "-o", out), stdout=subprocess.DEVNULL, start_new_session=True
        )
        while len(reports()) < share * COUNT:
            assert process.poll() is None, "it ended before it could be killed"
            time.sleep(0.002)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        assert done.items() <= reports().items(), "what was done was done again"
        done = reports()
        for name in done:
            assert (
                out / name / f"{json.loads((out / name / 'report.json').read_text())['name']}.npz"
            ).exists()
    result = run(jobs_file, "-o", out)
    assert result.returncode == 0, result.stderr
    assert f"{COUNT - len(done)} made, {len(done)} already there" in result.stdout
    assert done.items() <= reports().items()
    in_turn(batch.read_jobs(jobs_file), tmp_path / "in_turn")
    assert hashes(out) == hashes(tmp_path / "in_turn")
    assert not list(out.glob("**/.orogen-*"))


@pytest.mark.skipif(not os.path.exists("/proc/self/stat"), reason="reads /proc")
def test_killed_run_leaves_no_process(jobs_file, tmp_path):
    out = tmp_path / "out"
    process = subprocess.Popen(
        command(jobs_file, "-o", out, "--jobs", 2),
        stdout=subprocess.DEVNULL,
        start_new_session=True,
    )
    while not list(out.glob("*/report.json")):
        assert process.poll() is None
        time.sleep(0.01)
    process.kill()  # that one alone
    process.wait()
    deadline = time.monotonic() + 20
    while session_members(process.pid) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert session_members(process.pid) == []


def session_members(session):
    """Ids of the living processes of a session."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, _, its_session = stat.read_text().rpartition(")")[2].split()[:4]
        except (OSError, ValueError):
            continue
        if int(its_session) == session and state != "Z":
            found.append(int(stat.parent.name))
    return found


def test_interrupted_run_says_so(jobs_file, tmp_path):
    process = subprocess.Popen(
        command(jobs_file, "-o", tmp_path / "out", "--jobs", 2),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
        text=True,
    )
    process.stdout.readline()
    os.killpg(process.pid, signal.SIGINT)
    _, complaint = process.communicate(timeout=60)
    assert process.returncode == 130
    lines = [line for line in complaint.splitlines() if "warning" not in line]
    assert lines == ["orogen: interrupted; the same command goes on from here"]


def test_index_picks_a_job(jobs_file, tmp_path):
    out = tmp_path / "out"
    assert run(jobs_file, "-o", out, "--index", 7).returncode == 0
    assert os.listdir(out) == ["tile_7"]
    for index in (-1, COUNT):
        result = run(jobs_file, "-o", out, "--index", index)
        assert result.returncode == 2 and f"--index: {index}" in result.stderr
        assert len(result.stderr.splitlines()) == 1


def test_what_changed_is_made_again(island, tmp_path):
    out = tmp_path / "out"
    job = {"recipe": {"orogen": 1, "name": "a", "resolution": 32, "map": island}, "name": "a"}
    assert batch.run(job, out)["recipe_sha256"] == batch.recipe_of(job).hash
    (out / "a/notes.txt").write_text("mine")
    (out / "a/.orogen-left").mkdir()
    assert batch.run(job, out) is None
    assert batch.run(job, out, ["npz", "vdb"]) and (out / "a/ground.vdb").exists()
    assert batch.run(job, out) is None  # there is more than is wanted
    assert batch.run({**job, "seed": 5}, out)["seed"] == 5
    assert batch.run({**job, "seed": 5, "resolution": 40}, out)["grid"]["nx"] == 40
    report = out / "a/report.json"
    older = json.loads(report.read_text()) | {"version": "0.0.1"}
    report.write_text(json.dumps(older))
    assert batch.run({**job, "seed": 5, "resolution": 40}, out)["version"] == orogen.__version__
    report.write_text("{")
    assert batch.run({**job, "seed": 5, "resolution": 40}, out)
    assert (out / "a/notes.txt").read_text() == "mine"
    assert not (out / "a/.orogen-left").exists()


def test_names(tmp_path):
    file = write_jobs(tmp_path / "jobs.jsonl", [{"recipe": "imaginary"}] * 2)
    file.write_text("\n" + file.read_text() + "\n")
    assert [job["name"] for job in batch.read_jobs(file)] == ["0000", "0001"]


def test_the_guide_shows_jobs_that_work(island, tmp_path):
    guide = (Path(__file__).parents[2] / "docs/farm.md").read_text(encoding="utf-8")
    lines = re.search(r"```json\n(.*?)```", guide, re.DOTALL)[1]
    (tmp_path / "coast.geojson").write_text(json.dumps(island))
    (tmp_path / "jobs.jsonl").write_text(lines)
    jobs = batch.read_jobs(tmp_path / "jobs.jsonl")
    batch.check(jobs)
    assert (
        batch.recipe_of(jobs[0]).to_dict()["stages"] != batch.recipe_of(jobs[1]).to_dict()["stages"]
    )


GOOD = {"recipe": "imaginary", "resolution": 32}


@pytest.mark.parametrize(
    "line, says",
    [
        ("{", "JSON"),
        ("[" * 100000, "JSON"),
        ("[]", "no job"),
        ('{"seed": 1}', "no job"),
        ('{"recipe": 3}', "no job"),
        ('{"recipe": "imaginary", "sed": 1}', "sed"),
        ('{"recipe": "nowhere.geojson"}', "nowhere.geojson"),
        ('{"recipe": {"orogen": 1}}', "map"),
        ('{"recipe": "imaginary", "seed": -1}', "seed"),
        ('{"recipe": "imaginary", "seed": 1e999}', "seed"),
        ('{"recipe": "imaginary", "resolution": 1}', "resolution"),
        ('{"recipe": "imaginary", "name": "../up"}', "../up"),
        ('{"recipe": "imaginary", "name": ".hidden"}', ".hidden"),
        ('{"recipe": "imaginary", "name": "FIRST"}', "line 1"),
        ('{"recipe": "imaginary", "set": {"erosoin.rain": 1}}', "erosoin"),
        ('{"recipe": "imaginary", "set": {"folds.octavse": 1}}', "octavse"),
        ('{"recipe": "imaginary", "set": {"folds.octaves": -1}}', "octaves"),
        ('{"recipe": "imaginary", "set": ["folds.octaves"]}', "set"),
    ],
)
def test_bad_line_is_named_before_any_work(tmp_path, line, says):
    file = tmp_path / "jobs.jsonl"
    file.write_text(json.dumps({**GOOD, "name": "first"}) + "\n" + line + "\n")
    result = run(file, "-o", tmp_path / "out")
    assert result.returncode == 2
    (message,) = result.stderr.splitlines()
    assert message.startswith("orogen: jobs.jsonl, line 2: ") and says in message
    assert os.listdir(tmp_path) == ["jobs.jsonl"]


def test_formats_are_checked_before_any_work(tmp_path):
    file = write_jobs(tmp_path / "jobs.jsonl", [GOOD])
    result = run(file, "-o", tmp_path / "out", "--format", "section")
    assert result.returncode == 2 and "line 1" in result.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("processes", [1, 2])
def test_failed_job_stops_no_other(tmp_path, processes):
    file = write_jobs(tmp_path / "jobs.jsonl", [GOOD | {"name": name} for name in "abc"])
    (tmp_path / "out").mkdir()
    (tmp_path / "out/b").write_text("a file where a folder is wanted")
    result = run(file, "-o", tmp_path / "out", "--jobs", processes)
    assert result.returncode == 2
    assert "2 made, 0 already there, 1 failed" in result.stdout
    assert [line for line in result.stderr.splitlines() if line.startswith("orogen: b: ")]
    assert "Traceback" not in result.stderr
    assert set(hashes(tmp_path / "out")) == {"a", "c"}
