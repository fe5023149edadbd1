"""Springs of the scene: empties where water that wears the ground comes out of it."""

from test_feature_curves import activate, heights, island, recipe
from test_live import settle


def add_spring(terrain, x_km, y_km, **numbers):
    import bpy

    activate(terrain)
    bpy.context.scene.cursor.location = (x_km, y_km, 0)
    assert bpy.ops.orogen.add_spring() == {"FINISHED"}
    ob = bpy.context.object
    for name, value in numbers.items():
        setattr(ob.orogen_spring, name, value)
    return ob


def sources(terrain):
    import bpy

    bpy.context.view_layer.update()
    return recipe(terrain).get("river_sources", [])


def test_a_spring_is_an_empty_and_a_river_source():
    import orogen

    (declared,) = orogen.schema()["river_source"]
    terrain = island()
    ob = add_spring(terrain, 10, -4)
    assert (ob.type, ob.name, ob.parent) == ("EMPTY", "Spring", terrain)
    plain = {"name": "Spring", "position": [10e3, -4e3], "discharge": declared["default"]}
    assert sources(terrain) == [plain]
    shown = ob.orogen_spring.bl_rna.properties["discharge"]
    assert shown.hard_min == declared["min"] and shown.hard_max == declared["max"]
    assert declared["unit"] in shown.name
    assert shown.description.startswith(declared["description"].rstrip("."))
    ob.orogen_spring.discharge = 123.4
    ob.location.x = -2.5
    assert sources(terrain) == [{**plain, "position": [-2500.0, -4e3], "discharge": 123.4}]
    lost = add_spring(terrain, 0, 31)  # off the frame: amid it
    assert tuple(lost.location) == (0, 0, 0)


def test_springs_are_doubled_hidden_and_deleted():
    import bpy

    terrain = island()
    add_spring(terrain, 3, 4, discharge=70)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    copy.location.y = 9
    first, second = sources(terrain)
    assert first != second and second == {**first, "name": copy.name, "position": [3e3, 9e3]}
    copy.hide_viewport = True
    assert sources(terrain) == [first]
    copy.hide_viewport = False
    bpy.data.objects.remove(bpy.data.objects["Spring"])
    assert sources(terrain) == [second]
    bpy.data.objects.remove(copy)
    assert "river_sources" not in recipe(terrain)


def test_a_spring_lies_on_the_ground_wherever_the_terrain_stands():
    import bpy
    import numpy as np
    import steps

    terrain = island(64)
    terrain.orogen.units_per_km, terrain.orogen.vertical_exaggeration = 0.5, 2.0
    terrain.location, terrain.rotation_euler.z = (7, 8, 9), 0.3
    steps.grow()
    place = steps.addon("scene.plane").Plane(terrain).world([(4e3, 3e3)])[0]
    bpy.context.scene.cursor.location = place
    assert bpy.ops.orogen.add_spring() == {"FINISHED"}
    (source,) = sources(terrain)
    assert np.allclose(source["position"], (4e3, 3e3), atol=0.02)
    ground = steps.addon("mesh.relief").Relief(terrain).at([(4e3, 3e3)])[0]
    assert abs(bpy.context.object.location.z - 1e-3 * ground) < 1e-4 and ground != 0


def test_springs_belong_where_water_flows():
    import bpy
    import steps
    from test_panels import drawn

    panel = steps.addon("panels.springs").OROGEN_PT_springs
    for start in ("DRAWING", "JOIN", "ISLAND", "EXAMPLE", "PLATES", "HEIGHTS"):
        bpy.ops.orogen.add_terrain(start=start)
        flows = start not in ("PLATES", "HEIGHTS")
        assert bpy.ops.orogen.add_spring.poll() == panel.poll(bpy.context) == flows, start
    terrain = island()
    for x in (1, 2):
        add_spring(terrain, x, 0)
    assert drawn(panel)[0] == ["orogen.add_spring"]
    names = [ob.name for ob in steps.addon("scene.springs").objects(terrain, bpy.context.scene)]
    assert names == ["Spring", "Spring.001"]


