"""Rain that winds drop on mountains, and biomes by climate."""

from ._core import climate as _room

__all__ = [name for name in dir(_room) if not name.startswith("_")]
globals().update({name: getattr(_room, name) for name in __all__})
