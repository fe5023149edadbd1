"""Colours as meshes hold them: linear, with alpha."""

import numpy as np

_SRGB = np.arange(256) / 255.0
_LINEAR = np.where(_SRGB <= 0.04045, _SRGB / 12.92, ((_SRGB + 0.055) / 1.055) ** 2.4).astype(
    np.float32
)


def unpack(values):
    """(n, 3) bytes of integers 0xRRGGBB."""
    values = np.asarray(values).ravel()
    return np.stack([values >> shift & 255 for shift in (16, 8, 0)], axis=-1).astype(np.uint8)


def to_linear(rgb):
    """(n, 4) float32 of sRGB bytes (n, 3); alpha 1."""
    result = np.ones((len(rgb), 4), np.float32)
    result[:, :3] = _LINEAR[np.asarray(rgb)]
    return result
