"""From every recipe that ships comes a ready scene that renders without a word of warning."""

WISHES = {
    "reach": 1500.0,
    "most_trees": 2000,
    "variants": 1,
    "quality": 0.005,
    "cover_reach": 4.0,
    "picture_size": 16,
}
SAID = ("warn", "error", "fail", "traceback")


def test_first_quarter_of_the_gallery_renders(tmp_path):
    render(tmp_path, names()[0::4])


def test_second_quarter_of_the_gallery_renders(tmp_path):
    render(tmp_path, names()[1::4])


def test_third_quarter_of_the_gallery_renders(tmp_path):
    render(tmp_path, names()[2::4])


def test_fourth_quarter_of_the_gallery_renders(tmp_path):
    render(tmp_path, names()[3::4])


def names():
    import steps

    return [item[0] for item in steps.addon("examples").items()]


def render(folder, recipes):
    for name in recipes:
        with Said(folder / f"{name}.txt") as said:
            pixels = picture(name, folder / f"{name}.png")
        assert not [line for line in said if any(word in line.lower() for word in SAID)], name
        assert pixels.std(axis=(0, 1)).max() > 0.02, f"{name}: one colour everywhere"


def picture(name, file):
    """Of the recipe's terrain, small, with what stands on it."""
    import bpy
    import numpy as np
    import steps

    terrain = steps.new_terrain(source="EXAMPLE", example=name, resolution=64)
    steps.grow()
    assert bpy.ops.orogen.make_ready_scene(**WISHES) == {"FINISHED"}
    assert {"trees", "ground_cover"} <= {ob["orogen_role"] for ob in terrain.children}
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.samples, scene.cycles.max_bounces = "CYCLES", 2, 2
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y = 96, 54
    scene.render.filepath = str(file)
    bpy.ops.render.render(write_still=True)
    for ob in (*terrain.children_recursive, terrain):
        bpy.data.objects.remove(ob)
    image = bpy.data.images.load(str(file))
    return np.array(image.pixels[:]).reshape(image.size[1], image.size[0], 4)[..., :3]


class Said:
    """What the process writes, Blender's own code too."""

    def __init__(self, file):
        self.file, self.lines = file, []

    def __enter__(self):
        import os
        import sys

        sys.stdout.flush()
        self.kept = [os.dup(stream) for stream in (1, 2)]
        with open(self.file, "wb") as file:
            for stream in (1, 2):
                os.dup2(file.fileno(), stream)
        return self.lines

    def __exit__(self, *_):
        import os
        import sys

        sys.stdout.flush()
        for stream, kept in zip((1, 2), self.kept, strict=True):
            os.dup2(kept, stream)
            os.close(kept)
        text = self.file.read_text("utf-8", "replace")
        print(text)
        self.lines += text.splitlines()
