"""Paint on a terrain's vertices: colour attributes that stay when the grid changes its size."""

import numpy as np

PREFIX = "orogen_paint_"
NEUTRAL = 0.5


def name_of(layer):
    return PREFIX + layer


def ensure(mesh, layer, value=NEUTRAL):
    """The attribute of a layer, all of it `value` where it is new."""
    attribute = mesh.attributes.get(name_of(layer))
    if attribute is None:
        attribute = mesh.attributes.new(name_of(layer), "FLOAT_COLOR", "POINT")
        colors = np.full((len(mesh.vertices), 4), value, np.float32)
        colors[:, 3] = 1.0
        attribute.data.foreach_set("color", colors.ravel())
    return attribute


def read(mesh, layer):
    """The grey of a layer (ny, nx), or None."""
    found = take(mesh, name_of(layer))
    return found[name_of(layer)][..., :3].mean(axis=-1) if found else None


def take(mesh, beginning=PREFIX):
    """The layers whose names begin so, by name, as (ny, nx, 4)."""
    if "orogen_grid" not in mesh:
        return {}
    nx, ny = mesh["orogen_grid"]
    layers = {}
    for attribute in mesh.attributes:
        if attribute.name.startswith(beginning) and len(attribute.data) == nx * ny:
            colors = np.empty(nx * ny * 4, np.float32)
            attribute.data.foreach_get("color", colors)
            layers[attribute.name] = colors.reshape(ny, nx, 4)
    return layers


def put(mesh, layers):
    """Carries layers to the mesh's new grid: of each vertex the nearest one's colour."""
    nx, ny = mesh["orogen_grid"]
    for name, colors in layers.items():
        rows, columns = (
            np.minimum((np.arange(n) + 0.5) * of / n, of - 1).astype(int)
            for n, of in zip((ny, nx), colors.shape[:2], strict=True)
        )
        attribute = mesh.attributes.new(name, "FLOAT_COLOR", "POINT")
        attribute.data.foreach_set("color", colors[np.ix_(rows, columns)].ravel())
