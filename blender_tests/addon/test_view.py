"""What the ground's colours tell: attribute, material, range, legend."""


def shown(**view):
    import steps

    terrain = steps.corsica(resolution=96)
    steps.grow()
    for name, value in view.items():
        setattr(terrain.orogen.view, name, value)
    return terrain


def legend_of(terrain):
    import json

    return json.loads(terrain.data["orogen_legend"])


def test_a_field_becomes_the_active_colour():
    import numpy as np
    import steps

    terrain = shown(field="elevation", scale="CIVIDIS")
    mesh, view = terrain.data, terrain.orogen.view
    attribute = mesh.attributes["orogen_view"]
    assert (attribute.data_type, attribute.domain) == ("FLOAT_COLOR", "POINT")
    assert mesh.color_attributes.active_color_name == "orogen_view"
    elevation = steps.attribute(terrain, "elevation")
    low, high = np.percentile(elevation, (2, 98))
    assert abs(view.low - low) < 1 and abs(view.high - high) < 1
    colors = steps.colors(mesh, "orogen_view")
    scales, linear = steps.addon("view.scales"), steps.addon("mesh.colors").to_linear
    share = (elevation - view.low) / (view.high - view.low)
    assert np.array_equal(colors, linear(scales.table("CIVIDIS"))[scales.step_of(share)])
    order = np.argsort(elevation)
    brightness = colors[order, :3] @ [0.2126, 0.7152, 0.0722]
    assert np.all(np.diff(brightness) > -1e-3), "cividis gets brighter all the way"


def test_material_comes_and_goes():
    import bpy

    terrain = shown()
    own = terrain.data.materials[0]
    view, (sea,) = terrain.orogen.view, terrain.children
    view.field = "drainage_area"
    assert sea.hide_viewport and not sea.hide_render
    slot = terrain.material_slots[0]
    assert slot.link == "OBJECT" and slot.material.name == "Orogen View"
    assert terrain.data.materials[0] == own
    view.field = "MATERIAL"
    assert slot.link == "DATA" and terrain.material_slots[0].material == own
    assert not sea.hide_viewport
    assert "orogen_view" not in terrain.data.attributes and "orogen_legend" not in terrain.data
    mine = bpy.data.materials.new("Mine")
    slot.link, slot.material = "OBJECT", mine
    view.field = "elevation"
    view.field = "slope"
    view.field = "MATERIAL"
    assert slot.link == "OBJECT" and slot.material == mine


def test_range_by_hand():
    import numpy as np
    import steps

    terrain = shown(field="elevation", scale="VIRIDIS", automatic=False, low=100.0, high=200.0)
    elevation = steps.attribute(terrain, "elevation")
    colors = steps.colors(terrain.data, "orogen_view")
    assert len(np.unique(colors[elevation < 100], axis=0)) == 1
    assert len(np.unique(colors[elevation > 200], axis=0)) == 1
    assert (legend_of(terrain)["low"], legend_of(terrain)["high"]) == (100.0, 200.0)
    steps.grow()
    assert terrain.orogen.view.low == 100.0
    terrain.orogen.view.automatic = True
    assert terrain.orogen.view.high > 500


def test_slope_is_in_degrees_whatever_the_exaggeration():
    import numpy as np
    import steps

    terrain = shown(field="slope", automatic=False, low=0.0, high=45.0, scale="VIRIDIS")
    fields = steps.addon("view.fields")
    ramp = np.add.outer(np.zeros(5), np.arange(7) * 30.0).astype(np.float32)
    assert np.allclose(fields.slope(ramp, 30.0), 45.0)
    assert np.allclose(fields.slope(ramp[:1], 30.0), 45.0)
    before = steps.colors(terrain.data, "orogen_view")
    terrain.orogen.vertical_exaggeration = 4.0
    steps.grow()
    assert np.array_equal(steps.colors(terrain.data, "orogen_view"), before)
    assert legend_of(terrain)["unit"] == "°"


def test_every_field_of_a_terrain_can_be_shown():
    import numpy as np
    import steps

    terrain = shown()
    names = steps.addon("view.fields").names(terrain.data)
    assert set(terrain.data["orogen_fields"]) | {"slope"} == set(names)
    for name in names:
        terrain.orogen.view.field = name
        colors = steps.colors(terrain.data, "orogen_view")
        assert np.all((colors >= 0) & (colors <= 1)), name
        legend = legend_of(terrain)
        assert legend["label"] and ("rows" in legend or legend["low"] < legend["high"]), name
    terrain.orogen.view.field = "boundary_kind"
    rows = dict(legend_of(terrain)["rows"])
    assert set(rows) <= {"none", "convergent", "divergent", "transform"} and len(rows) > 1
    terrain.orogen.view.field = "drainage_area"
    legend = legend_of(terrain)
    assert legend["logarithmic"] and legend["unit"] == "km²"


