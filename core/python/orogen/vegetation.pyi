# Made by core/python/bindings/make_stubs.py; do not edit.
from typing import Any

from numpy.typing import ArrayLike, NDArray

class PlantCloud:
    def __len__(self) -> int: ...
    @property
    def density_share(self) -> float: ...
    @property
    def kinds(self) -> NDArray[Any]: ...
    @property
    def positions(self) -> NDArray[Any]: ...
    @property
    def rotations(self) -> NDArray[Any]: ...
    @property
    def scales(self) -> NDArray[Any]: ...

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

def ground_cover(
) -> list[dict[str, Any]]: ...

def ground_cover_table(
) -> dict[str, Any]: ...

def make_ground_cover(
    species: str | dict,
    seed: int = 0,
    crossed_quads: bool = False,
) -> PlantMesh: ...

def make_tree(
    species: str | dict,
    seed: int = 0,
    threads: int = 0,
    *,
    quality: float = ...,
    trunk_sides: int = ...,
    leaf_cards: bool = ...,
) -> PlantMesh: ...

def place_plants(
    elevation: ArrayLike,
    biome: ArrayLike,
    cell_size: float,
    table: dict | None = None,
    water_depth: ArrayLike | None = None,
    snow_cover: ArrayLike | None = None,
    region: tuple[Any, ...] | None = None,
    seed: int = 0,
    threads: int = 0,
    *,
    density_factor: float = ...,
    most_plants: int = ...,
) -> PlantCloud: ...

def plant_parameters(
) -> dict[str, Any]: ...

def tree_species(
) -> list[dict[str, Any]]: ...

def tree_statistics(
    species: str | dict,
    seed: int = 0,
) -> dict[str, Any]: ...

def tree_table(
) -> dict[str, Any]: ...
