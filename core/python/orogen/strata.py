"""Layers of rock, and where they crop out."""

from ._core import strata as _room

__all__ = [name for name in dir(_room) if not name.startswith("_")]
globals().update({name: getattr(_room, name) for name in __all__})