def test_a_spring_is_no_peak():
    import bpy
    import steps
    from test_starts import draw_island, started

    terrain = started("DRAWING")
    draw_island(terrain)
    before = recipe(terrain)
    add_spring(terrain, -5, 5)
    after = recipe(terrain)
    (source,) = after.pop("river_sources")
    assert after == before and source["position"] == [-5e3, 5e3]
    terrain.orogen.drawing = None  # what is drawn anywhere in the scene counts
    peaks = steps.addon("scene.drawn_map").read_drawing(terrain, bpy.context.scene).peaks
    assert len(peaks) == 3 and len(sources(terrain)) == 1


def test_other_terrains_springs_are_their_own():
    first = island()
    add_spring(first, 1, 1)
    second = island()
    assert len(sources(first)) == 1 and not sources(second)


def dry_island():
    """Without rain: springs alone bring water."""
    terrain = island(128)
    terrain.orogen.stages.hydraulic_erosion.rain_rate_mm_per_h = 0
    return terrain


def grown_wear(terrain):
    import steps

    activate(terrain)
    steps.grow()
    return steps.attribute(terrain, "wear").reshape(heights(terrain).shape)


def joined(mask, start):
    """The part of a mask that hangs together with a cell."""
    import numpy as np

    part = np.zeros_like(mask)
    part[start] = mask[start]
    while True:
        wide = np.pad(part, 1)
        ny, nx = mask.shape
        near = [wide[r : r + ny, c : c + nx] for r in range(3) for c in range(3)]
        grown = np.logical_or.reduce(near) & mask
        if (grown == part).all():
            return part
        part = grown


def test_water_of_a_spring_wears_a_bed_down_from_it():
    import numpy as np

    terrain = dry_island()
    assert grown_wear(terrain).max() == 0
    before = heights(terrain).copy()
    row, column = np.unravel_index(before.argmax(), before.shape)
    cell, offset = terrain.data["orogen_cell_size"], np.array(terrain.data["orogen_offset"])
    x, y = 1e-3 * (offset + (np.array([column, row]) + 0.5) * cell)
    add_spring(terrain, x, y, discharge=2000)
    wear = grown_wear(terrain)
    bed = joined(wear > 0.1, (row, column))
    assert bed.sum() > 10 and bed.mean() < 0.2  # a bed, and the rest of the island is left alone
    assert before[bed].min() < 0.5 * before[row, column]
    assert wear[~bed].max() < wear[bed].max()
    assert (heights(terrain)[bed] < before[bed]).mean() > 0.5


def test_previews_follow_a_moved_spring():
    import bpy
    import numpy as np
    import steps

    terrain = dry_island()
    spring = add_spring(terrain, 0, 0, discharge=2000)
    activate(terrain)
    terrain.orogen.live.enabled = True
    assert settle() == 1
    seen = [steps.attribute(terrain, "elevation")]
    spring.location.x = -5.0
    assert settle() == 1
    seen.append(steps.attribute(terrain, "elevation"))
    spring.orogen_spring.discharge = 500
    spring.update_tag()
    assert settle() == 1
    seen.append(steps.attribute(terrain, "elevation"))
    bpy.data.objects.remove(spring)
    assert settle() == 1
    seen.append(steps.attribute(terrain, "elevation"))
    assert all(not np.array_equal(a, b) for a, b in zip(seen, seen[1:], strict=False))


def test_a_spring_off_the_terrain_is_marked():
    import bpy
    import numpy as np
    import steps

    terrain = island(64)
    add_spring(terrain, 1, 1)
    ob = add_spring(terrain, 2, 2)
    ob.name, ob.location = "Lost", (50, 7, 0)
    activate(terrain)
    assert "outside the terrain" in steps.refused(bpy.ops.orogen.grow)
    (problem,) = terrain.orogen.problems
    assert problem.is_error and problem.text == "Lost: lies outside the terrain's extent"
    assert np.allclose(problem.place, (50e3, 7e3), atol=1.0)
    assert bpy.ops.orogen.show_problem(index=0) == {"FINISHED"}
    ob.location = (44, 29, 0)  # a corner: the sea
    steps.grow()
    (problem,) = terrain.orogen.problems
    assert not problem.is_error and problem.text == "Lost: changes nothing; it lies in the sea"
    assert np.allclose(problem.place, (44e3, 29e3), atol=1.0)
    bpy.data.objects.remove(ob)
    steps.grow()
    assert len(terrain.orogen.problems) == 0


