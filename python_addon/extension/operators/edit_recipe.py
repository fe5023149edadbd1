"""The map, plates, curves and springs of an example or a file, put into the scene to be changed
there."""

import bpy

from .. import drawn_recipe, recipe, terrains
from ..properties.session import tell
from ..scene import from_recipe
from ..settings_recipe import source_recipe
from ..worker.launch import NoCore

HELD = {"orogen", "name", "seed", "resolution", "map", "extent", "phases", "column", "stages"}
PLACED = {"features", "river_sources"}  # whose coordinates are metres
HELD |= PLACED


class OROGEN_OT_edit_recipe(bpy.types.Operator):
    """Put the map or the plates of what is picked into the scene, as strokes, peaks and arrows that
    can be changed. What the terrain was drawn from before stays in its collection"""

    bl_idname = "orogen.edit_recipe"
    bl_label = "Make Editable"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        terrain = terrains.own(context)
        return context.mode == "OBJECT" and terrain is not None and not terrain.orogen.is_drawn()

    def execute(self, context):
        terrain, scene = terrains.active(context), context.scene
        settings = terrain.orogen
        try:
            document = source_recipe(settings)
            source = start_of(document)
        except (recipe.NotARecipe, NoCore) as error:
            tell(context, str(error), is_error=True)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        settings.drawing = None
        from_recipe.add(terrain, document, min(scene.frame_current, scene.frame_start))
        settings.source = source
        return {"FINISHED"}


def start_of(document):
    """The start that can hold all that a recipe says. Raises NotARecipe."""
    phases = len(document.get("phases", ()))
    if "map" in document:
        source = "JOIN" if "column" in document else "DRAWING"
    else:
        source = "PLATES" if phases else "ISLAND"
    lost = PLACED & set(document) and from_recipe.middle_of(document) is None
    reasons = {
        "has " + ", ".join(sorted(set(document) - HELD)): set(document) - HELD,
        "has several phases": phases != int(source == "PLATES"),
        "has stages of its own": stages_of(document, source) != drawn_recipe.stages_of(source),
        "has feature curves or springs on a map in degrees": lost,
    }
    if found := next((text for text, holds in reasons.items() if holds), None):
        raise recipe.NotARecipe(f"This cannot be drawn in the scene: it {found}")
    return source


def stages_of(document, source):
    """The recipe's, without the one that feature curves bring along."""
    names = recipe.stage_names(document)
    brought = "features" in document and recipe.FEATURE_STAGE not in drawn_recipe.stages_of(source)
    return tuple(name for name in names if not (brought and name == recipe.FEATURE_STAGE))
