"""A mesh of rock from the core's arrays, each face of the colour of its layer."""

import numpy as np

from . import attributes


def write(mesh, arrays):
    """`vertices` (n, 3) in metres, `faces` (m, 4), whose corners may be named twice, and of each
    face `layer`, `sub_layer` and `color` (sRGB bytes)."""
    faces = arrays["faces"]
    kept = faces != np.roll(faces, 1, axis=1)
    corners = kept.sum(axis=1).astype(np.int32)
    mesh.clear_geometry()
    mesh.vertices.add(len(arrays["vertices"]))
    mesh.loops.add(int(corners.sum()))
    mesh.polygons.add(len(faces))
    starts = np.concatenate([[0], np.cumsum(corners)[:-1]]).astype(np.int32)
    mesh.polygons.foreach_set("loop_start", starts)
    mesh.attributes[".corner_vert"].data.foreach_set("value", faces[kept])
    positions = np.ascontiguousarray(arrays["vertices"], np.float32)
    mesh.attributes["position"].data.foreach_set("vector", positions.ravel())
    mesh.update(calc_edges=True)
    for name in ("layer", "sub_layer"):
        attributes.write_values(mesh, name, arrays[name], "FACE")
    # On corners: there Blender counts it as a colour, in the solid view and for exporters too.
    colors = np.repeat(arrays["color"], corners, axis=0)
    attributes.write_colors(mesh, attributes.STRATA_COLOR, colors, "CORNER")
