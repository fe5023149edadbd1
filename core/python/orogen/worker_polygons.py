"""What a host shows of an island's polygons over its terrain, in JSON."""

import numpy as np

from .pipeline import generate
from .preview import cache, preview_recipe

STAGES = ("island", "mapped_island")


def describe_polygons(request):
    """Of the island of the recipe `request["recipe"]`, metres to 0.1:

    centers, corners: places; rings: of each center the numbers of its corners, anticlockwise;
    biomes: of each center; edges: pairs of corners; rivers: pairs of corners that a river joins,
    and what it carries; downslopes: pairs of corners, from each the one that its water goes to.
    Without an island there is an "error"."""
    island = _island(request["recipe"])
    if island is None:
        return {"error": "The terrain is no island on a polygon map"}
    map_ = island.map
    first, items = map_.center_corners
    edges, carried, down = map_.edge_corners, island.edge_river, island.downstream
    above = np.flatnonzero(down >= 0)
    below = edges[down[above]].sum(axis=1) - above  # the edge's other corner
    return {
        "centers": np.round(map_.centers, 1).tolist(),
        "corners": np.round(map_.corners, 1).tolist(),
        "rings": [items[a:b].tolist() for a, b in zip(first[:-1], first[1:], strict=True)],
        "biomes": island.biomes.tolist(),
        "edges": edges.tolist(),
        "rivers": np.column_stack([edges, carried])[carried > 0].tolist(),
        "downslopes": np.column_stack([above, below]).tolist(),
    }


def _island(recipe):
    """That of the recipe's preview, whose polygons are the terrain's but for a share of a cell."""
    preview = preview_recipe(recipe)
    stages = [item for item in preview["stages"] if item["stage"] in STAGES]
    return generate({**preview, "stages": stages}, cache=cache).island if stages else None
