"""A camera, the sun, sky and air for a picture of a terrain."""

import math

import bpy

from .. import terrains
from ..material import haze, sea_material, sky, terrain_material
from ..mesh import sea, surroundings
from ..mesh.roles import ROLE
from ..outdoors import camera, lie, light
from ..properties.session import tell

HAZED = (terrain_material.NAME, sea_material.NAME)  # materials that lie behind the air

SUN_ELEVATION = bpy.props.FloatProperty(
    name="Sun Elevation",
    description="Low light shows the relief",
    subtype="ANGLE",
    default=math.radians(24.0),
    min=0.0,
    max=math.pi / 2,
)
HAZE = bpy.props.FloatProperty(
    name="Haze",
    description="How much the air hides of what is in the middle of the picture",
    subtype="FACTOR",
    default=0.15,
    min=0.0,
    max=0.99,
)


class OROGEN_OT_set_up_scene(bpy.types.Operator):
    """Add what a picture of the terrain wants: a camera in the air, the sun, sky, haze, and ground
    or sea to the horizon. The scene's own camera and world are kept"""

    bl_idname = "orogen.set_up_scene"
    bl_label = "Set Up Scene"
    bl_options = {"REGISTER", "UNDO"}

    turn: bpy.props.FloatProperty(
        name="Turn",
        description="Around the range: 0 looks across it from the south",
        subtype="ANGLE",
        default=0.0,
        soft_min=-math.pi,
        soft_max=math.pi,
    )
    farther: bpy.props.FloatProperty(
        name="Farther",
        description="How many times as far off, and as high, as where the relief fills the picture",
        default=1.0,
        min=0.1,
        max=100.0,
        soft_max=5.0,
    )
    sun_elevation: SUN_ELEVATION
    haze: HAZE

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Grow a terrain first")
        terrain = terrains.own(context)
        return terrain is not None and "orogen_grid" in terrain.data

    def execute(self, context):
        if context.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        terrain, scene = terrains.active(context), context.scene
        before = scene.camera, scene.world, *(ob for ob in scene.objects if ob.type == "LIGHT")
        lies = lie.of(terrain)
        ours = camera.place(scene, terrain, lies, self.turn, self.farther)
        light.place(scene, terrain, camera.direction(lies, self.turn), self.sun_elevation)
        light.show_sky(scene)
        light.set_colours(scene)
        surroundings.add(terrain)
        sea.update(terrain, terrain.orogen, below_sea=sea.is_shown(terrain))
        add_haze(self.haze, (ours.location - terrain.matrix_world.translation).length)
        look_through(context, ours)
        tell(context, f"Camera, sun and sky are set up{still_there(before)}")
        return {"FINISHED"}


def add_haze(share, distance):
    """Air that hides so much of what is at that distance, in Blender units."""
    tree = haze.ensure(-math.log(1.0 - share) / distance)
    for name in HAZED:
        if material := bpy.data.materials.get(name):
            haze.put_over(material, tree)


def still_there(things):
    """What the scene had of its own, camera, world and lights, and has yet."""
    theirs = (thing for thing in things if thing and not is_ours(thing))
    names = [f"{thing.bl_rna.name.lower()} '{thing.name}'" for thing in theirs]
    return f". Still there: {', '.join(names)}" if names else ""


def is_ours(thing):
    return ROLE in thing or thing.name == sky.NAME


def look_through(context, camera):
    """Shows the picture in the view that asked for it."""
    space = context.space_data
    if space and space.type == "VIEW_3D":
        space.region_3d.view_perspective = "CAMERA"
        space.clip_start = max(space.clip_start, camera.data.clip_start)
        space.clip_end = max(space.clip_end, camera.data.clip_end)
