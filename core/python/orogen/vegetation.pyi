# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Any

from numpy.typing import NDArray

class PlantMesh:
    @property
    def corners(self) -> NDArray[Any]: ...
    @property
    def face_starts(self) -> NDArray[Any]: ...
    @property
    def levels(self) -> NDArray[Any]: ...
    @property
    def materials(self) -> NDArray[Any]: ...
    @property
    def positions(self) -> NDArray[Any]: ...
    @property
    def uvs(self) -> NDArray[Any]: ...

def make_tree(
    species: str | dict,
    seed: int = 0,
    threads: int = 0,
    *,
    quality: float = ...,
    trunk_sides: int = ...,
    leaf_cards: bool = ...,
) -> PlantMesh: ...

def tree_parameters(
) -> dict[str, Any]: ...

def tree_species(
) -> list[dict[str, Any]]: ...

def tree_statistics(
    species: str | dict,
    seed: int = 0,
) -> dict[str, Any]: ...
