"""Plates and their arrows: adding and removing."""

import bpy
import numpy as np

from .. import terrains
from ..properties.session import tell
from ..scene import new_inputs
from ..scene.plane import Planes, cursor_place
from ..scene.plates import active_plate, plate_collections, read_plate
from ..scene.rigid import NotRigid, make_rigid

PUSH = 0.15  # of the frame's height: how far a new plate moves
SIZE = 0.35  # of the frame: a new plate's width and height


def add_arrow(context, terrain, plate, point, vector):
    """Adds an arrow (m on the plane) and makes it active; the plate's arrows follow if they are to
    be rigid."""
    terrains.activate(context, new_inputs.add_arrow(terrain, plate, point, vector))
    if terrain.orogen.input.rigid_arrows:
        context.view_layer.update()  # the new one's place in the world
        try:
            make_rigid(terrain, plate)
        except NotRigid as error:
            tell(context, str(error), is_error=True)


class PlateOperator:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("A terrain of moving plates is wanted, in object mode")
        terrain = terrains.own(context)
        if context.mode != "OBJECT" or terrain is None:
            return False
        return terrain.orogen.source == "PLATES"


class OROGEN_OT_add_plate(PlateOperator, bpy.types.Operator):
    """Add a plate of four arrows around the 3D cursor, or amid the frame if that lies elsewhere"""

    bl_idname = "orogen.add_plate"
    bl_label = "Add Plate"

    def execute(self, context):
        terrain = terrains.active(context)
        size = 1000.0 * np.array(terrain.orogen.input.frame_km)
        plate = new_inputs.add_plate(terrain, "Plate")
        middle = cursor_place(terrain, context.scene, size)
        for corner in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            point = middle + 0.5 * SIZE * size * corner
            new_inputs.add_arrow(terrain, plate, point, (0.0, PUSH * size[1]))
        return {"FINISHED"}


class ActivePlateOperator(PlateOperator):
    @classmethod
    def poll(cls, context):
        if not super().poll(context):
            return False
        cls.poll_message_set("Pick a plate in the list, or one of its arrows")
        return active_plate(context, terrains.active(context)) is not None


class OROGEN_OT_add_arrow(ActivePlateOperator, bpy.types.Operator):
    """Add an arrow to the active plate, at the 3D cursor, that moves as its others do"""

    bl_idname = "orogen.add_arrow"
    bl_label = "Add Arrow"

    def execute(self, context):
        terrain = terrains.active(context)
        plate, planes = active_plate(context, terrain), Planes(terrain)
        arrows = read_plate(plate, planes)["arrows"]
        vector = np.mean(arrows, axis=0).tolist() if arrows else (0.0, 0.0)
        point = planes.of(terrain).metres(context.scene.cursor.location)[0, :2]
        add_arrow(context, terrain, plate, point, vector)
        return {"FINISHED"}


class MakesRigid(PlateOperator):
    plate: bpy.props.StringProperty(
        name="Plate", description="Name of its collection; the active plate if empty"
    )

    def execute(self, context):
        terrain = terrains.active(context)
        plates = {plate.name: plate for plate in plate_collections(terrain, context.scene)}
        plate = plates.get(self.plate) if self.plate else active_plate(context, terrain)
        if plate is None:
            self.report({"WARNING"}, "Pick a plate in the list, or one of its arrows")
            return {"CANCELLED"}
        try:
            make_rigid(terrain, plate)
        except NotRigid as error:
            self.report({"WARNING"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class OROGEN_OT_make_rigid(MakesRigid, bpy.types.Operator):
    """Turn and stretch the arrows of a plate to the rigid motion that is nearest to them all"""

    bl_idname = "orogen.make_rigid"
    bl_label = "Make Rigid"


class OROGEN_OT_follow_move(MakesRigid, bpy.types.Operator):
    """Make a plate's arrows rigid, in the step of undo that moved one"""

    bl_idname = "orogen.follow_move"
    bl_label = "Follow Move"
    bl_options = {"INTERNAL", "UNDO_GROUPED"}
    bl_undo_group = "Move"  # as Blender calls its step, which this one replaces


class OROGEN_OT_follow_rotate(MakesRigid, bpy.types.Operator):
    """Make a plate's arrows rigid, in the step of undo that turned one"""

    bl_idname = "orogen.follow_rotate"
    bl_label = "Follow Rotate"
    bl_options = {"INTERNAL", "UNDO_GROUPED"}
    bl_undo_group = "Rotate"


class OROGEN_OT_follow_resize(MakesRigid, bpy.types.Operator):
    """Make a plate's arrows rigid, in the step of undo that scaled one"""

    bl_idname = "orogen.follow_resize"
    bl_label = "Follow Resize"
    bl_options = {"INTERNAL", "UNDO_GROUPED"}
    bl_undo_group = "Resize"


class OROGEN_OT_remove_plate(ActivePlateOperator, bpy.types.Operator):
    """Remove the active plate and its arrows"""

    bl_idname = "orogen.remove_plate"
    bl_label = "Remove Plate"

    def execute(self, context):
        terrain = terrains.active(context)
        plate = active_plate(context, terrain)
        terrains.activate(context, terrain)
        for ob in list(plate.objects):
            bpy.data.objects.remove(ob)
        bpy.data.collections.remove(plate)
        settings = terrain.orogen.input
        settings.active_plate = max(0, settings.active_plate - 1)
        return {"FINISHED"}
