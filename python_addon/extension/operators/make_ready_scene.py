"""Of a terrain a scene that renders: ground of its biomes, waters, sun, sky, trees and grass."""

import json

import bpy
import numpy as np

from .. import terrains
from ..mesh import attributes, lakes, sea, surroundings, terrain_mesh
from ..outdoors import light, low_camera
from ..plants import impostors, points, species
from ..properties.session import tell
from ..worker.jobs import jobs
from .product_operator import ProductOperator
from .set_up_scene import HAZE, SUN_ELEVATION, add_haze, look_through

TRANSPARENT = 64  # surfaces in a row that light passes in Cycles: eight quads of each far tree
CLEARING = 14.0  # m, around the eye: no tree stands there
EXPOSURE = 0.35  # leaves are dark
MOST_COVER = 300_000


class OROGEN_OT_make_ready_scene(ProductOperator, bpy.types.Operator):
    """Make of the terrain a scene that renders: a camera on the ground, sun, sky and haze, sea and
    lakes, ground as its biomes are, trees with their pictures for afar, grass, ferns and flowers.
    Biomes and plants that the terrain lacks are added to it. Esc stops"""

    bl_idname = "orogen.make_ready_scene"
    bl_label = "Make Ready Scene"

    keep_camera: bpy.props.BoolProperty(
        name="Keep Camera",
        description="Leave the scene's camera where it is; plants stand before it",
    )
    eye_height: bpy.props.FloatProperty(
        name="Eye Height (m)",
        description="Over the ground, of the camera that is set up",
        default=80.0,
        min=1.0,
        max=5000.0,
    )
    reach: bpy.props.FloatProperty(
        name="Trees to (m)",
        description="So far before the camera trees stand; farther off the ground is of their "
        "colour",
        default=3000.0,
        min=10.0,
        max=100e3,
    )
    most_trees: bpy.props.IntProperty(
        name="Most Trees",
        description="If more than this would stand, they stand farther apart",
        default=1_000_000,
        min=0,
        max=20_000_000,
    )
    cover_reach: bpy.props.FloatProperty(
        name="Grass to (m)",
        description="So far before the camera grass, ferns and flowers stand",
        default=80.0,
        min=0.0,
        max=2000.0,
    )
    variants: bpy.props.IntProperty(
        name="Variants", description="Meshes of each species", default=2, min=1, max=8
    )
    quality: bpy.props.FloatProperty(
        name="Quality",
        description="Share of a tree's leaves and twigs that is kept; the fewer the larger",
        default=0.1,
        min=0.005,
        max=1.0,
    )
    fade_near: bpy.props.FloatProperty(
        name="Fade Near (m)",
        description="Farther off meshes of trees begin to fade into pictures",
        default=150.0,
        min=0.0,
    )
    fade_far: bpy.props.FloatProperty(
        name="Fade Far (m)", description="Farther off only pictures stand", default=250.0, min=0.0
    )
    viewport_share: bpy.props.FloatProperty(
        name="Viewport Share",
        description="Of the trees, in the viewport",
        default=0.2,
        min=0.0,
        max=1.0,
        subtype="FACTOR",
    )
    sun_elevation: SUN_ELEVATION
    haze: HAZE

    def ask(self, context, terrain):
        grown_from = json.loads(terrain.data[terrain_mesh.RECIPE])
        keeps = self.keep_camera and context.scene.camera
        self._eye, self._ahead = (
            low_camera.of_scene(context.scene, terrain)
            if keeps
            else low_camera.find(terrain, self.eye_height)
        )
        layers = {
            "trees": {"region": self._region(self.reach), "most_plants": self.most_trees},
            "ground_cover": {
                "region": self._region(self.cover_reach),
                "most_plants": MOST_COVER,
            },
        }
        return jobs.start_plants(grown_from, layers, variants=self.variants, quality=self.quality)

    def _region(self, reach):
        """A square, two thirds of it before the eye."""
        middle = self._eye[:2] + 0.5 * reach * self._ahead[:2]
        half = 0.75 * reach
        return [(middle - half).tolist(), (middle + half).tolist()]

    def take(self, context, terrain, result):
        uid = terrain.session_uid
        meshes = result.meshes()
        for plant in result.plants:
            species.ensure(plant, meshes)
            yield
        for plant in result.plants:
            if plant["layer"] == "trees":
                yield from impostors.ensure(plant)
        terrain = terrains.by_uid(uid)
        if terrain is None:
            raise terrain_mesh.NotNow("The terrain is gone")
        self._dress(terrain, result)
        self._set_up(context, terrain)
        meshes["trees"] = self._cleared(meshes["trees"])
        for layer in points.TITLES:
            plants = [plant for plant in result.plants if plant["layer"] == layer]
            points.write(context, terrain, layer, meshes[layer], plants, **self._fades(layer))
        trees = len(meshes["trees"]["kinds"])
        tell(context, f"The scene is ready, with {trees:,} trees")

    def _cleared(self, cloud):
        """The trees without those that would hide the view."""
        kept = np.hypot(*(cloud["positions"][:, :2] - self._eye[:2]).T) > CLEARING
        return {name: values[kept] for name, values in cloud.items()}

    def _dress(self, terrain, result):
        nx, ny = terrain.data["orogen_grid"]
        if (result.grid["nx"], result.grid["ny"]) == (nx, ny):
            attributes.add(terrain.data, result.fields)
        lakes.update(terrain)
        surroundings.add(terrain)
        sea.update(terrain, terrain.orogen, below_sea=sea.is_shown(terrain))
        terrain_mesh.set_look(terrain)

    def _set_up(self, context, terrain):
        scene = context.scene
        if not (self.keep_camera and scene.camera):
            low_camera.place(scene, terrain, self._eye, self._ahead)
            look_through(context, scene.camera)
        light.place(scene, terrain, -self._ahead[:2], self.sun_elevation)
        light.show_sky(scene)
        light.set_colours(scene)
        if scene.view_settings.exposure == 0.0:
            scene.view_settings.exposure = EXPOSURE
        scene.cycles.transparent_max_bounces = max(
            scene.cycles.transparent_max_bounces, TRANSPARENT
        )
        unit = terrain.orogen.local_scale()[0] * terrain.matrix_world.median_scale
        add_haze(self.haze, self.reach * unit)

    def _fades(self, layer):
        if layer == "trees":
            return {
                "Fade Near": self.fade_near,
                "Fade Far": max(self.fade_far, self.fade_near + 1.0),
                "Viewport Share": self.viewport_share,
            }
        return {"Fade Near": 0.6 * self.cover_reach, "Fade Far": self.cover_reach}
