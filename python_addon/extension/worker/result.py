"""The arrays of a finished job, mapped from the worker's file."""

import os

import numpy as np


class Result:
    """Read-only views of the file. `close` it when they are copied."""

    def __init__(self, answer):
        self._file = answer["file"]
        self.grid = answer["grid"]
        self.warnings = answer.get("warnings", ())
        self.rocks = answer.get("rocks", ())
        self.plants = answer.get("plants", ())  # kinds that stand there
        self.years = answer.get("years", ())  # of each frame of growth; of a frame: its own
        memory = np.memmap(self._file, dtype=np.uint8, mode="r")
        self._arrays = {}
        for array in answer["arrays"]:
            dtype = np.dtype(array["dtype"])
            shape = tuple(array["shape"])
            size = dtype.itemsize * int(np.prod(shape))
            raw = memory[array["offset"] : array["offset"] + size]
            self._arrays[array["name"]] = np.asarray(raw).view(dtype).reshape(shape)

    @property
    def fields(self):
        """Arrays by name, those of meshes and of growth apart."""
        return {name: array for name, array in self._arrays.items() if "/" not in name}

    def meshes(self):
        """Arrays called MESH/NAME, as {MESH: {NAME: array}}."""
        meshes = {}
        for path, array in self._arrays.items():
            mesh, _, name = path.rpartition("/")
            meshes.setdefault(mesh, {})[name] = array
        return meshes

    def frames(self):
        """Growth: pairs of years and heights."""
        for i, years in enumerate(self.years):
            yield years, self._arrays[f"growth/{i}"]

    def close(self):
        """Drops the views, then the file. Where a view is still held (Windows) it stays until the
        worker's folder goes."""
        self._arrays = {}
        remove(self._file)


def remove(file):
    try:
        os.remove(file)
    except OSError:
        pass
