"""UV coordinates over the map: 0 to 1 from its sides, so that a picture of a terrain, a pixel a
cell, lies on it pixel by pixel."""

import numpy as np

LAYER = "UVMap"


def of_grid(nx, ny):
    """(ny * nx, 2) for the cells' centres."""
    u, v = np.meshgrid((np.arange(nx) + 0.5) / nx, (np.arange(ny) + 0.5) / ny)
    return np.stack([u.ravel(), v.ravel()], axis=-1).astype(np.float32)


def write(mesh, of_vertices):
    """Sets the layer from what each vertex has."""
    layer = mesh.uv_layers.get(LAYER) or mesh.uv_layers.new(name=LAYER)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.attributes[".corner_vert"].data.foreach_get("value", corners)
    layer.uv.foreach_set("vector", of_vertices[corners].ravel())
