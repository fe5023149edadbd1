"""The job type for Flamenco, compiled in a stand-in of its Manager; its tasks are run."""

import json
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

SCRIPT = Path(__file__).parents[2] / "python_addon/farm/orogen_batch.js"

# Of a setting, as in the Manager's API (schema AvailableJobSetting).
SETTING_KEYS = {
    "key", "type", "subtype", "choices", "propargs", "description", "label", "default", "eval",
    "evalInfo", "visible", "required", "editable",
}  # fmt: skip

# What Flamenco gives to scripts. As there, a task is copied when it is added.
MANAGER = """
const author = {
    Task(name, type) {
        if (!name || !type) throw "author.Task(name, type): both are required";
        return { name, type, commands: [], dependencies: [],
                 addCommand(command) { this.commands.push(command); },
                 addDependency(task) { this.dependencies.push(task.name); } };
    },
    Command(name, parameters) { return { name, parameters }; },
};
function compile(settings) {
    const tasks = [];
    compileJob({ settings, addTask(task) { tasks.push(JSON.parse(JSON.stringify(task))); } });
    return JSON.stringify(tasks);
}
"""


@pytest.fixture
def script():
    racer = pytest.importorskip("py_mini_racer").MiniRacer()
    racer.eval(MANAGER + SCRIPT.read_text(encoding="utf-8"))
    return racer


def job_type(script):
    return json.loads(script.eval("JSON.stringify(JOB_TYPE)"))


def compiled(script, **settings):
    known = {s["key"]: s.get("default") for s in job_type(script)["settings"]}
    assert settings.keys() <= known.keys()
    return json.loads(script.eval(f"compile({json.dumps({**known, **settings})})"))


@pytest.fixture
def settings(island, tmp_path):
    (tmp_path / "island.geojson").write_text(json.dumps(island))
    jobs = tmp_path / "jobs.jsonl"
    job = {"recipe": "island.geojson", "resolution": 32}
    jobs.write_text("".join(json.dumps({**job, "seed": i}) + "\n" for i in range(5)))
    return {
        "jobs_file": str(jobs),
        "output": str(tmp_path / "out"),
        "python": sys.executable,
        "count": 5,
        "blendfile": "/shared/scene.blend",
    }


def test_settings_are_what_flamenco_knows(script, settings):
    items = job_type(script)["settings"]
    for item in items:
        assert item.keys() <= SETTING_KEYS and item["description"], item
        assert item["type"] in ("string", "int32", "float", "bool")
        assert item.get("subtype", "") in (
            "",
            "file_path",
            "dir_path",
            "file_name",
            "hashed_file_path",
        )
        assert item.get("visible", "") in ("", "visible", "hidden", "submission", "web")
    count = next(item for item in items if item["key"] == "count")
    names = {
        "Path": Path,
        "bpy": SimpleNamespace(path=SimpleNamespace(abspath=str)),
        "settings": SimpleNamespace(**settings),
    }
    assert eval(count["eval"], names) == settings["count"]


def test_tasks_run(script, settings, tmp_path):
    tasks = compiled(script, **settings, formats=" vdb  ")
    assert [task["name"] for task in tasks] == [f"grow-{i}" for i in range(5)]
    for i in (1, 4):
        (command,) = tasks[i]["commands"]
        assert command["name"] == "exec"
        line = [command["parameters"]["exe"], *command["parameters"]["args"]]
        first = subprocess.run(line, capture_output=True, text=True, timeout=120)
        assert first.returncode == 0, first.stderr
        report = json.loads((tmp_path / f"out/000{i}/report.json").read_text())
        assert report["seed"] == i and report["formats"] == ["npz", "vdb"]
        again = subprocess.run(line, capture_output=True, text=True, timeout=120)
        assert again.returncode == 0 and "0 made, 1 already there" in again.stdout
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["0001", "0004"]


def test_render_waits_for_all(script, settings):
    *growing, render = compiled(script, **settings, render_output="/renders/####", frames="1..3")
    assert render["dependencies"] == [task["name"] for task in growing]
    (command,) = render["commands"]
    parameters = command["parameters"]
    assert command["name"] == "blender-render"
    assert (parameters["exe"], parameters["exeArgs"]) == ("{blender}", "{blenderArgs}")
    assert parameters["blendfile"] == settings["blendfile"]
    assert parameters["args"] == ["--render-output", "/renders/####", "--render-frame", "1..3"]
