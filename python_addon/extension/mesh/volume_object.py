"""The rocks below a terrain as a volume object: a child of the terrain, in metres."""

import bpy
import numpy as np

from ..material import volume_material
from . import children, paths

ROLE = "volume"


def write(terrain, file, rocks):
    """`file`: the core's index volume, whose places count from the map's own origin. `rocks`: what
    its numbers mean."""
    ob = children.renew(terrain, ROLE, [ROLE], bpy.data.volumes.new)[ROLE]
    ob.data.filepath = paths.relative(file)
    if not ob.data.materials:
        ob.data.materials.append(volume_material.new(f"{terrain.name} Rocks", rocks))
    offset = np.subtract(terrain.data["orogen_offset"], terrain.data["orogen_origin"])
    children.place(ob, terrain, offset.tolist())
