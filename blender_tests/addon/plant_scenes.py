"""Small scenes of plants that tests look at. Imported in the process with bpy."""

import math
import time

import bpy
import numpy as np
import steps

PIXELS = 160  # of a tree's picture


def plant(name, quality=0.1):
    """A plant's mesh and impostor, one variant; the plant as the worker describes it."""
    from orogen import vegetation

    trees = {species["name"]: species for species in vegetation.tree_species()}
    species = trees.get(name) or next(s for s in vegetation.ground_cover() if s["name"] == name)
    if name in trees:
        mesh = vegetation.make_tree(name, 0, quality=quality)
    else:
        mesh = vegetation.make_ground_cover(name, 0)
    described = {
        "layer": "trees" if name in trees else "ground_cover",
        "kind": 0,
        "name": name,
        "variants": [f"{name} 0"],
        "fingerprint": str(quality),
        "colors": {key: value for key, value in species.items() if key.endswith("_color")},
    }
    arrays = steps.addon("plants.plant_mesh").ARRAYS
    meshes = {f"{name} 0": {array: getattr(mesh, array) for array in arrays}}
    steps.addon("plants.species").ensure(described, meshes)
    for _ in steps.addon("plants.impostors").ensure([described], meshes, PIXELS):
        time.sleep(0.01)
    return described


def stand(described, places, rotations):
    """An object whose nodes place the plant, seen from a camera far in the south."""
    points = steps.addon("plants.points")
    store, nodes = steps.addon("plants.store"), steps.addon("nodes.plants")
    group = steps.addon("nodes.group")
    mesh = bpy.data.meshes.new("Plants")
    cloud = {
        "positions": np.asarray(places, np.float32),
        "kinds": np.zeros(len(places), np.uint8),
        "scales": np.ones(len(places), np.float32),
        "rotations": np.asarray(rotations, np.float32),
    }
    of_kind, meshes, pictures = points.choices([described])
    points.fill(mesh, cloud, of_kind)
    ob = bpy.data.objects.new("Plants", mesh)
    scene = bpy.context.scene
    scene.collection.objects.link(ob)
    modifier = ob.modifiers.new("Plants", "NODES")
    modifier.node_group = nodes.ensure()
    group.set_input(modifier, "Meshes", store.fill(scene, "Test meshes", meshes))
    group.set_input(modifier, "Impostors", store.fill(scene, "Test impostors", pictures))
    group.set_input(modifier, "Camera", _camera(scene, ob))
    return ob


def fade(ob, near, far):
    group = steps.addon("nodes.group")
    group.set_input(ob.modifiers[0], "Fade Near", near)
    group.set_input(ob.modifiers[0], "Fade Far", far)
    ob.update_tag()


def eight_views(described, pixels):
    """The plant eight times in a row, each turned on by an eighth; and the size of the picture."""
    picture = bpy.data.objects[f"Orogen {described['variants'][0]} picture"]
    across, along, height = picture.dimensions
    width = 1.1 * max(across, along)
    places = [((view + 0.5) * width, 0.0, 0.0) for view in range(8)]
    turns = [-math.pi / 2 - view * math.pi / 4 for view in range(8)]
    ob = stand(described, places, turns)
    camera = bpy.context.scene.camera
    camera.location = (4.0 * width, -1000.0, 0.5 * height - 1.0)
    camera.data.ortho_scale = 8.0 * width
    tall = math.ceil(pixels * (height + 2.0) / width)
    render = bpy.context.scene.render
    render.resolution_x, render.resolution_y = 8 * pixels, tall
    return ob


def picture(folder, samples=16):
    """The scene rendered by Cycles: linear colours and alpha (rows from below, columns, 4)."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = samples, False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.transparent_max_bounces = 64
    scene.render.film_transparent = True
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.filepath = str(folder / "picture.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    pixels = np.array(image.pixels[:]).reshape(image.size[1], image.size[0], 4)
    bpy.data.images.remove(image)
    return pixels


def light(elevation=0.7, azimuth=0.8):
    """A sun to the left of whoever looks north, and an even sky."""
    scene = bpy.context.scene
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.data.energy = 3.0
    sun.rotation_euler = (math.pi / 2 - elevation, 0.0, -azimuth)
    scene.collection.objects.link(sun)
    scene.world = bpy.data.worlds.new("Even")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"]
    background.inputs[0].default_value = (0.3, 0.4, 0.5, 1.0)


def _camera(scene, ob):
    data = bpy.data.cameras.new("Camera")
    data.type, data.sensor_fit, data.clip_end = "ORTHO", "HORIZONTAL", 1e5
    camera = bpy.data.objects.new("Camera", data)
    camera.rotation_euler = (math.pi / 2, 0.0, 0.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    return camera
