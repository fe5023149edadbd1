"""What the ground of a biome looks like from afar, with what grows on it."""

import numpy as np

ATTRIBUTE = "biome_color"
COLORS = (  # linear, in the core's order of biomes
    (0.780, 0.810, 0.860),  # snow
    (0.110, 0.100, 0.050),  # tundra
    (0.230, 0.205, 0.165),  # bare
    (0.105, 0.090, 0.078),  # scorched
    (0.022, 0.040, 0.018),  # taiga
    (0.090, 0.100, 0.038),  # shrubland
    (0.270, 0.215, 0.125),  # temperate desert
    (0.024, 0.050, 0.020),  # temperate rain forest
    (0.040, 0.070, 0.020),  # deciduous forest
    (0.105, 0.135, 0.040),  # grassland
    (0.020, 0.055, 0.016),  # tropical rain forest
    (0.060, 0.085, 0.024),  # tropical seasonal forest
    (0.400, 0.290, 0.160),  # subtropical desert
    (0.420, 0.350, 0.230),  # beach
    (0.100, 0.085, 0.055),  # lake: its bed
    (0.300, 0.330, 0.230),  # ocean
)


def of(biomes):
    """(n, 4) for numbers of biomes (n)."""
    table = np.ones((len(COLORS), 4), np.float32)
    table[:, :3] = COLORS
    return table[np.asarray(biomes).ravel()]
