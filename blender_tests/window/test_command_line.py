"""`blender -b FILE --command orogen`, in a real Blender with the extension from the zip."""

import json
import shutil
import subprocess

import pytest

JOB = "/command_line"  # in the root

SCENE = f"""
import bpy
for name, seed in (("North", 1), ("South", 2)):
    bpy.ops.orogen.add_terrain()
    terrain = bpy.context.object
    terrain.name, terrain.orogen.seed, terrain.orogen.resolution = name, seed, 64
bpy.ops.wm.save_as_mainfile(filepath="{JOB}/scene.blend")
"""

HASHES = """
import bpy, hashlib, json, numpy as np
found = {}
for ob in bpy.context.scene.objects:
    if ob.orogen.is_terrain and "elevation" in ob.data.attributes:
        values = np.empty(len(ob.data.vertices), np.float32)
        ob.data.attributes["elevation"].data.foreach_get("value", values)
        found[ob.name] = hashlib.sha256(values.tobytes()).hexdigest()
print("HASHES", json.dumps(found))
"""


def blender(root, *arguments):
    command = ["chroot", root, "/usr/bin/env", "-i", "PATH=/usr/bin:/bin", "HOME=/root"]
    command += ["LANG=C.UTF-8", f"BLENDER_USER_RESOURCES={JOB}/user", "blender"]
    return subprocess.run([*command, *arguments], capture_output=True, text=True, timeout=300)


def orogen(job, file, *arguments):
    done = blender(job.parent, "-b", f"{JOB}/{file}", "--command", "orogen", *arguments)
    assert "Traceback" not in done.stdout + done.stderr
    return done


def hashes(job, file):
    run = ["--python-exit-code", "1", "--python-expr", HASHES]
    done = blender(job.parent, "-b", f"{JOB}/{file}", *run)
    assert done.returncode == 0, done.stderr
    line = next(line for line in done.stdout.splitlines() if line.startswith("HASHES "))
    return json.loads(line.removeprefix("HASHES "))


@pytest.fixture(scope="module")
def job(root, archive):
    """The job's folder as seen from outside, with the extension installed and a scene saved."""
    folder = root / JOB.strip("/")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    shutil.copy(archive, folder / "orogen.zip")
    install = ["install-file", "--repo", "user_default", "--enable", f"{JOB}/orogen.zip"]
    done = blender(root, "--command", "extension", *install)
    assert done.returncode == 0, done.stdout + done.stderr
    done = blender(root, "-b", "--python-exit-code", "1", "--python-expr", SCENE)
    assert done.returncode == 0, done.stdout + done.stderr
    yield folder
    shutil.rmtree(folder)


def test_generate_saves_what_the_core_makes(job):
    done = orogen(job, "scene.blend", "generate", "--save", f"{JOB}/grown.blend")
    assert done.returncode == 0, done.stderr
    assert hashes(job, "scene.blend") == {}
    done = orogen(job, "scene.blend", "generate", "--export", f"{JOB}/out", "--format", "vdb")
    assert done.returncode == 0, done.stderr
    reports = {
        n: json.loads((job / f"out/{n}/report.json").read_text()) for n in ("North", "South")
    }
    expected = {name: report["sha256"]["elevation"] for name, report in reports.items()}
    assert hashes(job, "grown.blend") == expected
    assert (job / "out/South/ground.vdb").exists()


def test_generate_saves_in_place(job):
    shutil.copy(job / "scene.blend", job / "place.blend")
    done = orogen(job, "place.blend", "generate", "South", "--resolution", "48", "--threads", "1")
    assert done.returncode == 0 and "South: 1200 vertices" in done.stdout, done.stderr
    assert list(hashes(job, "place.blend")) == ["South"]


def test_recipe_and_report(job):
    assert orogen(job, "scene.blend", "recipe", "North", f"{JOB}/north.orogen.json").returncode == 0
    assert json.loads((job / "north.orogen.json").read_text())["seed"] == 1
    rows = orogen(job, "scene.blend", "report").stdout
    assert "Core: 0." in rows and "Blender: " in rows and "GPU: " in rows


@pytest.mark.parametrize(
    "arguments, says",
    [
        (["generate", "West"], "'West'"),
        (["generate", "--resolution", "1"], "--resolution: 1"),
        (["recipe", "North", "/nowhere/a.json"], "nowhere"),
    ],
)
def test_complaints(job, arguments, says):
    done = orogen(job, "scene.blend", *arguments)
    assert done.returncode == 2
    (complaint,) = [line for line in done.stderr.splitlines() if "orogen" in line.lower()]
    assert complaint.startswith("orogen: ") and says in complaint
    assert hashes(job, "scene.blend") == {}
