"""A light as the integrator sees it; `kinds` has a file for each kind.

The transport T of an asset contains the cosine, so there is none here: a light gives, for points
of the scene, directions towards itself, and what arrives from there.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, ClassVar, NamedTuple

import numpy as np

from rna_render.lights.directions import luminance
from rna_render.scene.light_models import AreaModel
from rna_sdk.arrays import vectors
from rna_trace.embree.tracing import ClosestHits, GeometryScene


def light_numbers(*members: tuple[str, int | tuple[int, ...]]) -> np.dtype[Any]:
    """The numbers of a kind of light, float64: its colour, and members by name and shape.

    Compiled code and GPUs read them by these names. colour: radiance, irradiance, intensity, or a
    factor on what triangles send. A `frame`, (3, 4), is rows of the matrix to the world of a shape
    that faces +z.
    """
    return np.dtype([("colour", "<f8", 3), *((name, "<f8", shape) for name, shape in members)])


class LightSamples(NamedTuple):
    """One direction towards a light from each of n points.

    wi_world: (n, 3) float32, unit.
    distance: (n,) float32, to the light, maybe infinite.
    radiance: (n, 3) float32, what arrives if nothing is in the way: RGB radiance, or irradiance
        from a delta light.
    pdf: (n,) float32, density of wi per steradian; 1 for a delta light, 0 where nothing arrives.
    """

    wi_world: np.ndarray
    distance: np.ndarray
    radiance: np.ndarray
    pdf: np.ndarray

    @classmethod
    def zeros(cls, n: int) -> "LightSamples":
        """Samples to be filled in."""
        return cls(_vectors(n), np.zeros(n, np.float32), _vectors(n), np.zeros(n, np.float32))


def _vectors(n: int) -> np.ndarray:
    return np.zeros((n, 3), np.float32)


class Light(ABC):
    """A light of the scene. Its directions are a pure function of the point and of u.

    group: of the scene file; "" for none. members: of NUMBERS.

    Attributes:
        kind: its name in WGSL.
        NUMBERS: what compiled code knows of a light of this kind, by `light_numbers`.
        numbers: (1,) of NUMBERS.
        delta: whether all its light at a point comes from one direction: no ray can meet it.
    """

    kind: ClassVar[str]
    NUMBERS: ClassVar[np.dtype[Any]]
    delta: ClassVar[bool] = False

    def __init__(self, group: str, **members: Any) -> None:
        self.group = group
        self.numbers = np.zeros(1, self.NUMBERS)
        for name, value in members.items():
            self.numbers[name] = value

    @property
    def colour(self) -> np.ndarray:
        """(3,) float64."""
        return np.asarray(self.numbers["colour"][0])

    @property
    def samples(self) -> int:
        """Samples of the light per camera ray at points that the camera sees.

        Under lamps a third takes more time than it saves.
        """
        return 1 if self.delta else 2

    @abstractmethod
    def power(self, scene_radius: float) -> float:
        """About how much light it brings to a scene of that radius: W of luminance.

        Only for choosing among lights.
        """

    def mis_compensated(self) -> "Light":
        """This light as it is sampled where rays that scatter find it, too."""
        return self

    def sample(self, x_world: np.ndarray, u: np.ndarray) -> LightSamples:
        """Directions for the points x, (n, 3) float32; u: (n, 2) float64 in [0, 1)."""
        samples = LightSamples.zeros(len(x_world))
        self._fill(vectors("x_world", x_world), u, samples)
        return samples

    @abstractmethod
    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        """Fill in `sample`."""


class InfiniteLight(Light):
    """Light from infinitely far away that rays which leave the scene meet."""

    visible_to_camera: bool

    @abstractmethod
    def eval_environment(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Radiance that comes against the rays' unit directions, (n, 3) float32, and pdf of them.

        Returns (n, 3) float32, and (n,) float32: the density with which `sample` finds d.
        """


class ShapeLight(Light):
    """Light from a surface that rays meet: one of its own (PlacedLight), or an object's."""

    @abstractmethod
    def eval_hit(
        self, x_world: np.ndarray, d_world: np.ndarray, hits: ClosestHits, ng_world: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Radiance against rays that meet the light's surface, and the density of their directions.

        x_world: (n, 3) float32, where the rays start. d_world: (n, 3) float32, unit. hits: theirs,
        all on the surface; t in the world. ng_world: (n, 3) float32, hits.ng in the world.
        Returns (n, 3) float32, and (n,) float32: the density per steradian with which `sample` at
        x finds d.
        """


class PlacedLight(ShapeLight):
    """A black shape, an instance of its own in the scene, one side of which shines evenly.

    area: m^2, of the side that shines. shape: members of NUMBERS.

    Attributes:
        sample_kernel: (numbers, x_world, u, wi_world, distance, pdf): fills in the last three as
            `sample` does; pdf is 0 where the dark side is sampled.
        density_kernel: (numbers, x_world, d_world, pdf): fills in the densities of `eval_hit`, 0
            where rays meet the dark side.
    """

    sample_kernel: ClassVar[Callable[..., None]]
    density_kernel: ClassVar[Callable[..., None]]

    scene: GeometryScene
    world_from_object: np.ndarray  # (4, 4), a similarity

    def __init__(self, model: AreaModel, area: float, **shape: Any) -> None:
        super().__init__(model.group, colour=np.asarray(model.radiance, np.float32), **shape)
        self.visible_to_camera = model.visible_to_camera
        self.area = area

    def power(self, scene_radius: float) -> float:
        return float(np.pi * self.area * luminance(self.colour))

    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        self.sample_kernel(
            self.numbers, x_world, u, samples.wi_world, samples.distance, samples.pdf
        )
        samples.radiance[samples.pdf > 0.0] = self.colour

    def eval_hit(
        self, x_world: np.ndarray, d_world: np.ndarray, hits: ClosestHits, ng_world: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        x_world = vectors("x_world", x_world)
        radiance, pdf = np.zeros_like(x_world), np.empty(len(x_world), np.float32)
        d_world = vectors("d_world", d_world, len(x_world))
        self.density_kernel(self.numbers, x_world, d_world, pdf)
        radiance[pdf > 0.0] = self.colour
        return radiance, pdf
