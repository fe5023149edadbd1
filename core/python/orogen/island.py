"""Islands on polygon maps: cells, coasts, rivers, climate, biomes and height maps (paper B)."""

from ._core import island as _room

__all__ = [name for name in dir(_room) if not name.startswith("_")]
globals().update({name: getattr(_room, name) for name in __all__})
