"""The material at points of a mesh: evaluation, sampling, density; `bsdf` has the formulas."""

from dataclasses import dataclass

import numpy as np

from rna_render.materials import bsdf
from rna_render.materials.ggx_albedo import ALBEDO_ADDRESSES


@dataclass(frozen=True, slots=True)
class ClearCoat:
    """A second coat at n points.

    weight, alpha: (n,) float32, how much of it there is, in [0, 1], and its roughness^2. n: (n, 3)
    float32, its shading normals.
    """

    weight: np.ndarray
    alpha: np.ndarray
    n: np.ndarray


@dataclass(frozen=True, slots=True)
class Scattering:
    """Parameters of the material at n points.

    base_color: (n, 3) float32, in [0, 1]: albedo below the coat, or reflectance of the metal.
    alpha: (n,) float32, roughness^2; what is below MIN_ALPHA counts as MIN_ALPHA.
    metallic: (n,) float32, in [0, 1].
    coat_f0: (n,) float32, in [0, 1): reflectance of the coat seen straight on; 0 for no coat.
    emission: (n, 3) float32, radiance to both sides, W/(m^2 sr).
    weights: (n, 2) float32, in [0, 1], of the coat and of what is diffuse; None for 1.
    clear: the clear coat, if there is any.

    The methods take unit vectors, float32, in one space: n and ng, (n, 3), the shading and the
    geometric normal, of either sign; wo, (n, 3), to the viewer; wi, (k, 3), to the light. row: (k,)
    which points they are for; None for all, in order. The shading normal is turned to the side of
    the surface that wo is on; a zero one is replaced by ng.
    """

    base_color: np.ndarray
    alpha: np.ndarray
    metallic: np.ndarray
    coat_f0: np.ndarray
    emission: np.ndarray
    weights: np.ndarray | None = None
    clear: ClearCoat | None = None

    def evaluate(
        self,
        n: np.ndarray,
        ng: np.ndarray,
        wo: np.ndarray,
        wi: np.ndarray,
        row: np.ndarray | None = None,
    ) -> np.ndarray:
        """f(wo, wi) |n.wi|: (k, 3) float32; 0 for a wi behind the shading normal or on the other
        side of the surface than wo."""
        value = np.empty((len(wi), 3), np.float32)
        bsdf.scatter(self._parameters(), _rows(row, wo), n, ng, wo, None, wi, value, None)
        return value

    def evaluate_and_pdf(
        self,
        n: np.ndarray,
        ng: np.ndarray,
        wo: np.ndarray,
        wi: np.ndarray,
        row: np.ndarray | None = None,
    ) -> tuple[np.ndarray, np.ndarray]:
        """Results of `evaluate`, and the density of `sample_and_pdf` in wi, per steradian, (k,)
        float32, which integrates to 1 over the whole sphere."""
        value, density = np.empty((len(wi), 3), np.float32), np.empty(len(wi), np.float32)
        bsdf.scatter(self._parameters(), _rows(row, wo), n, ng, wo, None, wi, value, density)
        return value, density

    def sample_and_pdf(
        self,
        n: np.ndarray,
        ng: np.ndarray,
        wo: np.ndarray,
        u: np.ndarray,
        row: np.ndarray | None = None,
    ) -> tuple[np.ndarray, np.ndarray]:
        """Unit directions wi, (k, 3) float32, a pure function of u, and their density.

        u: (k, 3) float64 in [0, 1). The third number chooses between the cosine about the normal
        and reflection at a visible microfacet, in proportion to their albedos. Some wi are
        behind the surface, where `evaluate` is 0.
        """
        wi, density = np.empty((len(u), 3), np.float32), np.empty(len(u), np.float32)
        bsdf.scatter(self._parameters(), _rows(row, wo), n, ng, wo, u, wi, None, density)
        return wi, density

    def _parameters(self) -> bsdf.Parameters:
        weights = np.ones((1, 2), np.float32) if self.weights is None else self.weights
        none = np.zeros(1, np.float32), np.ones(1, np.float32), np.zeros((1, 3), np.float32)
        clear = none if self.clear is None else (self.clear.weight, self.clear.alpha, self.clear.n)
        factors = self.base_color, self.alpha, self.metallic, self.coat_f0
        return (*factors, weights, *clear, ALBEDO_ADDRESSES)


def _rows(row: np.ndarray | None, points: np.ndarray) -> np.ndarray:
    return np.arange(len(points)) if row is None else row
