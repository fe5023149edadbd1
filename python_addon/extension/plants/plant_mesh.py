"""A plant's mesh from the core's arrays."""

import numpy as np

UV = "UVMap"
ARRAYS = ("positions", "corners", "face_starts", "uvs", "materials")


def write(mesh, arrays):
    """Arrays as a `PlantMesh` of the core has them; lengths in metres."""
    starts = np.ascontiguousarray(arrays["face_starts"][:-1])
    mesh.clear_geometry()
    mesh.vertices.add(len(arrays["positions"]))
    mesh.loops.add(len(arrays["corners"]))
    mesh.polygons.add(len(starts))
    mesh.attributes["position"].data.foreach_set("vector", arrays["positions"].ravel())
    mesh.polygons.foreach_set("loop_start", starts)
    mesh.attributes[".corner_vert"].data.foreach_set("value", arrays["corners"])
    mesh.update(calc_edges=True)
    layer = mesh.uv_layers.get(UV) or mesh.uv_layers.new(name=UV)
    layer.uv.foreach_set("vector", arrays["uvs"].ravel())
    mesh.polygons.foreach_set("material_index", arrays["materials"].astype(np.int32))
    mesh.polygons.foreach_set("use_smooth", arrays["materials"] == 0)
    mesh.update()
