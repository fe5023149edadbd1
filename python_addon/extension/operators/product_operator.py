"""What operators share that ask the worker for more of a terrain as it was grown, whatever its
settings say by now."""

import json

from .. import terrains
from ..mesh import attributes, terrain_mesh
from ..worker.jobs import jobs
from .job_operator import JobOperator


class ProductOperator(JobOperator):
    bl_options = {"REGISTER", "UNDO"}
    kind = ""  # of worker_rocks.KINDS

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Grow a terrain first")
        terrain = terrains.active(context)
        return terrain is not None and terrain_mesh.RECIPE in terrain.data

    def ask(self, context, terrain):
        grown_from = json.loads(terrain.data[terrain_mesh.RECIPE])
        return jobs.start_rocks(grown_from, self.kind, **self.wishes(context, terrain))

    def wishes(self, context, terrain):
        return {}


class RocksOperator(ProductOperator):
    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Grow a terrain with layers of rock first")
        terrain = terrains.active(context)
        return (
            terrain is not None
            and terrain_mesh.RECIPE in terrain.data
            and attributes.STRATA_COLOR in terrain.data.attributes
        )
