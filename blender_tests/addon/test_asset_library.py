"""The library of assets: written here, read in another process."""

CHILD = """
import json, os, sys
from pathlib import Path
import bpy
found = {}
for file in sorted(Path(sys.argv[1]).glob("*.blend")):
    with bpy.data.libraries.load(str(file), assets_only=True) as (inside, wanted):
        wanted.objects, wanted.materials = inside.objects, inside.materials
        wanted.node_groups = inside.node_groups
        names = [*inside.objects, *inside.materials, *inside.node_groups]
    things = [*wanted.objects, *wanted.materials, *wanted.node_groups]
    for name, thing in zip(names, things, strict=True):
        data = thing.asset_data
        found[name] = [
            file.name, data.catalog_id, data.description, sorted(tag.name for tag in data.tags),
            list(thing.preview.image_size),
        ]
print("FOUND" + json.dumps(found), flush=True)
os._exit(0)
"""


def make(folder, **more):
    import bpy
    import steps

    files = steps.addon("preset_files")
    wanted = [file for file in files.found() if file.stem in ("Corsica", "Jura")]
    files.found = lambda: wanted
    return bpy.ops.orogen.save_asset_library(directory=str(folder), resolution=96, **more)


def test_the_library_is_read_elsewhere(tmp_path):
    import json
    import subprocess
    import sys

    import bpy
    import steps

    folder = tmp_path / "assets"
    terrain = steps.corsica(64)
    terrain.name = "Corsica"
    steps.grow()
    before = {thing.name for thing in bpy.data.user_map()}
    assert make(folder) == {"FINISHED"}
    assert {thing.name for thing in bpy.data.user_map()} == before, "nothing is left in the file"
    assert not terrain.data.materials[0].asset_data and bpy.context.object == terrain
    done = subprocess.run(
        [sys.executable, "-c", CHILD, folder], capture_output=True, text=True, timeout=120
    )
    assert "FOUND" in done.stdout, done.stderr
    (line,) = [x for x in done.stdout.splitlines() if x.startswith("FOUND")]
    found = json.loads(line.removeprefix("FOUND"))
    names = {"Orogen Terrain", "Orogen Strata", "Orogen Sea", "Orogen View"}
    names |= {"Orogen Scatter by Field", "Orogen Water Surface", "Orogen Plants", "Corsica", "Jura"}
    assert names == set(found)
    catalogs = (folder / "blender_assets.cats.txt").read_text()
    for name, (file, catalog, description, tags, size) in found.items():
        assert catalog in catalogs and description and "orogen" in tags, name
        assert (file == f"{name}.blend") == (name in ("Corsica", "Jura"))
        assert size == [256, 256], (name, size)
    libraries = bpy.context.preferences.filepaths.asset_libraries
    assert [library.path.rstrip("/") for library in libraries].count(str(folder)) == 1
    assert make(folder) == {"FINISHED"}
    assert (folder / "blender_assets.cats.txt").read_text() == catalogs
    assert [library.path.rstrip("/") for library in libraries].count(str(folder)) == 1


def test_an_appended_terrain_grows_to_the_same_ground(tmp_path):
    import bpy
    import steps

    make(tmp_path)
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    with bpy.data.libraries.load(str(tmp_path / "Jura.blend")) as (inside, wanted):
        wanted.objects = ["Jura"]
    (terrain,) = wanted.objects
    bpy.context.collection.objects.link(terrain)
    bpy.context.view_layer.objects.active = terrain
    before, mark = steps.positions(terrain), terrain.data["orogen_grown_from"]
    assert len(before) > 1000 and terrain.orogen.example == "jura"
    terrain.data.attributes["position"].data.foreach_set("vector", [0.0] * 3 * len(before))
    steps.grow()
    assert (steps.positions(terrain) == before).all()
    assert terrain.data["orogen_grown_from"] == mark


def test_what_cannot_be_written_is_told(tmp_path):
    import bpy
    import steps

    file = tmp_path / "file"
    file.write_text("")
    objects = len(bpy.data.objects)
    assert "file" in steps.refused(make, folder=file / "inside")
    assert len(bpy.data.objects) == objects
