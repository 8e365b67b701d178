"""What the integrator knows of a light.

The transport T of an asset contains the cosine, so there is none here: a light gives, for points
of the scene, directions towards itself, and what arrives from there.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from rna_render.lights.kinds import LightRow
from rna_trace.embree.tracing import ClosestHits, GeometryScene
from rna_trace.rays import vectors


@dataclass(frozen=True, slots=True)
class LightSamples:
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


class Light(ABC):
    """A light of the scene. Its directions are a pure function of the point and of u.

    group: of the scene file; "" for none. row: what compiled code reads of it.
    """

    group: str
    row: LightRow

    @property
    @abstractmethod
    def delta(self) -> bool:
        """Whether all its light at a point comes from one direction: no ray can meet it."""

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

    def mis_compensated(self) -> Light:
        """This light as it is sampled where rays that scatter find it, too."""
        return self

    def sample(self, x_world: np.ndarray, u: np.ndarray) -> LightSamples:
        """Directions for the points x, (n, 3) float32; u: (n, 2) float64 in [0, 1)."""
        from rna_render.lights.table import sample_batch

        x_world = vectors("x_world", x_world)
        n = len(x_world)
        wi_world, radiance = np.empty((n, 3), np.float32), np.empty((n, 3), np.float32)
        distance, pdf, place = np.empty(n, np.float32), np.empty(n, np.float32), np.empty((n, 3))
        out = wi_world, distance, radiance, pdf, place
        sample_batch(self.row.kind, self.row.numbers, self.row.words, x_world, u, *out)
        if (sent := self.sent(place, wi_world)) is not None:
            radiance = sent
        return LightSamples(wi_world, distance, radiance, pdf)

    def sent(self, place: np.ndarray, d_world: np.ndarray) -> np.ndarray | None:
        """Radiance of a light that compiled code cannot ask for it: (n, 3) float32.

        place: (n, 3) float64, triangle and barycentrics u, v of its points, as in ClosestHits.
        d_world: (n, 3) float32, unit, of rays that what is sent stops. None for all other lights.
        """
        return None


class InfiniteLight(Light):
    """Light from infinitely far away that rays which leave the scene meet."""

    visible_to_camera: bool

    def eval_environment(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Radiance that comes against the rays' unit directions, (n, 3) float32, and pdf of them.

        Returns (n, 3) float32, and (n,) float32: the density with which `sample` finds d.
        """
        from rna_render.lights.table import eval_environment_batch

        radiance, pdf = np.empty((len(d_world), 3), np.float32), np.empty(len(d_world), np.float32)
        eval_environment_batch(
            self.row.kind, self.row.numbers, self.row.words, d_world, radiance, pdf
        )
        return radiance, pdf


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
    """A shape that is nothing but a light: black, and in the scene as an instance of its own."""

    scene: GeometryScene
    world_from_object: np.ndarray  # (4, 4), a similarity
    visible_to_camera: bool
