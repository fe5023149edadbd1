"""Of a terrain a scene that renders: ground of its biomes, waters, sun, sky, trees and grass."""

import json

import bpy
import numpy as np

from .. import terrains
from ..mesh import attributes, lakes, large_ground, sea, surroundings, terrain_mesh
from ..outdoors import light, low_camera
from ..plants import impostors, points, species
from ..properties.session import tell
from ..worker.jobs import jobs
from .product_operator import ProductOperator
from .set_up_scene import HAZE, SUN_ELEVATION, add_haze, look_through

TRANSPARENT = 64  # surfaces in a row that light passes in Cycles: eight quads of each far tree
CLEARING = 14.0  # m, around the eye: no tree stands there
EXPOSURE = 0.35  # leaves are dark
MOST_COVER = 1_000_000
COVER_ENDS = 3.0  # times as far as grass is in full: there are crossed quads, fewer and fewer


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
        description="So far before the camera grass, ferns and flowers stand in full; three times "
        "as far as pictures, fewer and fewer",
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
    picture_size: bpy.props.IntProperty(
        name="Picture Size",
        description="Pixels along the longer side of a tree's picture for afar",
        default=192,
        min=16,
        max=2048,
        subtype="PIXEL",
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
            "trees": {"region": self._region(terrain, self.reach), "most_plants": self.most_trees},
            "ground_cover": {
                "region": self._region(terrain, COVER_ENDS * self.cover_reach),
                "most_plants": MOST_COVER,
            },
        }
        return jobs.start_plants(grown_from, layers, variants=self.variants, quality=self.quality)

    def _region(self, terrain, reach):
        """A square, two thirds of it before the eye."""
        middle = self._eye[:2] + 0.5 * reach * self._ahead[:2] - terrain.data["orogen_offset"]
        half = 0.75 * reach
        return [(middle - half).tolist(), (middle + half).tolist()]

    def take(self, context, terrain, result):
        uid = terrain.session_uid
        meshes = result.meshes()
        for done in impostors.ensure(result.plants, meshes, self.picture_size):
            yield "pictures of plants", done
        for plant in result.plants:
            species.ensure(plant, meshes)
            yield
        terrain = terrains.by_uid(uid)
        if terrain is None:
            raise terrain_mesh.NotNow("The terrain is gone")
        terrain_mesh.check_writable(terrain)
        offset = terrain_mesh.offset_of(terrain, result.grid)
        self._dress(terrain, result, offset)
        self._set_up(context, terrain)
        eye = self._eye[:2] - offset
        clouds = {layer: self._kept(layer, meshes[layer], eye) for layer in points.TITLES}
        for layer, cloud in clouds.items():
            plants = [plant for plant in result.plants if plant["layer"] == layer]
            points.write(context, terrain, layer, cloud, offset, plants, **self._fades(layer))
        points.settle(terrain, result.grid, result.fields["elevation"])
        tell(context, f"The scene is ready, with {len(clouds['trees']['kinds']):,} trees")

    def _kept(self, layer, cloud, eye):
        """Trees without those that would hide the view; grass that grows sparse at its end."""
        distance = np.hypot(*(cloud["positions"][:, :2] - eye).T)
        if layer == "trees":
            kept = distance > CLEARING
        else:
            chance = np.random.default_rng(1).random(len(distance))
            kept = distance < self.cover_reach * (1.0 + chance * (COVER_ENDS - 1.0))
        return {name: values[kept] for name, values in cloud.items()}

    def _dress(self, terrain, result, offset):
        grid, fields = result.grid, result.fields
        if large_ground.is_tiled(terrain):
            large_ground.add(terrain, fields)
            grid, fields, _ = large_ground.coarsened(grid, fields, offset)
        if list(terrain.data["orogen_grid"]) == [grid["nx"], grid["ny"]]:
            attributes.add(terrain.data, fields)
        water = None
        if "water_depth" in result.fields:
            heights = result.fields["elevation"], result.fields["water_depth"]
            water = lakes.surface(*heights, result.grid["cell_size"])
        lakes.put(terrain, water, offset)
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
        near, far = self.fade_near, max(self.fade_far, self.fade_near + 1.0)
        if layer == "ground_cover":
            near, far = 0.6 * self.cover_reach, self.cover_reach
        return {"Fade Near": near, "Fade Far": far, "Viewport Share": self.viewport_share}
