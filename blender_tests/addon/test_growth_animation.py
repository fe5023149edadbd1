"""The growth of a terrain as an animation."""


def frames_of(terrain, count):
    """A made-up growth that ends at the terrain."""
    import numpy as np
    import steps

    nx, ny = terrain.data["orogen_grid"]
    last = steps.attribute(terrain, "elevation").reshape(ny, nx)
    rng = np.random.default_rng(1)
    for i in range(count - 1):
        share = np.float32(i / (count - 1))
        yield 5e6 * share, share * last + rng.random((ny, nx), np.float32)
    yield 5e6, last


def evaluated(terrain):
    import bpy
    import numpy as np

    mesh = terrain.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    values = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.attributes["position"].data.foreach_get("vector", values)
    return values.reshape(-1, 3)


def animated(folder, start=10, step=1, count=6):
    import steps

    terrain = steps.collision(folder)
    terrain.orogen.vertical_exaggeration = 1.3
    steps.grow()
    animation = steps.addon("mesh.growth_animation")
    frames = frames_of(terrain, count)
    end = animation.write(terrain, frames, folder / "growth.pc2", start, step)
    assert end == start + (count - 1) * step
    return terrain


def check_plays(terrain, start, step, count):
    import bpy
    import numpy as np
    import steps

    scale = 1.3e-3
    still = steps.positions(terrain)
    for i, (years, elevation) in enumerate(frames_of(terrain, count)):
        bpy.context.scene.frame_set(start + i * step)
        points = evaluated(terrain)
        assert np.allclose(points[:, :2], still[:, :2], atol=1e-5)
        assert np.allclose(points[:, 2], elevation.ravel() * scale, atol=1e-3 * (step > 1) + 1e-6)
        assert abs(terrain["orogen_years"] - years) < 1.0
        if i == 0:
            assert not np.allclose(points[:, 2], still[:, 2], atol=0.1)
    assert np.array_equal(evaluated(terrain), still), "the last frame is not the still"
    bpy.context.scene.frame_set(start + count * step + 50)
    assert np.array_equal(evaluated(terrain), still), "it does not stay at its end"


def test_frames_play(tmp_path):
    check_plays(animated(tmp_path), 10, 1, 6)


def test_frames_play_slowly(tmp_path):
    import bpy
    import numpy as np

    terrain = animated(tmp_path, start=3, step=7)
    check_plays(terrain, 3, 7, 6)
    bpy.context.scene.frame_set(3)
    first = evaluated(terrain)
    bpy.context.scene.frame_set(10)
    second = evaluated(terrain)
    bpy.context.scene.frame_set(6)
    between = first + (second - first) * (3 / 7)
    assert np.allclose(evaluated(terrain), between, atol=1e-3)


