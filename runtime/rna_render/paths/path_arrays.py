"""State of a band's paths between two steps of the integrator."""

from dataclasses import dataclass

import numpy as np

from rna_render.paths.sampling import PathNumbers
from rna_render.world.world import Vertices
from rna_trace.embree.tracing import ClosestHits

# Kinds of points that the camera sees, which differ in how light is looked for there; 0: others.
STRAND = 1
KINDS = 2


@dataclass(frozen=True, slots=True)
class Rays:
    """Rays of a band and their hits.

    path: (n,) place of their path in the band. origin, direction: (n, 3) float32, world space.
    beta: (n, 3) float32, throughput of their path so far. pdf: (n,) float32, density of the
    direction; None for camera rays. kind: (n,) int8, of the points where they start. probability:
    (KINDS, k) of each light to be sampled there. share: (n,) float32, of the light of the point
    that the camera sees, the part that is sought along this ray. number: (n,) int64, see
    PathNumbers, for the points that they meet. bent: (n,) bool, which
    came through solid glass, and so go from its last interface on; None for none.
    """

    path: np.ndarray
    origin: np.ndarray
    direction: np.ndarray
    hits: ClosestHits
    beta: np.ndarray
    pdf: np.ndarray | None
    kind: np.ndarray
    probability: np.ndarray
    share: np.ndarray
    number: np.ndarray
    bent: np.ndarray | None = None


@dataclass(frozen=True, slots=True)
class Paths:
    """State of the path of each of m vertices.

    path: (m,) its place in the band. beta: (m, 3) float32, its throughput. share: (m,) float32, as
    of rays. kind: (m,) int8, of the vertex. numbers: random numbers.
    """

    path: np.ndarray
    beta: np.ndarray
    share: np.ndarray
    kind: np.ndarray
    numbers: PathNumbers


@dataclass(frozen=True, slots=True)
class WeightedSamples:
    """Light that was found by sampling lights.

    tried: vertices for which there was light to be found. row: (k,) vertices that nothing else
    keeps it from; both may name a vertex more than once. light: (k,) which one it was. radiance:
    (k, 3) float32, along the path to the camera. seen: (k,) float32, from 0 to 1, how much of the
    light all that is in the way leaves in sight, the body itself included.
    """

    tried: np.ndarray
    row: np.ndarray
    light: np.ndarray
    radiance: np.ndarray
    seen: np.ndarray


def point_kinds(vertices: Vertices) -> np.ndarray:
    """The kind of each vertex: (m,) int8."""
    kinds = np.zeros(len(vertices), np.int8)
    for rows, points in vertices.parts:
        kinds[rows] = STRAND * points.on_strands
    return kinds
