"""The file in which a worker hands over a job's arrays: raw bytes, each array at its offset.

The description (names, types, shapes, offsets) travels beside it, in the worker's answer.
"""

import numpy as np

ALIGNMENT = 64  # bytes


def write_arrays(path, arrays):
    """Writes named arrays to one file; returns the description of where each lies."""
    described = []
    with open(path, "wb") as file:
        for name, array in arrays.items():
            array = np.ascontiguousarray(array)
            file.write(b"\0" * (-file.tell() % ALIGNMENT))
            described.append(
                {
                    "name": name,
                    "dtype": array.dtype.str,
                    "shape": list(array.shape),
                    "offset": file.tell(),
                }
            )
            file.write(array.data)
        if not described:
            file.write(b"\0")  # an empty file cannot be mapped
    return described
