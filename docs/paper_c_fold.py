"""A fold as cliffs show it, and as it is: part of `./dev validate`, run with the package bpy.

The ground in the colours of its rock; a horizon, solid where ground covers it (seen on the block's
walls) and like glass where erosion took it; and the lines along which it comes to light.
"""

import json
import os
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "python_addon"))

import demo_collision  # noqa: E402
import demo_scene  # noqa: E402

SIZE = (18e3, 13e3)
RESOLUTION = 600
HORIZON = 2  # top of the Lias and Dogger, under the Malm's limestone
GLASS_SHARE = 0.5
GLASS, TRACE = (0.95, 0.55, 0.15), (0.75, 0.06, 0.04)


def recipe():
    x, y = SIZE
    south = [[-x, -y], [2 * x, -y], [2 * x, 0.02 * y], [-x, 0.02 * y]]
    north = [[-x, 0.98 * y], [2 * x, 0.98 * y], [2 * x, 2 * y], [-x, 2 * y]]
    return {
        "orogen": 1,
        "name": "fold",
        "extent": {"origin": [0, 0], "size": list(SIZE)},
        "resolution": RESOLUTION,
        "phases": [
            {
                "years": 4e6,
                "plates": [
                    {"points": south, "arrows": [[0, 0.1 * y]] * 4},
                    {"points": north, "arrows": [[0, 0]] * 4},
                ],
            }
        ],
        "column": {"preset": "jura"},
        "stages": [
            {"stage": "collision", "parameters": {"fault": False, "crust_smoothing": 2000.0}},
            {"stage": "fold_layers"},
            {
                "stage": "mountain_growth",
                "parameters": {"west_side": "closed", "east_side": "closed"},
            },
            {"stage": "rock_detail"},
            {"stage": "outcrop"},
        ],
    }


def add_child(bpy, terrain, name, data):
    child = bpy.data.objects.new(name, data)
    child.parent = terrain
    across, up = terrain.orogen.local_scale()
    offset = terrain.data["orogen_offset"]
    child.location = (offset[0] * across, offset[1] * across, 0.0)
    child.scale = (across, across, up)
    bpy.context.scene.collection.objects.link(child)
    return child


def material(bpy, name, colour, alpha):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Alpha"].default_value = alpha
    shader.inputs["Roughness"].default_value = 0.4
    return made


def add_glass(bpy, terrain, rocks, ground):
    """The horizon where it lay above the ground of today."""
    mesh = rocks.horizon_mesh(HORIZON, only_below_ground=False)
    height = rocks.horizons[HORIZON].ravel()
    gone = height > ground.ravel() - 5.0
    near = mesh["vertices"][:, 0] < GLASS_SHARE * SIZE[0]  # beyond, the bare ground is seen
    faces = mesh["faces"][(gone & near)[mesh["faces"]].all(1)]
    used, corners = np.unique(faces, return_inverse=True)
    data = bpy.data.meshes.new("Eroded horizon")
    vertices = mesh["vertices"][used].tolist()
    data.from_pydata(vertices, [], corners.reshape(-1, 4).tolist())
    data.polygons.foreach_set("use_smooth", np.ones(len(faces), bool))
    data.materials.append(material(bpy, "Glass", GLASS, 0.3))
    add_child(bpy, terrain, "Eroded horizon", data)


def add_traces(bpy, terrain, rocks, cell):
    data = bpy.data.curves.new("Traces", "CURVE")
    data.dimensions = "3D"
    data.bevel_depth = 0.45 * cell
    for trace in rocks.horizon_traces(HORIZON):
        if len(trace) < 12:
            continue
        spline = data.splines.new("POLY")
        spline.points.add(len(trace) - 1)
        raised = np.column_stack([trace[:, :2], trace[:, 2] + 0.3 * cell, np.ones(len(trace))])
        spline.points.foreach_set("co", raised.astype(np.float32).ravel())
    data.materials.append(material(bpy, "Trace", TRACE, 1.0))
    add_child(bpy, terrain, "Traces", data)


def build(bpy, terrain):
    import orogen

    grown = orogen.generate(json.loads(terrain.data["orogen_recipe"]))
    bpy.ops.orogen.add_block()
    add_glass(bpy, terrain, grown.rocks, grown["elevation"])
    add_traces(bpy, terrain, grown.rocks, grown.grid.cell_size)
    demo_collision.light_and_camera(bpy, terrain, turn=36.0, tilt=27.0, middle=-0.08)


def main(picture):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "fold.orogen.json"
        file.write_text(json.dumps(recipe()))
        bpy = demo_scene.install_extension(Path(folder))
        terrain = demo_scene.grow(bpy, file)
        terrain.orogen.stages.outcrop.palette = "map"
        terrain.orogen.bare_rock = 1.0
        terrain.orogen.vertical_exaggeration = 1.3
        bpy.ops.orogen.grow()
        build(bpy, terrain)
        demo_scene.render(bpy, picture, 1280, 32, transform="Standard")
        bpy.ops.preferences.addon_disable(module=demo_scene.ADDON)
    sys.stdout.flush()
    os._exit(0)  # bpy's own end may hang


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
