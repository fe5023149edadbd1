"""Panels: every stage has its place, what differs from its default is seen and can be reset."""


def test_every_stage_is_in_one_group():
    import steps

    groups = steps.addon("panels.groups").GROUPS
    listed = [name for names in groups.values() for name in names]
    declared = [stage.name for stage in steps.addon("declarations").STAGES]
    assert sorted(listed) == sorted(declared)
    stages = steps.addon("panels.stages")
    assert set(stages.PARENTS) == set(groups)
    titles = {cls.group: cls.__name__ for cls in group_panels()}
    assert titles == stages.PARENTS


def group_panels():
    import bpy
    import steps

    base = steps.addon("panels.stages").GroupPanel
    return [cls for cls in base.__subclasses__() if issubclass(cls, bpy.types.Panel)]


def test_stages_stand_in_the_order_of_all_recipes():
    import steps

    groups = steps.addon("panels.groups").GROUPS
    examples, recipe = steps.addon("examples"), steps.addon("recipe")
    names = [identifier for identifier, *_ in examples.items()]
    assert len(names) > 10
    for name in names:
        order = recipe.stage_names(recipe.read(examples.path_of(name)))
        for group in groups.values():
            used = [stage for stage in order if stage in group]
            assert used == [stage for stage in group if stage in used], (name, used)


def shown(context):
    """The panels of groups and stages that are drawn."""
    import steps

    stages = steps.addon("panels.stages")
    groups = {cls.group for cls in group_panels() if cls.poll(context)}
    return groups, [cls.stage.name for cls in stages.PANELS if cls.poll(context)]


def test_only_what_the_start_uses_is_shown():
    import bpy
    import steps

    groups = {}
    for start in ("DRAWING", "PLATES", "JOIN", "HEIGHTS"):
        bpy.ops.orogen.add_terrain(start=start)
        groups[start], stages = shown(bpy.context)
        known = steps.addon("panels.stages").KNOWN
        used = bpy.context.object.orogen.stage_names()
        assert set(stages) == {name for name in used if name in known}
    assert groups["PLATES"] == {"Plates", "Folds", "Strata", "Erosion", "Detail"}
    assert groups["DRAWING"] == {"Input", "Plates", "Folds", "Erosion", "Detail"}
    assert groups["JOIN"] == groups["DRAWING"] | {"Strata"}
    assert groups["HEIGHTS"] == {"Input", "Erosion"}


class Pen:
    """A layout that notes what is drawn on it, and refuses what there is not."""

    def __init__(self, notes):
        self.notes = notes

    def __getattr__(self, name):
        import bpy

        known = bpy.types.UILayout.bl_rna.functions

        def draw(*arguments, **texts):
            if name in ("prop", "template_ID"):
                assert arguments[1] in arguments[0].bl_rna.properties, arguments
            if name.startswith("operator"):
                assert arguments[0].partition(".")[2] in dir(bpy.ops.orogen), arguments
            if "icon" in texts:
                assert texts["icon"] in known["label"].parameters["icon"].enum_items, texts
            self.notes.append((name, arguments, texts))
            return Pen(self.notes)

        assert name in known, name
        return draw


def drawn(panel):
    """Names of the operators, and the texts of labels, that a panel draws."""
    from types import SimpleNamespace

    import bpy

    notes = []
    itself = SimpleNamespace(layout=Pen(notes), stage=getattr(panel, "stage", None))
    panel.draw(itself, bpy.context)
    operators = [args[0] for name, args, _ in notes if name.startswith("operator")]
    return operators, [texts["text"] for name, _, texts in notes if name == "label"]


def test_what_differs_can_be_reset():
    import bpy
    import steps

    terrain = steps.corsica()
    (panel,) = [
        cls for cls in steps.addon("panels.stages").PANELS if cls.stage.name == "relief_growth"
    ]
    assert drawn(panel)[0] == ["orogen.reset_parameters"]
    group = terrain.orogen.stages.relief_growth
    first, second = panel.stage.parameters[:2]
    for parameter in (first, second):
        steps.addon("properties.stages").set_value(group, parameter, parameter.max)
    assert drawn(panel)[0].count("orogen.reset_parameter") == 2
    reset = bpy.ops.orogen.reset_parameter
    assert reset(stage="relief_growth", parameter=first.name) == {"FINISHED"}
    value_of = steps.addon("properties.stages").value_of
    assert value_of(group, first) == first.default
    assert value_of(group, second) == second.max
    assert drawn(panel)[0].count("orogen.reset_parameter") == 1
    for wrong in ({"stage": "relief_growth", "parameter": "x"}, {"stage": "x", "parameter": "x"}):
        assert "There is no parameter" in steps.refused(reset, **wrong)


def test_what_is_missing_is_told_beside_the_button_that_mends_it():
    import bpy
    import steps

    panels = {cls.group: cls for cls in group_panels()}
    bpy.ops.orogen.add_terrain(start="PLATES")
    terrain = bpy.context.object
    operators, texts = drawn(panels["Folds"])
    assert "orogen.grow" in operators and "Grow the terrain first" in texts
    terrain.orogen.column.use_layers = True
    terrain.orogen.column.layers.clear()
    operators, texts = drawn(panels["Strata"])
    assert "No layers of rock yet" in texts and "orogen.copy_column" in operators
    assert "There are no layers of rock" in steps.refused(bpy.ops.orogen.grow)
    assert bpy.ops.orogen.copy_column(preset="jura") == {"FINISHED"}
    steps.grow()
    operators, texts = drawn(panels["Folds"])
    assert "orogen.edit_folds" in operators and "orogen.grow" not in operators
    steps.new_terrain(source="EXAMPLE", example="zagros")
    assert "orogen.edit_recipe" in drawn(panels["Strata"])[0]


def test_every_panel_draws():
    """Those of groups and of stages, in every start."""
    import bpy
    import steps

    stages, count = steps.addon("panels.stages"), 0
    panels = [*group_panels(), *stages.PANELS, steps.addon("panels.strata").OROGEN_PT_basement]
    for start in ("DRAWING", "PLATES", "JOIN", "HEIGHTS", "EXAMPLE", "FILE"):
        bpy.ops.orogen.add_terrain(start=start)
        bpy.context.object.orogen.column.use_layers = start == "JOIN"
        for panel in panels:
            if panel.poll(bpy.context):
                drawn(panel)
                count += 1
    assert count > 50