def test_it_plays_without_the_extension(tmp_path):
    """In another process, with a user folder where nothing was ever installed."""
    import os
    import subprocess
    import sys

    import bpy

    file = tmp_path / "growth.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(file))
    animated(tmp_path)
    assert bpy.data.objects["two plates"].modifiers[0].filepath.startswith("//")
    bpy.ops.wm.save_mainfile()
    program = """if True:
        import os, sys
        import bpy, numpy as np
        bpy.ops.wm.open_mainfile(filepath=sys.argv[1])
        assert not hasattr(bpy.types.Object, "orogen")
        terrain = bpy.data.objects["two plates"]
        def z(mesh):
            values = np.empty(3 * len(mesh.vertices), np.float32)
            mesh.attributes["position"].data.foreach_get("vector", values)
            return values[2::3]
        def at(frame):
            bpy.context.scene.frame_set(frame)
            return z(terrain.evaluated_get(bpy.context.evaluated_depsgraph_get()).data)
        still = z(terrain.data)
        middle = at(12)
        assert np.allclose(middle, 0.4 * still, atol=2e-3) and np.ptp(middle) > 0.1
        assert np.array_equal(at(15), still)
        print("plays", flush=True)
        os._exit(0)
    """
    environment = {**os.environ, "BLENDER_USER_RESOURCES": str(tmp_path / "bare")}
    command = [sys.executable, "-P", "-c", program, str(file)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and "plays" in done.stdout, done.stdout + done.stderr


def test_wrong_frames_are_refused(tmp_path):
    import numpy as np
    import pytest
    import steps

    terrain = animated(tmp_path)
    animation = steps.addon("mesh.growth_animation")
    frames = list(frames_of(terrain, 3))
    file = tmp_path / "growth.pc2"
    before = file.read_bytes()
    for wrong, message in (
        (frames[:-1], "last frame"),
        ([], "last frame"),
        ([(0.0, np.zeros((4, 5))), frames[-1]], r"frames\[0\]"),
    ):
        with pytest.raises(animation.NoAnimation, match=message):
            animation.write(terrain, wrong, file)
    assert file.read_bytes() == before and not list(tmp_path.glob("*.part"))
    check_plays(terrain, 10, 1, 6)


def test_growing_again_takes_it_off(tmp_path):
    import bpy
    import numpy as np
    import steps

    terrain = animated(tmp_path)
    terrain.orogen.seed = 8
    steps.grow()
    assert not terrain.modifiers and "orogen_years" not in terrain
    bpy.context.scene.frame_set(1)
    assert np.array_equal(evaluated(terrain), steps.positions(terrain))
    steps.addon("mesh.growth_animation").write(
        terrain, frames_of(terrain, 3), tmp_path / "growth.pc2"
    )
    terrain.orogen.units_per_km = 2.0
    assert not terrain.modifiers
    assert np.array_equal(evaluated(terrain), steps.positions(terrain))


def test_cache_holds_nothing_but_the_frames(tmp_path):
    import bpy

    animated(tmp_path, count=6)
    vertices = len(bpy.context.object.data.vertices)
    assert (tmp_path / "growth.pc2").stat().st_size == 32 + 6 * vertices * 12
    file = tmp_path / "scene.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(file), compress=False)
    with_six = file.stat().st_size
    animated(tmp_path, count=60)
    bpy.ops.wm.save_as_mainfile(filepath=str(file), compress=False)
    assert file.stat().st_size - with_six < 60 * 1000, "frames lie in the .blend"


def test_mountains_grow_with_an_animation(tmp_path):
    import bpy
    import numpy as np
    import orogen
    import steps

    terrain = steps.collision(tmp_path)
    assert "Save the .blend first" in steps.refused(bpy.ops.orogen.animate_growth)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 5, 6
    assert bpy.ops.orogen.animate_growth(frames=8, step=1) == {"FINISHED"}
    assert (tmp_path / "two_plates.pc2").is_file() and scene.frame_end == 12
    recipe = steps.addon("settings_recipe").to_recipe(terrain, scene)
    recipe = steps.addon("operators.animate_growth").with_frames(recipe, 8)
    expected = orogen.generate(recipe)
    still = steps.positions(terrain)
    assert np.array_equal(steps.attribute(terrain, "elevation"), expected["elevation"].ravel())
    tops = []
    for frame in range(5, 13):
        scene.frame_set(frame)
        points = evaluated(terrain)
        tops.append(points[:, 2].max())
        grown = expected.frames[frame - 5]["elevation"].ravel() * 1e-3
        assert np.abs(points[:, 2] - grown).max() < 0.2, "detail of rock is no more than that"
    assert np.array_equal(evaluated(terrain), still)
    assert tops[0] < 0.6 * tops[-1]
    assert terrain["orogen_years"] == 5e6
    assert bpy.ops.orogen.add_block() == {"FINISHED"}
    assert not set(terrain.data.attributes.keys()) & {"growth/0", "0"}


def test_maps_have_no_growth_to_animate(tmp_path):
    import bpy
    import steps

    steps.corsica(resolution=64)
    assert not bpy.ops.orogen.animate_growth.poll()
