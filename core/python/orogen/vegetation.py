"""Plants: trees after Weber and Penn, and ground cover, as meshes (paper B, VII)."""

from ._core import vegetation as _room

__all__ = [name for name in dir(_room) if not name.startswith("_")]
globals().update({name: getattr(_room, name) for name in __all__})
