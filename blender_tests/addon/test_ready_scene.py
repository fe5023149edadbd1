"""What a ready scene is made of: lakes, colours of biomes, a place to stand."""


def test_every_biome_has_a_colour():
    import steps

    colors = steps.addon("material.biome_colors")
    assert len(colors.COLORS) == len(steps.addon("declarations").BIOMES)
    assert colors.of([[0, 15], [3, 3]]).shape == (4, 4)


def test_lakes_are_level_and_reach_below_the_shore():
    import numpy as np
    import steps

    lakes = steps.addon("mesh.lakes")
    rng = np.random.default_rng(4)
    for _ in range(100):
        shape = tuple(rng.integers(3, 40, 2))
        ground = rng.normal(size=shape)
        height = rng.normal()
        wet = ground < height
        level = lakes.levels(np.where(wet, height, ground), wet)
        assert (level[wet] == height).all()
        beside = np.isfinite(level) & ~wet
        assert (level[beside] == height).all() and (ground[beside] >= height).all()
        padded = np.pad(wet, 1)
        near = np.any(
            [padded[r : r + shape[0], c : c + shape[1]] for r in range(3) for c in range(3)], axis=0
        )
        assert (np.isfinite(level) == near).all()


def test_the_eye_stands_on_land_and_sees_over_it():
    import numpy as np
    import steps

    viewpoint = steps.addon("outdoors.viewpoint")
    rng = np.random.default_rng(5)
    for _ in range(20):
        n, cell = int(rng.integers(40, 200)), float(rng.uniform(5.0, 300.0))
        x, y = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
        waves = np.sin(rng.uniform(2, 6) * x) * np.sin(rng.uniform(2, 6) * y)
        elevation = 3.0 * cell * (waves + rng.uniform(-0.3, 0.6))
        water = np.zeros_like(elevation)
        eye, ahead = viewpoint.find(elevation, water, cell, 50.0)
        row, column = (int(eye[i] / cell) for i in (1, 0))
        assert abs(eye[2] - elevation[row, column] - 50.0) < 1e-6 and elevation[row, column] >= 0.0
        assert abs(np.hypot(*ahead[:2]) - 1.0) < 1e-9
        assert ahead[2] < 2.0, "no wall before the eye"


def test_ground_that_grows_anew_without_biomes_loses_their_colours():
    import steps

    terrain = steps.corsica(resolution=64)
    steps.grow()
    attributes = steps.addon("mesh.attributes")
    height = steps.attribute(terrain, "elevation")
    attributes.add(terrain.data, {"biome": (height > 0).astype("int32")})
    assert "biome_color" in terrain.data.attributes and "elevation" in terrain.data.attributes
    steps.grow()
    assert "biome_color" not in terrain.data.attributes and "biome" not in terrain.data.attributes
