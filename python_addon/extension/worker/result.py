"""The arrays of a finished job, mapped from the worker's file."""

import os

import numpy as np


class Result:
    """Fields by name, as read-only views of the file. `close` it when they are copied."""

    def __init__(self, answer):
        self._file = answer["file"]
        self.grid = answer["grid"]
        self.warnings = answer["warnings"]
        memory = np.memmap(self._file, dtype=np.uint8, mode="r")
        self.fields = {}
        for array in answer["arrays"]:
            dtype = np.dtype(array["dtype"])
            shape = tuple(array["shape"])
            size = dtype.itemsize * int(np.prod(shape))
            raw = memory[array["offset"] : array["offset"] + size]
            self.fields[array["name"]] = np.asarray(raw).view(dtype).reshape(shape)

    def meshes(self):
        """Arrays called MESH/NAME, as {MESH: {NAME: array}}."""
        meshes = {}
        for path, array in self.fields.items():
            mesh, _, name = path.rpartition("/")
            meshes.setdefault(mesh, {})[name] = array
        return meshes

    def close(self):
        """Drops the views, then the file. Where a view is still held (Windows) it stays until the
        worker's folder goes."""
        self.fields = {}
        try:
            os.remove(self._file)
        except OSError:
            pass
