"""Files of an asset library: the presets' terrains, the materials and the groups of nodes.

What a file is made of stands in bpy.data only while it is written.
"""

import contextlib

import bpy

from . import preset_files, terrains
from .material import sea_material, strata_material, terrain_material, view_material
from .mesh import sea, terrain_mesh
from .nodes import plants, scatter, water
from .operators.presets import apply
from .settings_recipe import to_recipe

NAME = "Orogen"
CATALOG_FILE = "blender_assets.cats.txt"
TERRAINS, MATERIALS, NODES = (  # catalogs: what Blender knows them by, and their paths
    ("5c6f5e3e-2b0c-4d0b-9a4e-0f1d6a3b7c01", "Orogen/Terrains"),
    ("5c6f5e3e-2b0c-4d0b-9a4e-0f1d6a3b7c02", "Orogen/Materials"),
    ("5c6f5e3e-2b0c-4d0b-9a4e-0f1d6a3b7c03", "Orogen/Geometry Nodes"),
)
PARTS = (  # what makes it, its catalog, a preset whose picture shows it, what it is
    (terrain_material, MATERIALS, "Southern_Alps", "Ground: grass, rock, strata, snow and rivers"),
    (strata_material, MATERIALS, "Jura", "The colours of layers of rock"),
    (sea_material, MATERIALS, "Corsica", "The surface of the sea"),
    (view_material, MATERIALS, "Digne", "The colours of the field that a terrain shows"),
    (scatter, NODES, "Rift", "Instances on the ground where a field lies within bounds"),
    (
        plants,
        NODES,
        "Corsica",
        "Instances of plants on points: meshes near, their pictures far off",
    ),
    (water, NODES, "Volcanic_Island", "Water in river beds, and the sea"),
)


def recipe_of(context, preset, resolution):
    """The recipe that a preset's terrain is grown from."""
    with _passing():
        return to_recipe(_terrain(context, preset, resolution), context.scene)


def write_terrain(context, folder, preset, resolution, result, recipe):
    with _passing():
        terrain = _terrain(context, preset, resolution)
        terrain_mesh.write(terrain, result, recipe)
        if plane := sea.of(terrain):
            terrain["orogen_sea_plane"] = plane  # so that appending the terrain brings it along
        name = preset_files.name_of(preset)
        mark(context, terrain, TERRAINS, preset, f"{name}: it can be changed and grown anew")
        _save(folder / f"{preset.stem}.blend", {name: terrain})


def write_parts(context, folder):
    """The materials and the groups of nodes, and the catalogs."""
    with _passing():
        made = {}
        for part, catalog, picture, text in PARTS:
            thing = made[part.NAME] = part.ensure().copy()  # the file's own may be an asset already
            mark(context, thing, catalog, preset_files.OWN / f"{picture}.py", text)
        _save(folder / "Parts.blend", made)
    _write_catalogs(folder / CATALOG_FILE)


def mark(context, thing, catalog, preset, text):
    """Makes it an asset, with a preset's picture."""
    thing.asset_mark()
    data = thing.asset_data
    data.catalog_id, data.description, data.author = catalog[0], text, NAME
    for tag in ("orogen", catalog[1].rpartition("/")[2].lower()):
        data.tags.new(tag, skip_if_exists=True)
    picture = preset.with_suffix(".jpg")
    if picture.is_file():
        with context.temp_override(id=thing):
            bpy.ops.ed.lib_id_load_custom_preview(filepath=str(picture))


def add_to_preferences(context, folder):
    """Lets Blender's asset browser show the folder."""
    libraries = context.preferences.filepaths.asset_libraries
    if not any(bpy.path.abspath(library.path) == str(folder) for library in libraries):
        libraries.new(name=NAME, directory=str(folder))
        context.preferences.is_dirty = True


def _terrain(context, preset, resolution):
    terrain = terrains.new(preset_files.name_of(preset))
    apply(context, terrain, preset)
    terrain.orogen.resolution = resolution
    return terrain


@contextlib.contextmanager
def _passing():
    """What is made within goes at its end."""
    before = set(bpy.data.user_map())
    try:
        yield
    finally:
        bpy.data.batch_remove(set(bpy.data.user_map()) - before)


def _save(file, things):
    """Writes things under names that others in the user's file may bear."""
    partial = file.with_suffix(".part.blend")
    with contextlib.ExitStack() as afterwards:
        for name, thing in things.items():
            _lend(name, thing, afterwards)
        try:
            bpy.data.libraries.write(
                str(partial), set(things.values()), fake_user=True, compress=True
            )
        except RuntimeError as error:
            raise OSError(f"{file.name} cannot be written: {error}") from None
    partial.replace(file)


def _lend(name, thing, afterwards):
    others = (bpy.data.objects, bpy.data.materials, bpy.data.node_groups)
    kin = next(kin for kin in others if thing in kin.values())
    bearer = kin.get((name, None))
    if bearer and bearer != thing:
        bearer.name = f"{name} (own)"
        afterwards.callback(setattr, bearer, "name", name)
        afterwards.callback(setattr, thing, "name", thing.name)  # before the bearer's
    thing.name = name


def _write_catalogs(file):
    """Adds what the file lacks: others of the user's may be in it."""
    text = file.read_text(encoding="utf-8") if file.exists() else "VERSION 1\n"
    for number, path in (TERRAINS, MATERIALS, NODES):
        if number not in text:
            text = f"{text.rstrip()}\n{number}:{path}:{path.replace('/', '-')}"
    file.write_text(f"{text.rstrip()}\n", encoding="utf-8")