def test_strata_and_layers_are_named(tmp_path):
    import json

    import numpy as np
    import orogen
    import steps

    terrain = steps.collision(tmp_path)
    steps.grow()
    terrain.orogen.view.field = "strata_color"
    assert np.array_equal(
        steps.colors(terrain.data, "orogen_view"), steps.colors(terrain.data, "strata_color")
    )
    grown = orogen.generate(orogen.Recipe.from_dict(steps.collision_recipe()))
    column = grown.rocks.column
    rocks = json.loads(terrain.data["orogen_rocks"])
    colors = {tuple(item["color"]) for item in rocks}
    seen = steps.addon("mesh.colors").unpack(np.unique(grown["strata_color"]))
    assert {tuple(color) for color in seen.tolist()} <= colors
    rows = legend_of(terrain)["rows"]
    assert {tuple(color) for _, color in rows} <= colors and len(rows) > 3
    assert rows[-1][0].startswith(column["basement"]["name"])
    assert rows[0][0].startswith(column["layers"][-1]["name"])
    terrain.orogen.view.field = "rock_layer"
    names = {name for name, _ in legend_of(terrain)["rows"]}
    assert names and names <= {item["name"] for item in rocks}


def test_a_field_that_is_gone_shows_the_natural_look(tmp_path):
    import steps

    terrain = steps.collision(tmp_path)
    steps.grow()
    terrain.orogen.view.field = "age"
    assert terrain.material_slots[0].link == "OBJECT"
    terrain.orogen.source, terrain.orogen.example = "EXAMPLE", steps.CORSICA
    terrain.orogen.resolution = 64
    steps.grow()
    assert "orogen_view" not in terrain.data.attributes
    assert terrain.material_slots[0].link == "DATA" and terrain.orogen.view.field == "age"


def test_solid_view_follows():
    import bpy

    terrain = shown()
    spaces = [
        area.spaces.active
        for window in bpy.context.window_manager.windows
        for area in window.screen.areas
        if area.type == "VIEW_3D"
    ]
    assert spaces
    terrain.orogen.view.field = "elevation"
    assert all(space.shading.color_type == "VERTEX" for space in spaces)
    terrain.orogen.view.field = "MATERIAL"
    assert all(space.shading.color_type == "MATERIAL" for space in spaces)


def test_it_renders_in_the_field_s_colours(tmp_path):
    import bpy
    import numpy as np

    terrain = shown(field="land")
    scene = bpy.context.scene
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(camera)
    camera.data.type, camera.data.ortho_scale = "ORTHO", max(terrain.dimensions)
    camera.location, scene.camera = (0, 0, 100), camera
    for child in terrain.children:
        child.hide_render = True
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.data.energy = 3.0
    scene.collection.objects.link(sun)
    scene.render.engine, scene.cycles.samples = "CYCLES", 4
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y = 48, 96
    scene.render.filepath = str(tmp_path / "picture.png")
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(scene.render.filepath)
    pixels = np.array(picture.pixels[:]).reshape(96, 48, 4)[..., :3]
    sea, land = pixels[2:6, 2:6].mean(axis=(0, 1)), pixels[44:52, 22:26].mean(axis=(0, 1))
    assert np.ptp(sea) < 0.05, f"the sea (class 0) is not grey: {sea}"
    assert land[0] > land[1] > land[2] + 0.1, f"the land (class 1) is not orange: {land}"


def test_legend_is_wanted_where_the_terrain_is_seen():
    import types

    import bpy
    import steps

    terrain = shown(field="elevation")
    space = types.SimpleNamespace(overlay=types.SimpleNamespace(show_overlays=True))

    def wanted():
        context = types.SimpleNamespace(
            space_data=space, object=bpy.context.object, view_layer=bpy.context.view_layer
        )
        return steps.addon("overlay.legend").wanted(context)

    assert wanted()["label"] == "Elevation"
    bpy.context.view_layer.objects.active = None
    assert wanted()["label"] == "Elevation"
    space.overlay.show_overlays = False
    assert wanted() is None
    space.overlay.show_overlays = True
    terrain.orogen.view.legend = False
    assert wanted() is None
    terrain.orogen.view.legend = True
    terrain.hide_set(True)
    assert wanted() is None


def test_ticks_are_round_and_inside():
    import numpy as np
    import steps

    ticks = steps.addon("view.ticks")
    rng = np.random.default_rng(1)
    for _ in range(300):
        low = float(rng.normal() * 10.0 ** rng.integers(-3, 5))
        high = low + float(10.0 ** rng.uniform(-3, 5))
        found = ticks.ticks(low, high)
        assert 2 <= len(found) <= 6, (low, high, found)
        slack = 1e-5 * (high - low)
        assert low - slack <= found[0] and found[-1] <= high + slack
        steps_between = np.diff(found)
        assert np.allclose(steps_between, steps_between[0], rtol=1e-6)
    assert ticks.ticks(0.02, 900.0, True) == [0.1, 1.0, 10.0, 100.0]
    assert ticks.ticks(3.0, 5.0, True) == [3.0, 5.0]
    assert ticks.share(10.0, 1.0, 100.0, True) == 0.5
    assert [ticks.text(v) for v in (-0.0, 2500, 0.25)] == ["0", "2500", "0.25"]


def test_classes_differ():
    import numpy as np
    import steps

    colours = steps.addon("view.scales").class_colours(np.arange(22))
    assert len({tuple(c) for c in colours.tolist()}) == 22
