"""Pictures of a range between colliding plates: the range itself, and its block diagram.

Part of demo_scene.py, which see.
"""

import math

import numpy as np

HAZE_START, HAZE_END = 0.45, 1.7  # of the terrain's size
HAZE_COLOUR, HAZE_STRENGTH = (0.80, 0.86, 0.92), 1.5
RANGE_EXAGGERATION, BLOCK_EXAGGERATION = 1.4, 2.5
PAPER = (0.82, 0.80, 0.75)


def build_range(bpy, terrain, add_sky, add_haze):
    """From over the foreland, across the range, with the sun from the side."""
    terrain.orogen.vertical_exaggeration = RANGE_EXAGGERATION
    bpy.context.view_layer.update()
    width, axis, middle = lie_of(terrain)
    across = np.array([axis[1], -axis[0]])
    size, top = max(terrain.dimensions[:2]), terrain.dimensions[2]
    eye = middle + across * 0.72 * width - axis * 0.05 * size
    target = middle + across * 0.1 * width
    add_camera(bpy, terrain, (*eye, 1.75 * top), (*target, 0.95 * top), lens=45.0)
    add_plain(bpy, terrain, 60.0 * size)
    azimuth = math.degrees(math.atan2(*(0.8 * across - axis)))
    add_sky(bpy, bpy.context.scene, elevation=24.0, azimuth=azimuth)
    add_haze(
        terrain.data.materials[0],
        HAZE_START * size,
        HAZE_END * size,
        most=0.98,
        colour=HAZE_COLOUR,
        strength=HAZE_STRENGTH,
    )


def build_block(bpy, terrain):
    """As textbooks draw it: in the colours of geological maps, on paper, in even light, with the
    wall that cuts the range in front."""
    terrain.orogen.stages.outcrop.palette = "map"
    terrain.orogen.vertical_exaggeration = BLOCK_EXAGGERATION
    terrain.orogen.bare_rock = 1.0
    bpy.ops.orogen.grow()
    bpy.ops.orogen.add_block()
    light_and_camera(bpy, terrain, turn=32.0, tilt=24.0, middle=-0.03)


def light_and_camera(bpy, terrain, turn, tilt, middle):
    """The whole block on paper, seen from `turn` degrees off its axis and `tilt` above; `middle`:
    height of the picture's middle over the terrain's size."""
    bpy.context.view_layer.update()
    scene = bpy.context.scene
    _, axis, _ = lie_of(terrain)
    across = np.array([axis[1], -axis[0]])
    size, turn, tilt = max(terrain.dimensions[:2]), math.radians(turn), math.radians(tilt)
    towards = across * math.sin(turn) - axis * math.cos(turn)
    direction = np.array([*(towards * math.cos(tilt)), math.sin(tilt)])
    target = np.array([0.0, 0.0, middle * size])
    add_camera(bpy, terrain, target + 4.0 * size * direction, target, lens=104.0)
    sun = bpy.data.objects.new("Lamp", bpy.data.lights.new("Lamp", "SUN"))
    sun.data.energy, sun.data.angle = 2.6, math.radians(3.0)
    azimuth = math.atan2(*(across - 0.8 * axis))
    sun.rotation_euler = (math.radians(58.0), 0.0, math.pi - azimuth)
    scene.collection.objects.link(sun)
    add_paper(bpy, scene)


def add_paper(bpy, scene):
    """Pale behind the block, though the light from there is faint."""
    world = scene.world = bpy.data.worlds.new("Paper")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    nodes["Background"].inputs["Color"].default_value = (*PAPER, 1.0)
    strength = nodes.new("ShaderNodeMapRange")
    seen = nodes.new("ShaderNodeLightPath").outputs["Is Camera Ray"]
    links.new(seen, strength.inputs["Value"])
    strength.inputs["To Min"].default_value = 0.5
    links.new(strength.outputs[0], nodes["Background"].inputs["Strength"])


def lie_of(terrain):
    """Width (four standard deviations), direction and middle of the high ground."""
    count = len(terrain.data.vertices)
    points = np.empty(3 * count, np.float32)
    terrain.data.vertices.foreach_get("co", points)
    points = points.reshape(-1, 3).astype(float)
    weight = np.maximum(points[:, 2], 0.0)
    middle = np.average(points[:, :2], axis=0, weights=weight)
    spread = np.cov(points[:, :2].T, aweights=weight)
    values, vectors = np.linalg.eigh(spread)
    axis = vectors[:, 1] * (1.0 if vectors[0, 1] >= 0 else -1.0)
    return 4.0 * math.sqrt(values[0]), axis, middle


def add_plain(bpy, terrain, size):
    """Land to the horizon, a hair below the terrain's lowest ground."""
    depth = min(corner[2] for corner in terrain.bound_box) - 1e-3 * terrain.dimensions[2]
    mesh = bpy.data.meshes.new("Plain")
    corners = [(-size, -size), (size, -size), (size, size), (-size, size)]
    mesh.from_pydata([(x, y, depth) for x, y in corners], [], [(0, 1, 2, 3)])
    mesh.materials.append(terrain.data.materials[0])
    plain = bpy.data.objects.new("Plain", mesh)
    plain.parent = terrain
    bpy.context.scene.collection.objects.link(plain)


def add_camera(bpy, terrain, eye, target, lens):
    from mathutils import Vector

    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    eye, target = (terrain.matrix_world @ Vector(place) for place in (eye, target))
    camera.data.lens, camera.data.clip_end = lens, 100.0 * max(terrain.dimensions)
    camera.location = eye
    camera.rotation_euler = (target - eye).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera
