"""What was changed in the meshes of folds, as a recipe's fold edits.

Each mesh remembers what it was made of: its vertices carry their numbers (one more than the place
in START, so that 0 is a new one), and properties of the object hold where they were, which edges
joined them, and the edits that had led there.
"""

import json

import bmesh
import numpy as np

STAGE = "fold_layers"
NUMBER = "orogen_fold_point"  # attribute of vertices
WHERE = "orogen_fold_where"  # properties of objects: layer and phase, from 1
ORIGIN = "orogen_fold_origin"  # m, of the mesh in the recipe's coordinates
START = "orogen_fold_start"  # three numbers a vertex: x, y, height (m)
EDGES = "orogen_fold_edges"  # two numbers an edge
KEPT = "orogen_fold_kept"  # JSON of edits
STILL = 1.0  # m: a vertex that moved less did not
HIGHEST = 20e3  # m


def add_to(document, terrain):
    """The recipe with the edits of the terrain's folds."""
    edits = of(terrain) if any(s["stage"] == STAGE for s in document["stages"]) else []
    if not edits:
        return document
    return {**document, "fold_edits": [*document.get("fold_edits", ()), *edits]}


def of(terrain):
    return [edit for ob in objects_of(terrain) for edit in of_object(ob)]


def objects_of(terrain):
    folds = terrain.orogen.folds
    return [ob for ob in folds.objects if WHERE in ob and ob.type == "MESH"] if folds else []


def of_object(ob):
    """The edits that its mesh stands for: those that it was made with, and what changed since."""
    layer, phase = ob[WHERE]
    start, edges = (np.array(ob[name]).reshape(-1, n) for name, n in ((START, 3), (EDGES, 2)))
    changes = _changes(start, edges, *_read(ob), ob[ORIGIN])
    where = {"layer": layer, "phase": phase}
    return json.loads(ob[KEPT]) + [{**change, **where} for change in changes]


def _read(ob):
    """Numbers of the vertices, -1 for new ones; their places; and the edges."""
    numbers, points, joined = _edited(ob.data) if ob.mode == "EDIT" else _at_rest(ob.data)
    first = np.unique(numbers, return_index=True)[1]  # one that was drawn out of it has its number
    others = np.ones(len(numbers), bool)
    others[first] = False
    numbers[others] = -1
    return numbers, points, joined


def _edited(mesh):
    made = bmesh.from_edit_mesh(mesh)
    made.verts.index_update()
    layer = made.verts.layers.int.get(NUMBER)
    numbers = np.array([v[layer] - 1 if layer else -1 for v in made.verts], np.int32)
    points = np.array([v.co[:] for v in made.verts]).reshape(-1, 3)
    return numbers, points, [[v.index for v in edge.verts] for edge in made.edges]


def _at_rest(mesh):
    numbers = np.zeros(len(mesh.vertices), np.int32)
    if attribute := mesh.attributes.get(NUMBER):
        attribute.data.foreach_get("value", numbers)
    points = np.empty((len(mesh.vertices), 3), np.float32)
    mesh.vertices.foreach_get("co", points.ravel())
    joined = np.empty((len(mesh.edges), 2), np.int32)
    mesh.edges.foreach_get("vertices", joined.ravel())
    return numbers - 1, points.astype(float), joined.tolist()


def _changes(start, edges, numbers, points, joined, origin):
    still, raised = _unmoved(start, numbers, points)
    before = set(map(tuple, np.sort(edges).astype(int).tolist()))
    now = {_key(still, a, b): (a, b) for a, b in joined}
    for key in sorted(before - set(now)):
        yield _edit("remove", *_inner(*start[list(key)]), origin)
    new = [ends for key, ends in now.items() if key not in before]
    for ends in new:
        yield _edit("add", *points[list(ends)], origin)
    for ends in new:
        yield _edit("set", *points[list(ends)], origin, points[list(ends)][:, 2].mean())
    for key, ends in now.items():
        lifted = [i for i in ends if i in raised]
        if key in before and lifted:
            height = points[lifted][:, 2].mean()
            yield _edit("set", *_inner(*points[list(ends)]), origin, height)


def _unmoved(start, numbers, points):
    """Numbers of the vertices that lie where they lay, and those of them that were raised."""
    known = np.flatnonzero((numbers >= 0) & (numbers < len(start)))
    moved = np.abs(points[known] - start[numbers[known]])
    still = moved[:, :2].max(axis=1, initial=0.0) < STILL
    raised = known[still & (moved[:, 2] >= STILL)]
    there = known[still].tolist()
    return dict(zip(there, numbers[there].tolist(), strict=True)), set(raised.tolist())


def _key(still, a, b):
    """The numbers of the edge's ends as it was made; of a new one, something else."""
    if a in still and b in still:
        return tuple(sorted((still[a], still[b])))
    return ("new", a, b)


def _inner(a, b):
    """The middle half of an edge: so near to its middle no other crest has its own."""
    return 0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b


def _edit(kind, a, b, origin, value=None):
    ends = {"from": _place(a, origin), "to": _place(b, origin)}
    edit = {"edit": kind, **ends}
    if value is not None:
        edit["value"] = round(float(np.clip(value, 0.0, HIGHEST)), 1)
    return edit


def _place(point, origin):
    return [round(float(x + o), 1) for x, o in zip(point[:2], origin, strict=True)]
