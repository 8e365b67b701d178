"""Points that rays have hit, and how they scatter light; one interface for all kinds of bodies."""

from abc import ABC, abstractmethod
from enum import Enum, auto
from typing import NamedTuple, Protocol

import numpy as np

from rna_trace.embree.tracing import ClosestHits, GeometryScene
from rna_trace.hit_points import HitPoints, Lines


class Points(ABC):
    """Points of a part of a body that are seen, and directions wo to the viewer; object space.

    x, n: (m, 3) float32, points and unit normals. on_strands: whether they are on
    strands, many of which may share a pixel. found: where they are in the world, and the step of
    rays from there; None where rays pass through the body.
    """

    x: np.ndarray
    n: np.ndarray
    on_strands = False
    found: HitPoints | None = None

    @abstractmethod
    def transport(
        self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray, u: np.ndarray | None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Radiance towards the viewer under irradiance 1 from wi, and how free wi is.

        It contains the cosine. row: (k,) which points. wi: (k, 3) float32, unit. distance: (k,)
        float32, to where the light comes from. u: (k, 2) float64 in [0, 1), for an estimate of
        nearby light; None where no body counts it. Returns (k, 3) float32, and (k,) from 0 to 1:
        how much of that place the body itself leaves in sight, if rays that start on it pass
        through it.
        """

    @abstractmethod
    def transport_and_pdf(
        self, row: np.ndarray, wi: np.ndarray, distance: np.ndarray, u: np.ndarray | None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Results of `transport`, and the density of `sample_and_pdf` in wi."""

    @abstractmethod
    def sample_and_pdf(self, row: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Directions wi, about as often as light from there matters, and their density.

        row: (k,) which points. u: (k, 3) float64 in [0, 1). Returns (k, 3) float32, unit, and (k,)
        float32, per steradian.
        """


class Role(Enum):
    """Role of a body in the scene."""

    SCATTER = auto()
    CATCH_SHADOWS = auto()  # shows the shadows that fall on it to the camera, and nothing else
    SHINE = auto()  # a light, and black


class Arrived(NamedTuple):
    """Rays that have hit a part of a body: `ray`, (m,), of those of `hits`.

    wo: (m, 3) float32, object space. seen: whether they are camera rays. widths: (m,) float32, of a
    pixel at each hit, object space. lines: the rays.
    """

    hits: ClosestHits
    ray: np.ndarray
    wo: np.ndarray
    seen: bool
    widths: np.ndarray
    lines: Lines


class Body(Protocol):
    """An object with its geometry in Embree, in its object space.

    passes_through: whether rays that start on it pass through it, since its transport holds what
    happens inside it. counts_nearby: whether transport takes random numbers. one_sided: whether
    transport is 0 where wi and wo are on different sides of the geometric normal. part_count: of
    parts, one a geometry of its scene.
    """

    role: Role
    passes_through: bool
    counts_nearby: bool
    one_sided: bool
    part_count: int

    @property
    def scene(self) -> GeometryScene: ...

    def points(self, part: int, arrived: Arrived) -> Points:
        """The points of a part that rays have hit. A body that shines has none."""
        ...
