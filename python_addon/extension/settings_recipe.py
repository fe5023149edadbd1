"""A terrain's settings as a recipe, and a recipe's settings onto a terrain."""

import bpy

from . import drawn_recipe, examples, feature_curves, fold_edits, given_fields, recipe, recipe_check
from .declarations import MAP_STAGES, STAGES
from .mesh import middle
from .properties.stages import set_value, value_of
from .scene import feature_curves as drawn_curves
from .scene import springs
from .worker.launch import NoCore


def to_recipe(terrain, scene, pack=given_fields.pack):
    """The recipe that `terrain` asks for; `pack` makes its rasters. Raises recipe.NotARecipe,
    map_features.NothingDrawn."""
    settings = terrain.orogen
    drawn = settings.is_drawn()
    base = drawn_recipe.make(terrain, scene) if drawn else source_recipe(settings)
    base = _towards(settings, base)
    names = recipe.stage_names(base)
    if drawn and settings.living:
        names = recipe.with_life(names)
        base = {**base, "stages": [{"stage": name} for name in names]}
    wanted = (*names, given_fields.KEEP_STAGE, recipe.FEATURE_STAGE)
    parameters = {stage.name: _changed(settings, stage) for stage in STAGES if stage.name in wanted}
    whole = recipe.with_settings(base, settings.seed, settings.resolution, parameters)
    whole = fold_edits.add_to(whole, terrain)
    if (shift := middle.shift(terrain)) is not None:
        features = feature_curves.to_recipe(drawn_curves.read(terrain, scene), shift)
        whole = recipe.with_features(whole, features, parameters[recipe.FEATURE_STAGE])
        whole = recipe.with_river_sources(whole, springs.read(terrain, scene, shift))
    return given_fields.add_to(whole, terrain, parameters[given_fields.KEEP_STAGE], pack)


def source_recipe(settings):
    """The recipe or map of the example or file that is picked."""
    if settings.source == "EXAMPLE":
        document = recipe.read(examples.path_of(settings.example))
    elif settings.path:
        path = bpy.path.abspath(settings.path, library=settings.id_data.library)
        document = recipe.read(path)
    else:
        raise recipe.NotARecipe("No map: pick a file, an example, or draw one")
    recipe_check.check(document)
    return document


def take_over(settings):
    """Seed, resolution and parameters from what was picked, where it is a recipe that names them;
    what its stages do not name goes to its default. A bare map changes nothing. Raises NotARecipe.
    """
    document = source_recipe(settings)
    settings.picked_stages = " ".join(recipe.stage_names(_towards(settings, document)))
    settings.seed = document.get("seed", settings.seed)
    settings.resolution = document.get("resolution", settings.resolution)
    if "stages" in document:
        reset(settings, STAGES)
    set_parameters(settings, document)


def set_parameters(settings, document):
    """The parameters that a recipe names."""
    declared = {stage.name: {p.name: p for p in stage.parameters} for stage in STAGES}
    for item in document.get("stages", []):
        group = getattr(settings.stages, item["stage"])
        for name, value in item.get("parameters", {}).items():
            set_value(group, declared[item["stage"]][name], value)


def notice_stages(settings):
    """Keeps in mind the stages of what is picked, for the panels; those of maps if it is unfit."""
    try:
        if settings.source == "HEIGHTS" and settings.ground.use == "TOWARDS":
            names = recipe.TARGET_STAGES
        elif settings.is_drawn():
            names = drawn_recipe.stages_of(settings.source)
        else:
            names = recipe.stage_names(_towards(settings, source_recipe(settings)))
    except (recipe.NotARecipe, NoCore):
        names = MAP_STAGES
    living = settings.is_drawn() and settings.living
    settings.picked_stages = " ".join(recipe.with_life(names) if living else names)


def _towards(settings, document):
    """The recipe; where it gives heights alone, as they are to be used."""
    given = "elevation" in document.get("rasters", {}) and "stages" not in document
    return recipe.towards(document) if given and settings.ground.use == "TOWARDS" else document


def reset(settings, stages):
    for stage in stages:
        group = getattr(settings.stages, stage.name)
        for parameter in stage.parameters:
            group.property_unset(parameter.name)


def _changed(settings, stage):
    """The parameters of a stage that differ from their defaults."""
    group = getattr(settings.stages, stage.name)
    values = {parameter.name: value_of(group, parameter) for parameter in stage.parameters}
    return {p.name: values[p.name] for p in stage.parameters if values[p.name] != p.default}
