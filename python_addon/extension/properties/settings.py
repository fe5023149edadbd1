"""The settings of a terrain. They live on its object; a recipe is made from them."""

import bpy

from .. import examples
from ..declarations import MAP_STAGES
from ..recipe import NotARecipe
from ..worker.launch import NoCore
from . import column, ground, input, live, paint, problem, stages, view
from .migration import FIRST_VERSION
from .session import tell

SOURCES = (  # the numbers are what a .blend keeps
    ("DRAWING", "Vector Map", "Coasts, rivers, lakes and peaks that are drawn in the scene", 2),
    ("PLATES", "Moving Plates", "Plates of the scene that collide or part, as their arrows say", 3),
    (
        "JOIN",
        "Map with Plates",
        "A map that is drawn in the scene; its own plates fold the layers of rock",
        4,
    ),
    ("HEIGHTS", "Heights", "A mesh or an image of the scene, which rivers wear down", 5),
    ("ISLAND", "Island", "An island that fills the frame, with lakes, rivers and biomes", 6),
    ("EXAMPLE", "Example", "A recipe that comes with Orogen", 0),
    ("FILE", "File", "A GeoJSON map or an Orogen recipe", 1),
)
DRAWN = ("DRAWING", "PLATES", "JOIN", "HEIGHTS", "ISLAND")


def rescale(self, _context):
    from ..mesh import terrain_mesh, variations

    terrain_mesh.rescale(self.id_data)
    variations.place_all(self.id_data)


def look(self, _context):
    from ..mesh import terrain_mesh

    terrain_mesh.set_look(self.id_data)


def take_over(self, context):
    from .. import settings_recipe

    if self.is_drawn():
        return
    try:
        settings_recipe.take_over(self)
        tell(context, "")
    except (NotARecipe, NoCore) as error:
        tell(context, str(error), is_error=True)


def notice_stages(self, _context):
    from .. import settings_recipe

    settings_recipe.notice_stages(self)


class OROGEN_PG_terrain(bpy.types.PropertyGroup):
    version: bpy.props.IntProperty(default=FIRST_VERSION, options={"HIDDEN"})
    is_terrain: bpy.props.BoolProperty(options={"HIDDEN"})

    source: bpy.props.EnumProperty(
        name="Start",
        items=SOURCES,
        default="EXAMPLE",
        description="Where coasts, rivers and peaks, or colliding plates, come from",
        update=notice_stages,
    )
    example: bpy.props.EnumProperty(
        name="Example",
        items=examples.items(),
        description="A recipe that comes with Orogen",
        update=take_over,
    )
    path: bpy.props.StringProperty(
        name="File",
        subtype="FILE_PATH",
        description="A GeoJSON map or an Orogen recipe",
        update=take_over,
    )
    drawing: bpy.props.PointerProperty(
        name="Collection",
        type=bpy.types.Collection,
        description="Where the drawing lies: grease pencil, curves, empties and plates."
        " Without one: the scene",
    )
    input: bpy.props.PointerProperty(type=input.OROGEN_PG_input)
    column: bpy.props.PointerProperty(type=column.OROGEN_PG_column)
    folds: bpy.props.PointerProperty(
        name="Folds",
        type=bpy.types.Collection,
        description="Where the folds lie that were edited, a mesh each layer",
    )
    resolution: bpy.props.IntProperty(
        name="Resolution",
        description="Cells along the longer side",
        default=512,
        min=2,
        max=65536,
        soft_min=64,
        soft_max=4096,
    )
    seed: bpy.props.IntProperty(
        name="Seed",
        description="Another number gives another terrain on the same map",
        default=1,
        min=0,
    )
    units_per_km: bpy.props.FloatProperty(
        name="Units per km",
        description="Blender units that stand for one kilometre",
        default=1.0,
        min=0.001,
        max=1000.0,
        update=rescale,
    )
    vertical_exaggeration: bpy.props.FloatProperty(
        name="Vertical Exaggeration",
        description="How many times heights are drawn taller than they are",
        default=1.0,
        min=0.01,
        max=100.0,
        soft_min=0.5,
        soft_max=5.0,
        update=rescale,
    )
    strata: bpy.props.FloatProperty(
        name="Strata",
        description="How much rock on slopes shows the colours of its layers, where it has some",
        default=1.0,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
        update=look,
    )
    bare_rock: bpy.props.FloatProperty(
        name="Bare Rock",
        description="How much of the cover (grass, soil, snow) is off, as on a geological map",
        default=0.0,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
        update=look,
    )
    growth_frames: bpy.props.IntProperty(
        name="Steps", description="Of the animation of growth", default=60, min=2, max=10000
    )
    growth_step: bpy.props.IntProperty(
        name="Frames a Step",
        description="Frames of the scene from one step to the next; heights between are blended",
        default=2,
        min=1,
        max=1000,
    )
    live: bpy.props.PointerProperty(type=live.OROGEN_PG_live)
    picked_stages: bpy.props.StringProperty(options={"HIDDEN"})  # of what is picked; for the panels
    living: bpy.props.BoolProperty(
        name="Climate and Plants",
        description="Give the terrain a climate, lakes, biomes and the plants that grow there",
        update=notice_stages,
    )
    stages: bpy.props.PointerProperty(type=stages.OROGEN_PG_stages)
    ground: bpy.props.PointerProperty(type=ground.OROGEN_PG_ground)
    paints: bpy.props.PointerProperty(type=paint.OROGEN_PG_paints)
    view: bpy.props.PointerProperty(type=view.OROGEN_PG_view)
    problems: bpy.props.CollectionProperty(type=problem.OROGEN_PG_problem)

    def is_drawn(self):
        """Whether the terrain comes from the scene, and lies where it was drawn."""
        return self.source in DRAWN

    def stage_names(self):
        """The stages of what is picked. Files from before there were others: those of maps."""
        return tuple(self.picked_stages.split()) or MAP_STAGES

    def local_scale(self):
        """Local units a metre, across and up."""
        across = self.units_per_km / 1000.0
        return across, across * self.vertical_exaggeration
