"""Paint on a terrain's vertices: colour attributes that stay when the grid changes its size.

While the mesh is coarser than what was painted, as it is under a live preview, the detail is a
property of the mesh, bytes of float32. What is painted on the coarse mesh goes into it.
"""

import numpy as np

from . import attributes

PREFIX = "orogen_paint_"
DETAIL = "orogen_detail_"  # and the name of the attribute: its shape and values
NEUTRAL = 0.5


def name_of(layer):
    return PREFIX + layer


def ensure(mesh, layer, value=NEUTRAL):
    """The attribute of a layer, all of it `value` where it is new."""
    name = name_of(layer)
    if name not in mesh.attributes:
        _write_grey(mesh, name, np.full(len(mesh.vertices), value, np.float32))
    return mesh.attributes[name]


def remove(mesh, layer):
    name = name_of(layer)
    mesh.pop(DETAIL + name, None)
    if attribute := mesh.attributes.get(name):
        mesh.attributes.remove(attribute)


def read(mesh, layer):
    """The grey of a layer (rows, columns), or None."""
    return _read(mesh, name_of(layer))


def take(mesh):
    """The layers by the names of their attributes, as (rows, columns), before the mesh changes its
    grid."""
    names = [a.name for a in mesh.attributes if a.name.startswith(PREFIX)]
    layers = {name: _read(mesh, name) for name in names}
    return {name: values for name, values in layers.items() if values is not None}


def put(mesh, layers):
    """Carries layers to the mesh's new grid: of each vertex the nearest value."""
    nx, ny = mesh["orogen_grid"]
    for name in [name for name in mesh.keys() if name.startswith(DETAIL)]:
        del mesh[name]
    for name, values in layers.items():
        if values.size > nx * ny:
            mesh[DETAIL + name] = {"shape": list(values.shape), "values": values.tobytes()}
        _write_grey(mesh, name, nearest(values, (ny, nx)))


def nearest(values, shape):
    """The values (rows, columns) on a grid of another shape."""
    places = (
        np.minimum((np.arange(n) + 0.5) * of / n, of - 1).astype(int)
        for n, of in zip(shape, values.shape, strict=True)
    )
    return values[np.ix_(*places)]


def _read(mesh, name):
    """A layer as it is seen, in the detail that is known of it."""
    if "orogen_grid" not in mesh:
        return None
    nx, ny = mesh["orogen_grid"]
    attribute = mesh.attributes.get(name)
    if attribute is None or len(attribute.data) != nx * ny:
        return None
    colors = np.empty((ny, nx, 4), np.float32)
    attribute.data.foreach_get("color", colors.ravel())
    # In double a grey's mean is the grey, to the bit.
    seen = colors[..., :3].mean(axis=-1, dtype=np.float64).astype(np.float32)
    kept = mesh.get(DETAIL + name)
    if kept is None:
        return seen
    detail = np.frombuffer(kept["values"], np.float32).reshape(*kept["shape"])
    painted = seen != nearest(detail, seen.shape)
    if painted.any():
        detail = np.where(nearest(painted, detail.shape), nearest(seen, detail.shape), detail)
    return detail


def _write_grey(mesh, name, grey):
    colors = np.ones((grey.size, 4), np.float32)
    colors[:, :3] = grey.reshape(-1, 1)
    attributes.write_linear(mesh, name, colors, "POINT")
