"""Recipes, and the terrains that they make."""

import base64
import json
import math
import os

from . import _core, elevation_files, map_files

RECIPES = os.path.join(os.path.dirname(__file__), "recipes")
RECIPE_SUFFIX = ".orogen.json"

cache = _core.Cache(512 << 20)
"""Results of stages, shared by all calls of `generate` in this process."""


def shipped():
    """Names of the recipes that come with Orogen."""
    names = os.listdir(RECIPES)
    return sorted(n[: -len(RECIPE_SUFFIX)] for n in names if n.endswith(RECIPE_SUFFIX))


def pack_raster(values):
    """Values (rows, columns) from the south as a recipe's `rasters` take them.

    Whatever their number, they cover the terrain's whole extent. `schema()["rasters"]` says which
    there may be and what is allowed.

        recipe["rasters"] = {"uplift_factor": orogen.pack_raster(painted)}
    """
    import numpy

    values = numpy.ascontiguousarray(values, "<f4")
    if values.ndim != 2:
        raise _core.InputError(f"raster: {values.ndim} dimensions; rows and columns are wanted")
    rows, columns = values.shape
    text = base64.b64encode(values).decode("ascii")
    return {"rows": rows, "columns": columns, "float32": text}


class Recipe:
    """Everything that determines a terrain: map, resolution, seed, stages and their parameters."""

    def __init__(self, core):
        self._core = core

    @classmethod
    def load(cls, file, strict=False):
        """Reads a recipe; of a bare GeoJSON map or an elevation model it makes the default one.

        Parameters
        ----------
        file : path
            The file, or the name of a recipe that comes with Orogen (see `shipped`).
        strict : bool, optional
            Refuse a map that would have to be mended.

        Raises
        ------
        InputError
            The file cannot be read, or something in it cannot be used; the message says where.
        """
        file = os.fspath(file)
        if not os.path.exists(file) and file in shipped():
            file = os.path.join(RECIPES, file + RECIPE_SUFFIX)
        suffix = os.path.splitext(file)[1].lower()
        if suffix in elevation_files.SUFFIXES:
            return cls.from_dict(elevation_files.elevation_recipe(file))
        if suffix in map_files.SUFFIXES:
            map_ = map_files.read_map(file)
            return cls.from_dict(map_, name=map_["name"], strict=strict)
        if (document := _with_rasters(file)) is not None:
            name = os.path.basename(file).split(".")[0]
            return cls.from_dict(document, os.path.dirname(file), name, strict)
        return cls(_core.Recipe.load(file, strict))

    @classmethod
    def from_dict(cls, document, folder=".", name="terrain", strict=False):
        """The same from a dictionary; `folder` is where its files are looked for."""
        document = elevation_files.with_files_read(document, os.fspath(folder))
        try:
            text = json.dumps(document, allow_nan=False)
        except (TypeError, ValueError, RecursionError) as error:
            place = _place_of_bad_number(document) or "recipe"
            raise _core.InputError(f"{place}: {error}") from None
        return cls(_core.Recipe.read(text, os.fspath(folder), name, strict))

    def to_dict(self):
        """The recipe as a dictionary, its map inline."""
        return json.loads(self._core.to_json())

    def save(self, file):
        """Writes the recipe, its map inline."""
        with open(file, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(self._core.to_json(indent=1) + "\n")

    @property
    def name(self):
        return self._core.name

    @property
    def seed(self):
        return self._core.seed

    @property
    def resolution(self):
        """Cells along the longer side."""
        return self._core.resolution

    @property
    def projection(self):
        """PROJ string of the map's projection; empty for a plane without a place on Earth."""
        return self._core.proj4

    @property
    def warnings(self):
        """What was mended in the map, and where."""
        return self._core.warnings

    @property
    def hash(self):
        """SHA-256 of the canonical recipe."""
        return self._core.hash()

    def grid(self, resolution=None):
        """The grid that the terrain will have."""
        return self._core.grid(resolution or 0)

    def __repr__(self):
        return f"Recipe({self.name!r}, seed={self.seed}, resolution={self.resolution})"


def _with_rasters(file):
    """The recipe in a file whose rasters may name files; None for any other file."""
    try:
        with open(file, encoding="utf-8") as stream:
            text = stream.read()
        document = json.loads(text) if '"rasters"' in text else None
    except (OSError, ValueError, RecursionError):  # the core says what is wrong
        return None
    return document if isinstance(document, dict) else None


def _place_of_bad_number(value, place=""):
    """Where in a document a number is not finite; None if nowhere."""
    if isinstance(value, float) and not math.isfinite(value):
        return place
    items = ()
    if isinstance(value, dict):
        items = ((f"{place}.{key}" if place else str(key), item) for key, item in value.items())
    elif isinstance(value, list | tuple):
        items = ((f"{place}[{i}]", item) for i, item in enumerate(value))
    depth = place.count(".") + place.count("[")
    found = (_place_of_bad_number(item, where) for where, item in items if depth < 64)
    return next(filter(None, found), None)


class Terrain:
    """A grid and its named fields: `terrain["elevation"]` is an array of shape (ny, nx).

    Row 0 is the southern row. Arrays are views of the core's memory and read-only.
    """

    def __init__(self, core, recipe):
        self._core = core
        self.recipe = recipe

    def __getitem__(self, name):
        return self._core.field(name)

    def __contains__(self, name):
        return name in self._core.fields

    def __iter__(self):
        return iter(self._core.fields)

    def __len__(self):
        return len(self._core.fields)

    @property
    def fields(self):
        """Names of the fields."""
        return self._core.fields

    @property
    def grid(self):
        return self._core.grid

    @property
    def name(self):
        return self.recipe.name

    @property
    def seed(self):
        """The seed it was made with."""
        return self._core.seed

    @property
    def warnings(self):
        """What was mended in the map, and what in the recipe had no effect; and where."""
        return self.recipe.warnings + self._core.warnings

    @property
    def rocks(self):
        """The folded rocks below, an `orogen.strata.Rocks`; None if the recipe has no column."""
        return self._core.rocks

    @property
    def frames(self):
        """Growth as a sequence, if `mountain_growth` was asked for `frames`: dictionaries of
        years, elevation (metres) and strata_color (0xRRGGBB), before the detail on slopes."""
        return self._core.frames

    @property
    def tin(self):
        """The mesh that mountains grew on, an `orogen.erosion.GrownTin` with the elevation of each
        vertex; None if the recipe lacks the stage `mountain_growth`."""
        return self._core.tin

    @property
    def island(self):
        """The polygon map and what lies on it, an `orogen.island.Island`; None if the recipe lacks
        the stages `island` and `mapped_island`."""
        return self._core.island

    @property
    def folds(self):
        """Layers as they folded: dictionaries of phase and layer (numbers from 1, as fold edits
        have them); skeleton, an `orogen.folding.FoldSkeleton`, where that phase left it; speed, at
        which the layer rose by folding (m/yr, an array), and for how many years."""
        return self._core.folds

    @property
    def plant_tables(self):
        """Tables of the plants that grow here, `trees` and `ground_cover`, as the recipe's
        `plants` have them; None if it lacks the stage `vegetation`."""
        return self._core.planting

    def plants(self, layer="trees", region=None, most_plants=2_000_000, threads=0):
        """Places the plants that grow here.

        Parameters
        ----------
        layer : {"trees", "ground_cover"}, optional
            Which of `plant_tables`.
        region : ((x, y), (x, y)), optional
            South-western and north-eastern corner of a part, metres from the grid's lower-left
            corner: ground cover of a whole terrain is too much.
        most_plants : int, optional
            If some more than this would stand, all densities are lowered alike.
        threads : int, optional
            Most threads to use; 0: all cores.

        Returns
        -------
        orogen.vegetation.PlantCloud
            Positions, kinds (places in the table's `kinds`), scales and rotations.

        Raises
        ------
        InputError
            The recipe lacks the stage `vegetation`, or so many cannot stand at their spacings.
        """
        return self._core.plants(layer, region, most_plants, threads)

    @property
    def report(self):
        """What was done, as a dictionary: seconds by stage, version, hashes and so on."""
        from .report import make_report

        return make_report(self)

    def save(self, folder, formats=("npz",), pictures=True, section=None):
        """Writes the terrain into a folder; see `orogen.files.save_terrain`."""
        from .files import save_terrain

        return save_terrain(self, folder, formats, pictures, section=section)

    def __repr__(self):
        grid = self.grid
        return f"Terrain({self.name!r}, {grid.ny} x {grid.nx}, {len(self)} fields)"


def generate(
    recipe,
    resolution=None,
    threads=0,
    progress=None,
    seed=None,
    memory_limit_bytes=None,
    cache=cache,
    watch=None,
):
    """Makes a terrain.

    Parameters
    ----------
    recipe : Recipe, path or dict
        A recipe, a bare GeoJSON map, the file of either, or the name of a shipped recipe.
    resolution : int, optional
        Cells along the longer side, in place of the recipe's.
    threads : int, optional
        Most threads to use; 0: all cores. The result does not depend on it.
    progress : callable, optional
        Called as progress(stage, fraction) on this thread, with the fraction of the whole work
        that is done, several times a second. Returning False cancels.
    seed : int, optional
        In place of the recipe's.
    memory_limit_bytes : int, optional
        Refuse work that needs more memory; default: what the machine has available.
    cache : Cache or None, optional
        Where results of stages are kept and looked for.
    watch : callable, optional
        Called as watch(years, fields, grid) some times a second while mountains between plates
        grow, or running water wears the ground (not where that is cached): years since it began,
        and arrays in metres by name on a coarse grid over the terrain: elevation; of running water
        also water_depth and change, by how much the ground rose. On another thread; growth waits
        for it, and stays the same.

    Returns
    -------
    Terrain

    Raises
    ------
    InputError
        The recipe or its map cannot be used; the message says what and where.
    MemoryLimitError
        The terrain would need more memory than is allowed.
    Cancelled
        `progress` returned False.
    """
    if isinstance(recipe, dict):
        recipe = Recipe.from_dict(recipe)
    elif not isinstance(recipe, Recipe):
        recipe = Recipe.load(recipe)
    for name, value in (("resolution", resolution), ("seed", seed)):
        if value is not None and not 0 <= value < 2**32:
            raise _core.InputError(f"{name}: {value} is not allowed; 0 to 4294967295 is wanted")
    core = _core.generate(
        recipe._core,
        resolution or 0,
        seed,
        threads,
        progress,
        memory_limit_bytes or 0,
        cache,
        watch,
    )
    return Terrain(core, recipe)
