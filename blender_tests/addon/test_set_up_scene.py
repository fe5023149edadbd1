"""A camera, sun, sky and ground to the horizon: for a picture of a terrain."""


def set_up(resolution=96, **settings):
    import bpy
    import steps

    terrain = steps.corsica(resolution=resolution)
    steps.grow()
    assert bpy.ops.orogen.set_up_scene(**settings) == {"FINISHED"}
    return terrain


def with_role(role):
    import bpy

    return [ob for ob in bpy.data.objects if ob.get("orogen_role") == role]


def test_the_picture_shows_sky_over_lit_ground(tmp_path):
    import bpy
    import numpy as np

    set_up(haze=0.3)
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.samples = "CYCLES", 4
    scene.render.resolution_x, scene.render.resolution_y = 64, 36
    scene.render.filepath = str(tmp_path / "picture.png")
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(scene.render.filepath)
    rows = np.array(picture.pixels[:]).reshape(36, 64, 4)[::-1, :, :3]
    sky, ground = rows[:4], rows[12:]
    assert sky.mean() > 0.4 and np.ptp(sky, axis=1).max() < 0.15, "bright and even"
    assert 0.1 < ground.mean() < sky.mean() and ground.std() > 0.03
    assert np.abs(np.diff(rows[:9].mean(axis=(1, 2)))).max() < 0.15, "no edge at the skyline"


def test_what_was_there_stays():
    import bpy
    import steps

    own = bpy.data.objects.new("Mine", bpy.data.cameras.new("Mine"))
    scene = bpy.context.scene
    scene.collection.objects.link(own)
    scene.camera, world = own, scene.world
    terrain = set_up()
    message = bpy.context.window_manager.orogen.message
    assert "'Mine'" in message and f"'{world.name}'" in message
    assert scene.camera != own and own.name in scene.objects
    assert scene.world != world and world.use_fake_user
    count, place = len(bpy.data.objects), scene.camera.location.copy()
    assert bpy.ops.orogen.set_up_scene(turn=1.0) == {"FINISHED"}
    assert len(bpy.data.objects) == count and (scene.camera.location - place).length > 1.0
    assert len(bpy.data.worlds) == 2
    nodes = terrain.data.materials[0].node_tree.nodes
    assert sum(node.type == "GROUP" for node in nodes) == 1, "one haze"
    assert steps.refused(bpy.ops.orogen.add_inputs), "the terrain is the active object still"


def test_the_eye_is_above_the_ground_and_sees_it():
    import bpy
    import numpy as np
    import steps
    from bpy_extras.object_utils import world_to_camera_view
    from mathutils import Vector

    terrain = set_up()
    terrain.location, terrain.scale = (50.0, -20.0, 3.0), (2.0, 2.0, 2.0)
    bpy.context.view_layer.update()
    for turn, farther in ((0.0, 1.0), (1.5, 0.1), (3.0, 3.0), (4.5, 1.0)):
        assert bpy.ops.orogen.set_up_scene(turn=turn, farther=farther) == {"FINISHED"}
        bpy.context.view_layer.update()
        camera = bpy.context.scene.camera
        points = steps.positions(terrain)
        eye = np.array(terrain.matrix_world.inverted() @ camera.location)
        near = np.hypot(*(points[:, :2] - eye[:2]).T).argsort()[:20]
        assert eye[2] > points[near, 2].max() + 0.1
        summit = terrain.matrix_world @ Vector(points[points[:, 2].argmax()])
        lies = steps.addon("outdoors.lie").of(terrain)
        middle = terrain.matrix_world @ Vector((*lies.middle, lies.base))
        x, y, depth = world_to_camera_view(bpy.context.scene, camera, middle)
        assert 0.2 < x < 0.8 and y < 0.8 and (y > 0.0 or farther < 1.0)
        assert camera.data.clip_start < depth < camera.data.clip_end
        assert summit.z < camera.location.z or farther < 1.0


def border_gap(terrain):
    """How far the ground outside lies from the terrain's border."""
    import numpy as np
    import steps

    (outside,) = with_role("surroundings")
    nx, ny = terrain.data["orogen_grid"]
    ground = steps.positions(terrain).reshape(ny, nx, 3)
    rim = steps.positions(outside)[: 2 * (nx + ny) - 3]
    sides = [ground[0], ground[-1], ground[:, 0], ground[:, -1]]
    edge = np.unique(np.concatenate(sides), axis=0)
    return np.abs(np.unique(rim, axis=0) - edge).max()


def test_the_ground_outside_follows_the_terrain():
    import bpy
    import steps

    terrain = set_up(resolution=64)
    assert border_gap(terrain) < 1e-6
    (outside,), (sea,) = with_role("surroundings"), with_role("sea")
    assert min(outside.dimensions[:2]) > 50 * max(terrain.dimensions[:2])
    assert abs(sea.dimensions.x / outside.dimensions.x - 1) < 1e-3
    terrain.orogen.vertical_exaggeration = 2.0
    assert border_gap(terrain) < 1e-6
    terrain.orogen.seed, terrain.orogen.resolution = 5, 48
    steps.grow()
    assert border_gap(terrain) < 1e-6
    bpy.context.view_layer.update()
    terrain.orogen.view.field = "elevation"
    assert outside.hide_viewport and not outside.hide_render


def test_it_wants_a_grown_terrain():
    import bpy
    import steps

    steps.new_terrain()
    assert "Grow a terrain first" in steps.refused(bpy.ops.orogen.set_up_scene)