ORIGIN = (650_000.0, 5_180_000.0)  # m
SPRINGS = [
    {"name": "Rhine", "position": [660_000.0, 5_190_000.0], "discharge": 2300.0},
    {"position": [672_345.6, 5_187_654.3], "discharge": 12.34},
]


def picked(folder, springs, **more):
    """A terrain whose recipe is a file of an island with these springs."""
    import json

    import bpy

    document = {
        "orogen": 1,
        "extent": {"origin": ORIGIN, "size": [40e3, 30e3]},
        "river_sources": springs,
        **more,
    }
    file = folder / "springs.orogen.json"
    file.write_text(json.dumps(document))
    bpy.ops.orogen.add_terrain()
    assert bpy.ops.orogen.load_map(filepath=str(file)) == {"FINISHED"}
    terrain = bpy.context.object
    terrain.orogen.resolution = 64
    return terrain


def test_springs_come_from_a_recipe_and_go_into_one(tmp_path):
    import json

    import bpy
    import numpy as np

    terrain = picked(tmp_path, SPRINGS)
    assert sources(terrain) == SPRINGS
    assert bpy.ops.orogen.edit_recipe() == {"FINISHED"}
    assert terrain.orogen.source == "ISLAND"
    named = {ob.name: ob for ob in bpy.data.objects if ob.orogen_spring.is_spring}
    assert set(named) == {"Rhine", "Spring"}
    middle = np.array(ORIGIN) + (20e3, 15e3)
    for found, wanted in zip(sources(terrain), SPRINGS, strict=True):
        assert found["name"] == wanted.get("name", "Spring")
        assert found["discharge"] == wanted["discharge"]
        assert np.allclose(found["position"] + middle, wanted["position"], atol=0.02)
    file = tmp_path / "saved.orogen.json"
    assert bpy.ops.orogen.save_recipe(filepath=str(file)) == {"FINISHED"}
    assert json.loads(file.read_text())["river_sources"] == sources(terrain)
    again = picked(tmp_path, json.loads(file.read_text())["river_sources"][:0])
    again.orogen.path = str(file)
    assert sources(again) == sources(terrain)


def test_a_picked_terrain_takes_springs_where_it_lies(tmp_path):
    """Beside those of its own recipe, once it has grown."""
    import steps

    terrain = picked(tmp_path, SPRINGS[:1])
    add_spring(terrain, 3, -2)
    assert sources(terrain) == SPRINGS[:1]  # where the map lies is not known yet
    activate(terrain)
    steps.grow()
    own, added = sources(terrain)
    assert own == SPRINGS[0] and added["name"] == "Spring"
    assert added["position"] == [ORIGIN[0] + 23e3, ORIGIN[1] + 13e3]
    steps.grow()
    assert sources(terrain) == [own, added]


def test_springs_that_cannot_be_are_refused(tmp_path):
    import bpy
    import pytest
    import steps

    rhine = SPRINGS[0]
    for wrong, says in (
        ({**rhine, "discharge": -5}, "river_sources[0].discharge: -5, but 0 to 1e+09 m3/s"),
        ({**rhine, "discharge": None}, "river_sources[0].discharge"),
        ({**rhine, "position": [1.0]}, "river_sources[0].position"),
        ({**rhine, "name": 7}, "river_sources[0].name"),
        (7, "river_sources[0].position"),
    ):
        terrain = picked(tmp_path, [wrong])
        assert says in steps.refused(bpy.ops.orogen.grow)
        assert says in steps.refused(bpy.ops.orogen.edit_recipe)
    terrain = picked(tmp_path, [SPRINGS[1], {**rhine, "position": [0, 0]}])
    assert "river_sources[1]" in steps.refused(bpy.ops.orogen.grow)
    assert terrain.orogen.problems[0].text.startswith("Rhine: lies outside")
    degrees = {"type": "FeatureCollection", "features": []}
    document = {"orogen": 1, "map": degrees, "river_sources": [rhine]}
    with pytest.raises(ValueError, match="springs on a map in degrees"):
        steps.addon("operators.edit_recipe").start_of(document)
