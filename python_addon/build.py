#!/usr/bin/env python3
"""Builds the extension's zip: its code, the wheels (maps inside), and the declarations.

    python python_addon/build.py [--wheels dist] [--output dist]

Needs no Blender. One wheel must fit the running Python: from it comes `schema.json`.
Writes OUTPUT/orogen-VERSION.zip. Where a package `bpy` is at hand its own tool validates the zip.
"""

import argparse
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
EXTENSION = Path(__file__).resolve().parent / "extension"
PLATFORMS = (  # what a wheel's platform tag ends with, and Blender's name for it
    ("linux", "x86_64", "linux-x64"),
    ("linux", "aarch64", "linux-arm64"),
    ("win", "amd64", "windows-x64"),
    ("macosx", "x86_64", "macos-x64"),
    ("macosx", "arm64", "macos-arm64"),
)


def project_version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(Orogen VERSION ([0-9.]+)", text).group(1)


def platform_of(wheel):
    """None for a wheel of Python alone."""
    if wheel.stem.endswith("-any"):
        return None
    tag = wheel.stem.split("-")[-1]
    for system, machine, name in PLATFORMS:
        if system in tag and tag.endswith(machine):
            return name
    raise SystemExit(f"{wheel.name}: no platform of Blender's is called '{tag}'")


def read_schema(core):
    """The declarations of the package in the folder `core`.

    Another process imports it, so that no module of this one is in the way.
    """
    program = "import json, orogen; print(json.dumps(orogen.schema(), indent=1))"
    environment = {**os.environ, "PYTHONPATH": str(core)}
    answer = subprocess.run(
        [sys.executable, "-c", program], env=environment, check=True, stdout=subprocess.PIPE
    )
    return answer.stdout


def assemble(target, core, wheels=()):
    """Writes the extension's folder `target`, with the core's package in the folder `core`."""
    target = Path(target)
    shutil.copytree(EXTENSION, target, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "LICENSE", target)
    (target / "schema.json").write_bytes(read_schema(core))
    if wheels:
        (target / "wheels").mkdir()
    for wheel in wheels:
        shutil.copy(wheel, target / "wheels")
    platforms = sorted({platform_of(wheel) for wheel in wheels} - {None}) or ["linux-x64"]
    manifest = target / "blender_manifest.toml"
    text = manifest.read_text(encoding="utf-8")
    text = text.replace("@VERSION@", project_version())
    text = text.replace("@PLATFORMS@", json.dumps(platforms))
    text = text.replace("@WHEELS@", json.dumps([f"./wheels/{wheel.name}" for wheel in wheels]))
    manifest.write_text(text, encoding="utf-8")


def pack(folder, archive):
    """A zip whose bytes depend on the contents alone."""
    partial = archive.with_suffix(".part")
    with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED) as zip_file:
        for file in sorted(path for path in folder.rglob("*") if path.is_file()):
            entry = zipfile.ZipInfo(str(file.relative_to(folder)), (1980, 1, 1, 0, 0, 0))
            entry.external_attr = 0o644 << 16
            entry.compress_type = (
                zipfile.ZIP_STORED if file.suffix == ".whl" else zipfile.ZIP_DEFLATED
            )
            zip_file.writestr(entry, file.read_bytes())
    partial.replace(archive)


def validate(archive):
    """Blender's own check; False where there is no bpy to ask."""
    spec = importlib.util.find_spec("bpy")
    places = [Path(spec.origin).parent] if spec else []
    places += sorted(ROOT.glob(".env/bpy-*/lib/python*/site-packages/bpy"))
    tools = [t for p in places for t in p.glob("*/scripts/addons_core/bl_pkg/cli/blender_ext.py")]
    if not tools:
        return False
    # The list of tags that extensions.blender.org knows travels with Blender; ours are among them.
    subprocess.run([sys.executable, tools[-1], "validate", "--valid-tags=", archive], check=True)
    return True


def build(wheel_folder, output):
    version = project_version()
    wheels = sorted(Path(wheel_folder).glob(f"orogen-{version}-*.whl"))
    wheels += sorted(Path(wheel_folder).glob("*-none-any.whl"))  # what the core's package needs
    mine = f"-cp{sys.version_info[0]}{sys.version_info[1]}-"
    own = next((wheel for wheel in wheels if mine in wheel.name), None)
    if own is None:
        raise SystemExit(f"No wheel of orogen {version} for this Python in {wheel_folder}")
    output = Path(output)
    output.mkdir(parents=True, exist_ok=True)
    archive = output / f"orogen-{version}.zip"
    with tempfile.TemporaryDirectory() as temporary:
        core = Path(temporary, "core")
        zipfile.ZipFile(own).extractall(core)
        assemble(Path(temporary, "orogen"), core, wheels)
        pack(Path(temporary, "orogen"), archive)
    checked = "validated" if validate(archive) else "not validated: no bpy here"
    print(f"{archive} ({archive.stat().st_size / 1e6:.1f} MB, {len(wheels)} wheels, {checked})")
    return archive


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--wheels", default=ROOT / "dist", help="folder of the wheels")
    parser.add_argument("--output", default=ROOT / "dist", help="folder for the zip")
    arguments = parser.parse_args()
    build(arguments.wheels, arguments.output)


if __name__ == "__main__":
    main()
