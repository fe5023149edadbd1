"""The picture of a range between colliding plates as a block diagram.

Part of demo_scene.py, which see.
"""

import importlib
import math

import numpy as np

LIE = "bl_ext.user_default.orogen.outdoors.lie"
BLOCK_EXAGGERATION = 2.5
PAPER = (0.82, 0.80, 0.75)


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
    lie = importlib.import_module(LIE).of(terrain)
    axis, across = lie.axis, lie.front
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


def add_camera(bpy, terrain, eye, target, lens):
    from mathutils import Vector

    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    eye, target = (terrain.matrix_world @ Vector(place) for place in (eye, target))
    camera.data.lens, camera.data.clip_end = lens, 100.0 * max(terrain.dimensions)
    camera.location = eye
    camera.rotation_euler = (target - eye).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera
