"""What Blender asks of extensions: no network, no files where none are wanted, no meddling."""

import ast
import os
import subprocess
import sys
from pathlib import Path

NETWORK = {
    "aiohttp", "asyncio", "ftplib", "http", "httpx", "imaplib", "nntplib", "poplib", "requests",
    "select", "selectors", "smtplib", "socket", "socketserver", "ssl", "telnetlib", "urllib",
    "urllib3", "webbrowser", "websockets", "xmlrpc",
}  # fmt: skip


def extension():
    import steps

    return Path(steps.addon().__file__).parent


def core():
    import steps

    return steps.addon("worker.launch").core_folder() / "orogen"


def modules_imported(tree):
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module


def test_nothing_imports_the_network_or_changes_the_search_path():
    files = [*extension().rglob("*.py"), *core().rglob("*.py")]
    assert len(files) > 50
    for file in files:
        text = file.read_text(encoding="utf-8")
        tree = ast.parse(text)
        used = {name.partition(".")[0] for name in modules_imported(tree)}
        assert not used & NETWORK, (file, used & NETWORK)
        assert "sys.path" not in text.replace("sys.path_", ""), file
        if file.is_relative_to(extension()):
            assert "orogen" not in used, f"{file}: native code in Blender's process"
            assert "bl_ext" not in text, f"{file}: names its own place"


def test_manifest():
    import tomllib

    manifest = tomllib.loads((extension() / "blender_manifest.toml").read_text(encoding="utf-8"))
    assert manifest["id"] == "orogen" and manifest["blender_version_min"] == "4.2.13"
    assert list(manifest["permissions"]) == ["files"]
    for text in (manifest["tagline"], *manifest["permissions"].values()):
        assert len(text) <= 64 and text[-1].isalnum()
    for wheel in manifest["wheels"]:
        assert (extension() / wheel).is_file(), wheel


# Everything that a session does; any use of the network is an error, in the worker too.
GUARD = """
import sys
def guard(event, arguments):
    if event.startswith(("socket.", "urllib.", "http.", "ftplib.", "smtplib.", "webbrowser.")):
        raise RuntimeError(f"the network was used: {event} {arguments}")
sys.addaudithook(guard)
"""

SESSION = """
import bpy, steps
launch = steps.addon("worker.launch")
plain = launch.command
def guarded(exchange):
    python, *options = plain(exchange)
    i = options.index("-m")
    run = f"import runpy; runpy.run_module({options[i + 1]!r}, run_name='__main__', alter_sys=True)"
    return [python, *options[:i], "-c", GUARD + run, *options[i + 2:]]
launch.command = guarded
steps.corsica(resolution=64)
steps.grow()
assert GUARD in steps.addon("worker.jobs").jobs._worker._process.args[-3]
steps.collision(folder, resolution=48)
steps.grow()
for name in ("block", "section", "horizons"):
    assert getattr(bpy.ops.orogen, f"add_{name}")() == {"FINISHED"}
bpy.ops.orogen.copy_system_report()
bpy.context.preferences.filepaths.file_preview_type = "NONE"  # Blender's own, in ~/.cache
bpy.ops.wm.save_as_mainfile(filepath=str(folder / "scene.blend"))
"""


def test_no_network(tmp_path):
    exec(GUARD, {})
    import socket

    try:
        socket.create_connection(("127.0.0.1", 9), timeout=1)
    except RuntimeError as error:
        assert "the network was used" in str(error)
    else:
        raise AssertionError("the guard sleeps")
    exec(SESSION, {"GUARD": GUARD, "folder": tmp_path})


def written_in(folder):
    """Files with their sizes and times; without what Python caches and where Blender unpacks
    wheels (.local)."""
    return {
        path: (path.stat().st_size, path.stat().st_mtime_ns)
        for path in Path(folder).rglob("*")
        if path.is_file() and not {"__pycache__", ".local"} & set(path.parts)
    }


def test_writes_where_it_may(tmp_path):
    """With an empty home, an empty working folder and a temporary one: only Blender's own
    temporary folder is used, and nothing of ours is left in it."""
    places = {name: tmp_path / name for name in ("home", "work", "temporary", "out")}
    for place in places.values():
        place.mkdir()
    environment = {
        **{k: v for k, v in os.environ.items() if not k.startswith("XDG_")},
        "HOME": str(places["home"]),
        "TMPDIR": str(places["temporary"]),
    }
    resources = os.environ["BLENDER_USER_RESOURCES"]
    before = written_in(resources)
    command = [sys.executable, "-P", str(Path(__file__).with_name("in_blender.py"))]
    command += ["test", __file__, "test_no_network", str(places["out"])]
    done = subprocess.run(
        command, env=environment, cwd=places["work"], capture_output=True, text=True, timeout=200
    )
    assert done.returncode == 0, done.stdout + done.stderr
    after = written_in(resources)
    changed = [path for path in {*before, *after} if before.get(path) != after.get(path)]
    ours = [path for path in changed if "orogen" in str(path.relative_to(resources))]
    assert not ours, ours
    for name in ("work", "home"):
        assert not written_in(places[name]), list(written_in(places[name]))
    left = list(places["temporary"].rglob("*"))
    assert not [path for path in left if "orogen" in path.name], left
    assert {path.name for path in places["out"].iterdir()} == {"plates.orogen.json", "scene.blend"}
