"""Exact renderer of spheres and cylinders. Pictures have the bytes of render-aos and render-soa, and no intersection
is decided wrongly."""

from collections.abc import Sequence
from typing import Any, Literal, SupportsFloat, SupportsIndex, TypedDict, final, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Self, Unpack

__all__ = ["Config", "Error", "Scene", "depth", "intersect", "normals", "render"]

_Number = SupportsFloat | SupportsIndex
_Numbers = Sequence[_Number] | NDArray[Any]

class _Keys(TypedDict, total=False):
    aspect_ratio: _Numbers
    image_width: SupportsIndex
    gamma: _Number
    camera_position: _Numbers
    camera_target: _Numbers
    camera_north: _Numbers
    field_of_view: _Number
    samples_per_pixel: SupportsIndex
    max_depth: SupportsIndex
    material_rng_seed: SupportsIndex
    ray_rng_seed: SupportsIndex
    background_dark_color: _Numbers
    background_light_color: _Numbers

class Error(ValueError):
    """A configuration, a scene or a picture that is not valid."""

    message: str
    line: int | None
    column: int | None

@final
class Config:
    """A picture's size, camera, samples and background, by the keys of a configuration file."""

    def __new__(cls, **keys: Unpack[_Keys]) -> Self: ...
    @staticmethod
    def parse(text: str | bytes, /) -> Config: ...
    def replace(self, **keys: Unpack[_Keys]) -> Config: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

@final
class Scene:
    """Materials and objects, each added as a line of a scene file."""

    def __new__(cls) -> Self: ...
    @staticmethod
    def parse(text: str | bytes, /) -> Scene: ...
    def matte(self, name: str, reflectance: _Numbers) -> Scene: ...
    def metal(self, name: str, reflectance: _Numbers, diffusion: _Number) -> Scene: ...
    def refractive(self, name: str, index: _Number) -> Scene: ...
    def sphere(self, center: _Numbers, radius: _Number, material: str) -> Scene: ...
    def cylinder(self, center: _Numbers, radius: _Number, axis: _Numbers, material: str) -> Scene: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

_Scatter = Literal["statement", "published", "deterministic"]

@overload
def render(
    config: Config, scene: Scene, scatter: _Scatter = "statement", linear: Literal[False] = False
) -> NDArray[np.uint8]: ...
@overload
def render(
    config: Config, scene: Scene, scatter: _Scatter = "statement", *, linear: Literal[True]
) -> NDArray[np.float64]: ...
def intersect(
    origins: ArrayLike, directions: ArrayLike, scene: Scene
) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64], NDArray[np.int8]]: ...
def depth(config: Config, scene: Scene) -> NDArray[np.float64]: ...
def normals(config: Config, scene: Scene) -> NDArray[np.float64]: ...
