"""Plants: meshes, impostors that look like them, the fade from the one to the other."""

SPECIES = (
    "european_beech",
    "norway_spruce",
    "black_oak",
    "scots_pine",
    "coconut_palm",
    "hazel_bush",
    "umbrella_acacia",
)


def test_impostors_have_the_outline_and_light_of_the_mesh(tmp_path):
    import numpy as np
    import plant_scenes

    plant_scenes.light()
    for name in SPECIES:
        described = plant_scenes.plant(name)
        ob = plant_scenes.eight_views(described, pixels=96)
        plant_scenes.fade(ob, 1e6, 2e6)
        mesh = plant_scenes.picture(tmp_path)
        plant_scenes.fade(ob, 0.1, 0.2)
        impostor = plant_scenes.picture(tmp_path)
        both = np.stack([mesh, impostor]).reshape(2, mesh.shape[0], 8, -1, 4)
        covered = both[..., 3] > 0.5
        either, shared = covered.any(axis=0), covered.all(axis=0)
        overlap = shared.sum(axis=(0, 2)) / either.sum(axis=(0, 2))
        brightness = [
            (both[i, ..., :3].mean(axis=-1) * shared).sum(axis=(0, 2)) / shared.sum(axis=(0, 2))
            for i in range(2)
        ]
        ratio = brightness[1] / brightness[0]
        print(name, "overlap", overlap.min().round(3), "light", ratio.round(2))
        assert overlap.min() >= 0.85, name
        assert 0.7 < ratio.min() and ratio.max() < 1.4, name
        import bpy

        bpy.data.objects.remove(ob)


def test_nothing_pops_at_the_fade(tmp_path):
    import bpy
    import numpy as np
    import plant_scenes

    plant_scenes.light()
    described = plant_scenes.plant("european_beech", quality=0.05)
    ob = plant_scenes.eight_views(described, pixels=24)
    plant_scenes.fade(ob, 200.0, 400.0)
    camera = bpy.context.scene.camera
    frames = []
    for distance in np.linspace(190.0, 410.0, 23):
        camera.location.y = -distance
        frames.append(plant_scenes.picture(tmp_path, samples=64))
    frames = np.stack(frames)
    change = np.abs(np.diff(frames, axis=0))
    means = (frames[..., :3].mean(axis=-1)).mean(axis=(1, 2)) / frames[..., 3].mean(axis=(1, 2))
    cover = frames[..., 3].mean(axis=(1, 2))
    switch = np.abs(frames[-1] - frames[0])
    print("pixel", change.max(), "switch", switch.max(), "mean", means.round(4), cover.round(4))
    assert change.max() < 0.25 and switch.max() > 0.5
    assert np.abs(np.diff(means)).max() < 0.02 * means.mean()
    assert cover.min() > 0.97 * min(cover[0], cover[-1])
