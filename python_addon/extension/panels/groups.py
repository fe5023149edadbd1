"""Which panel each stage of the core is in. Within one, stages stand as recipes run them."""

GROUPS = {
    "Input": ("land", "rivers", "given_elevation", "island", "mapped_island", "feature_curves"),
    "Plates": ("plates", "boundaries", "velocity", "collision", "map_collision"),
    "Folds": ("folds", "fold_layers", "layered_folds"),
    "Strata": ("map_strata", "outcrop"),
    "Erosion": (
        "watershed",
        "combination",
        "combined_ground",
        "relief_growth",
        "even_rates",
        "river_erosion",
        "fitted_growth",
        "mountain_growth",
        "hydraulic_erosion",
    ),
    "Detail": ("map_law", "sea_floor", "rock_detail", "keep_region"),
    "Climate and Plants": ("lakes", "climate", "biomes", "vegetation"),
}


def uses(settings, group):
    """Whether the chosen start has stages of the group."""
    return bool(set(GROUPS[group]) & set(settings.stage_names()))
