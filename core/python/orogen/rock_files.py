"""Files of grown mountains: their rocks' sections, block diagrams, horizons; their mesh."""

import math
import os

from . import _core

LARGEST = 2048  # pixels along the longer side of a picture
HEIGHT_TO_LENGTH = 0.25  # of a section as drawn, if it can be had by exaggerating heights
SECTION_SUFFIXES = (".svg", ".png", ".ply")


def check_rocks(recipe):
    """InputError unless the recipe's terrains have rocks below them."""
    document = recipe.to_dict()
    if "column" not in document:
        raise _core.InputError("section, ply: the recipe has no column of layers to be cut open")
    if all(stage["stage"] != "outcrop" for stage in document["stages"]):
        raise _core.InputError("section, ply: the recipe lacks the stage 'outcrop'")


def check_tin(recipe):
    """InputError unless the recipe's terrains grow on a mesh."""
    if all(stage["stage"] != "mountain_growth" for stage in recipe.to_dict()["stages"]):
        raise _core.InputError("tin: the recipe lacks the stage 'mountain_growth'")


def section_line(grid, line=None):
    """The line [(x0, y0), (x1, y1)] of a section in metres, checked; default: through the middle,
    from south to north."""
    (left, low), (nx, ny) = grid.origin, (grid.nx, grid.ny)
    right, high = left + nx * grid.cell_size, low + ny * grid.cell_size
    if line is None:
        middle = 0.5 * (left + right)
        return [(middle, low), (middle, high)]
    (x0, y0), (x1, y1) = line = [(float(x), float(y)) for x, y in line]
    for x, y in line:
        if not (left <= x <= right and low <= y <= high):
            raise _core.InputError(
                f"section: ({x:g}, {y:g}) lies outside the terrain, which reaches from "
                f"({left:g}, {low:g}) to ({right:g}, {high:g}) m"
            )
    if math.hypot(x1 - x0, y1 - y0) < 1e-3 * grid.cell_size:
        raise _core.InputError("section: its two ends are the same place")
    return line


def write_section(rocks, line, file, origin):
    """Writes a section as .svg, .png or .ply."""
    section = rocks.section(line)
    suffix = os.path.splitext(file)[1]
    if suffix == ".svg":
        with open(file, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(section.svg(_exaggeration(section)))
    elif suffix == ".png":
        from .image_files import write_png

        write_png(file, section.picture(*picture_size(section)))
    else:
        write_ply(file, section.mesh(), origin)


def _height(section):
    return float(section.surface.max()) - section.base


def _exaggeration(section):
    """How many times as tall as lengths heights are drawn: a whole number."""
    times = HEIGHT_TO_LENGTH * section.distance[-1] / _height(section)
    return min(max(1, round(times)), 1000)


def picture_size(section):
    width, height = section.distance[-1], _exaggeration(section) * _height(section)
    scale = LARGEST / max(width, height)
    return max(1, round(width * scale)), max(1, round(height * scale))


def write_ply(file, mesh, origin):
    """Writes a mesh with the colour, layer and sub-layer of each face as binary PLY.

    x and y count from the terrain's lower-left corner, which a comment names.
    """
    import numpy

    faces = mesh["faces"]
    # A corner that is named twice makes a triangle of a quadrangle.
    is_first = numpy.stack([(faces[:, :k] != faces[:, k : k + 1]).all(1) for k in range(4)], axis=1)
    corners = is_first.sum(1)
    with open(file, "wb") as stream:
        sizes = len(mesh["vertices"]), (corners >= 3).sum()
        stream.write(_ply_header("xyz", *sizes, origin, _ROCK_PROPERTIES))
        stream.write(mesh["vertices"].astype("<f4").tobytes())
        for count in (3, 4):
            of = corners == count
            rows = numpy.empty(of.sum(), _ply_face(count))
            rows["count"] = count
            rows["corners"] = faces[of][is_first[of]].reshape(-1, count)
            rows["color"] = mesh["color"][of]
            rows["rock"] = numpy.stack([mesh["layer"][of], mesh["sub_layer"][of]], axis=1)
            stream.write(rows.tobytes())


def write_tin(file, tin, origin):
    """Writes the triangles of a `GrownTin` as binary PLY; each vertex has the depth of the sediment
    on it, if rivers laid any down. Places count from `origin`, as those of other meshes."""
    import numpy

    columns = [tin.points - numpy.asarray(origin), tin.elevation[:, None]]
    names = ["x", "y", "z"]
    if len(tin.sediment_thickness):
        columns.append(tin.sediment_thickness[:, None])
        names.append("sediment_thickness")
    rows = numpy.empty(len(tin.triangles), [("count", "u1"), ("corners", "<i4", (3,))])
    rows["count"] = 3
    rows["corners"] = tin.triangles
    with open(file, "wb") as stream:
        stream.write(_ply_header(names, len(tin), len(rows), origin, ()))
        stream.write(numpy.hstack(columns).astype("<f4").tobytes())
        stream.write(rows.tobytes())


def _ply_face(corners):
    return [
        ("count", "u1"),
        ("corners", "<i4", (corners,)),
        ("color", "u1", (3,)),
        ("rock", "<i4", (2,)),
    ]


_ROCK_PROPERTIES = (
    *(f"property uchar {channel}" for channel in ("red", "green", "blue")),
    *(f"property int {name}" for name in ("layer", "sub_layer")),
)


def _ply_header(names, vertices, faces, origin, of_faces):
    lines = [
        "ply",
        "format binary_little_endian 1.0",
        f"comment Orogen {_core.__version__}; metres from {origin[0]!r} {origin[1]!r}",
        f"element vertex {vertices}",
        *(f"property float {name}" for name in names),
        f"element face {faces}",
        "property list uchar int vertex_indices",
        *of_faces,
        "end_header",
    ]
    return ("\n".join(lines) + "\n").encode("ascii")
