"""The workflow of releases: what it names is there, and it covers Blender's platforms."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def workflow():
    yaml = pytest.importorskip("yaml")
    return yaml.safe_load((ROOT / ".github/workflows/release.yml").read_text(encoding="utf-8"))


def scripts(workflow):
    return [
        step["run"] for job in workflow["jobs"].values() for step in job["steps"] if "run" in step
    ]


def test_jobs_wait_for_jobs_that_exist(workflow):
    jobs = workflow["jobs"]
    assert list(jobs["extension"]["needs"]) == ["linux", "others"]
    for job in jobs.values():
        needs = job.get("needs", [])
        assert set([needs] if isinstance(needs, str) else needs) <= jobs.keys()
        for step in job["steps"]:
            assert ("run" in step) != ("uses" in step), step


@pytest.mark.skipif(not shutil.which("bash"), reason="wants bash")
def test_commands_exist(workflow):
    text = "\n".join(scripts(workflow))
    for script in scripts(workflow):
        plain = re.sub(r"\$\{\{.*?\}\}", "x", script)
        assert subprocess.run(["bash", "-n"], input=plain, text=True).returncode == 0, script
    for file in re.findall(r"python (\S+\.py)", text):
        assert (ROOT / file).is_file(), file
    front_door = (ROOT / "dev").read_text()
    commands = re.findall(r"\./dev (\w+)", text)
    assert "package" in commands
    for command in commands:
        assert f"dev_{command}()" in front_door, command


def test_version_is_found(workflow):
    (line,) = [x for x in "\n".join(scripts(workflow)).splitlines() if x.startswith("version=")]
    shell = ["bash", "-c", f'{line}; printf %s "$version"']
    found = subprocess.run(shell, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert f"project(Orogen VERSION {found}" in (ROOT / "CMakeLists.txt").read_text() and found


def test_every_platform_and_python_is_built(workflow):
    sys.path.insert(0, str(ROOT / "python_addon"))
    import build

    runners = {
        *workflow["jobs"]["linux"]["strategy"]["matrix"]["runner"],
        *(item["runner"] for item in workflow["jobs"]["others"]["strategy"]["matrix"]["include"]),
    }
    platform = {
        "ubuntu-22.04": "linux-x64",
        "ubuntu-22.04-arm": "linux-arm64",
        "macos-15-intel": "macos-x64",
        "macos-15": "macos-arm64",
        "windows-2022": "windows-x64",
    }
    assert {platform[runner] for runner in runners} == {name for *_, name in build.PLATFORMS}
    pythons = workflow["env"]["OROGEN_PYTHONS"].split()
    for job in ("linux", "others"):
        text = str(workflow["jobs"][job])
        for python in pythons:
            assert python in text or f"cp{python.replace('.', '')}-*" in text
