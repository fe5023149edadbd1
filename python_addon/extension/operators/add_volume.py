"""The rocks below a terrain as a volume object."""

import json
import os

import bpy

from ..mesh import attributes, volume_object
from ..mesh.terrain_mesh import NotNow
from .product_operator import RocksOperator


class OROGEN_OT_add_volume(RocksOperator, bpy.types.Operator):
    """Write the rocks into an OpenVDB file beside the .blend, and add them as a volume: in each
    voxel the number of its sub-layer, and a material with the layers' colours"""

    bl_idname = "orogen.add_volume"
    bl_label = "Add Rock Volume"
    kind = "volume"

    filepath: bpy.props.StringProperty(
        name="File",
        subtype="FILE_PATH",
        description="The volume. Without one: beside the .blend, by the terrain's name",
        options={"SKIP_SAVE"},
    )
    voxel_height: bpy.props.FloatProperty(
        name="Voxel Height (m)",
        description="Across, a voxel is as wide as a cell of the terrain",
        default=100.0,
        min=1.0,
        max=10000.0,
    )

    def wishes(self, context, terrain):
        self._file = self._where(terrain)
        return {"file": self._file, "voxel_height": self.voxel_height}

    def take(self, context, terrain, result):
        rocks = json.loads(terrain.data[attributes.ROCKS])
        volume_object.write(terrain, self._file, rocks)

    def _where(self, terrain):
        if self.filepath:
            return os.path.abspath(bpy.path.abspath(self.filepath))
        if not bpy.data.filepath:
            raise NotNow("Save the .blend first: the volume's file lies beside it")
        return bpy.path.abspath(f"//{bpy.path.clean_name(terrain.name)}_rock.vdb")
