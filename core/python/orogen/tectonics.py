"""Plates, their boundaries and velocities."""

from ._core import tectonics as _room

__all__ = [name for name in dir(_room) if not name.startswith("_")]
globals().update({name: getattr(_room, name) for name in __all__})
