"""The map, the plates, the feature curves and the springs of a recipe as things in the scene, to be
edited there."""

import numpy as np

from .. import column_recipe
from .. import feature_curves as curves
from ..map_features import MARGIN
from . import new_inputs, pencil
from .feature_curves import HEIGHT

LAYERS = {"coast": "Coast", "river": "Rivers", "lake": "Lakes"}
METRES = {"m": 1.0, "km": 1000.0}
REACH = np.array([0.6, 0.8])  # of the frame, from its middle: plates end there, to be at hand


def add(terrain, document, frame, size=None):
    """Makes them, and lays the frame around them. `size` (km) stretches plates to another one."""
    settings = terrain.orogen
    if "phases" in document:
        lower, its = (np.array(document["extent"][key], float) for key in ("origin", "size"))
        wanted = its if size is None else 1000.0 * np.array(size)
        set_frame(settings, wanted)
        for plate in document["phases"][0]["plates"]:
            points = (np.array(plate["points"]) - lower - 0.5 * its) / its * wanted
            arrows = np.array(plate["arrows"]) / its * wanted
            _add_plate(terrain, plate, np.clip(points, -REACH * wanted, REACH * wanted), arrows)
    elif "map" in document:
        _draw(terrain, document["map"], frame)
    else:
        set_frame(settings, document["extent"]["size"])
    middle = middle_of(document)
    for curve in document.get("features", ()):
        _add_curve(terrain, curves.from_recipe(curve), middle)
    for source in document.get("river_sources", ()):
        place = source["position"] - middle
        ob = new_inputs.add_spring(terrain, source.get("name", "Spring"), place)
        ob.orogen_spring.take(source)
    if "column" in document:
        column_recipe.take_over(settings, document["column"])


def set_frame(settings, size):
    settings.input.frame_km = (np.asarray(size) / 1000.0).tolist()
    settings.input.use_frame = True


def middle_of(document):
    """Of the terrain, in the coordinates of curves and springs (m); None where they are not known
    before it has grown."""
    if "extent" in document:
        extent = document["extent"]
        return np.array(extent["origin"], float) + 0.5 * np.array(extent["size"])
    frame = document["map"].get("frame", {})
    if document["map"].get("units") not in METRES or "size_km" not in frame:
        return None
    return np.array(frame.get("origin_m", (0.0, 0.0))) + 500.0 * np.array(frame["size_km"])


def _add_curve(terrain, curve, middle):
    """A curve object; numbers that are not alike in all points become lists."""
    ob = new_inputs.add_curve(terrain, curve.name, curve.points - (*middle, 0.0))
    settings = ob.orogen_feature
    settings.is_feature, settings.alike = True, False
    for name, values in {**curve.numbers, HEIGHT: curve.elevation}.items():
        if (values == values[0]).all():
            setattr(settings, name, values[0].item())
        else:
            ob[name] = values.astype(float).tolist()


def _add_plate(terrain, plate, points, arrows):
    stable, crust = plate.get("stable", False), plate.get("crust", "continental")
    collection = new_inputs.add_plate(terrain, plate["name"].capitalize(), stable, crust)
    for point, arrow in zip(points.tolist(), arrows.tolist(), strict=True):
        new_inputs.add_arrow(terrain, collection, point, arrow)


def _draw(terrain, map_, frame):
    features = [(item["properties"], _parts(item["geometry"])) for item in map_["features"]]
    middle, scale, size = _layout(map_, [part for _, parts in features for part in parts])
    set_frame(terrain.orogen, size)
    lines = {kind: [] for kind in LAYERS}
    for said, parts in features:
        flat = [(part - middle) * scale for part in parts]
        if said["kind"] in lines:
            lines[said["kind"]] += flat
        else:
            new_inputs.add_peak(terrain, _peak_name(said), flat[0][0], said.get("height_m", 0.0))
    ob = new_inputs.add_map(terrain, frame)
    across = terrain.orogen.local_scale()[0]
    for kind, layer in LAYERS.items():
        drawn = [across * (line if kind == "river" else line[:-1]) for line in lines[kind]]
        pencil.add_strokes(ob, layer, drawn, frame, cyclic=kind != "river")


def _parts(geometry):
    """Its lines, rings or point, as a list of arrays (n, 2)."""
    places = geometry["coordinates"]
    if geometry["type"] != "Polygon":
        places = [places]
    return [np.array(part, float).reshape(-1, np.shape(part)[-1])[:, :2] for part in places]


def _peak_name(said):
    name = said.get("name") or "Peak"
    volcano = said.get("volcano") and not name.lower().startswith("volcano")
    return f"Volcano {name}" if volcano else name


def _layout(map_, parts):
    """The map's middle, metres a unit each way, and the map's size in metres. Degrees are laid flat
    about the middle, which is exact enough to draw on."""
    frame, unit = map_.get("frame", {}), METRES.get(map_.get("units"))
    if unit and "size_km" in frame:
        size = 1000.0 * np.array(frame["size_km"])
        return 0.5 * size / unit, unit, size
    points = np.vstack(parts)
    lower, upper = points.min(axis=0), points.max(axis=0)
    scale = unit or _metres_a_degree(0.5 * (lower[1] + upper[1]))
    size = (upper - lower) * scale
    return 0.5 * (lower + upper), scale, size + 2 * MARGIN * size.max()


def _metres_a_degree(latitude):
    """Of longitude and latitude, on WGS84."""
    axis, flatness = 6378137.0, 0.00669438
    bend = 1.0 - flatness * np.sin(np.radians(latitude)) ** 2
    east = axis * np.cos(np.radians(latitude)) / np.sqrt(bend)
    return np.radians([east, axis * (1.0 - flatness) / bend**1.5])
