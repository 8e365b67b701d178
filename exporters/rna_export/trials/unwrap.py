"""A dataset whose samples also have uv: the mesh unwrapped, points found on it by their rays."""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType

import numpy as np

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.trials.trial import Trial
from rna_sdk.errors import TrainingError
from rna_sdk.package import Mesh
from rna_trace import TriangleScene

_STEP = 1e-3  # of the asset's size, away from the point towards its viewer


def check_unwrapping(trials: list[Trial]) -> None:
    """Raise `TrainingError` if one of the trials is to be unwrapped, and nothing here can."""
    if not all(trial.packageable for trial in trials):
        _xatlas()


def _xatlas() -> ModuleType:
    try:
        import xatlas
    except ImportError:
        raise TrainingError(
            "models with a uv texture need xatlas to unwrap the mesh: pip install xatlas"
        ) from None
    module: ModuleType = xatlas
    return module


class Unwrapped:
    """An atlas without overlaps over a mesh, whatever uv of its own the mesh has.

    A glTF's own uv are those of several textures, one over the other.
    """

    def __init__(self, mesh: Mesh):
        _, triangles, uv = _xatlas().parametrize(mesh.positions, mesh.triangles)
        self._corners = uv[triangles].astype(np.float32)  # (triangles, 3, 2)
        self._scene = TriangleScene([(mesh.positions, mesh.triangles)])
        self._step = np.float32(_STEP * np.ptp(mesh.positions, axis=0).max())

    def uv(self, position: np.ndarray, wo: np.ndarray) -> np.ndarray:
        """(n, 2) float32 of points that rays along -wo hit; 0 where none is found again."""
        hits = self._scene.intersect(position + self._step * wo, -wo)
        weights = np.stack([1.0 - hits.u - hits.v, hits.u, hits.v], axis=1)
        uv = np.einsum("nc,nck->nk", weights, self._corners[np.maximum(hits.primitive, 0)])
        return np.where(hits.geometry[:, None] >= 0, uv, 0.0).astype(np.float32)


class UnwrappedPart(DatasetPart):
    """A captured surface; its samples and views have the field `uv`, (n, 2) float32."""

    def __init__(self, part: DatasetPart):
        super().__init__(part.dataset, part.captured)
        if self.kind != "surface":
            raise TrainingError(f"{self.folder}: holds fibers, expected a surface to unwrap")
        mesh = self.geometry()
        assert isinstance(mesh, Mesh)  # as its kind says
        self._unwrapped = Unwrapped(mesh)

    def training_samples(self, shards: int | None = None) -> dict[str, np.ndarray]:
        return self._with_uv(super().training_samples(shards))

    def validation_views(self) -> list[ValidationView]:
        return [replace(v, samples=self._with_uv(v.samples)) for v in super().validation_views()]

    def _with_uv(self, samples: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        return {**samples, "uv": self._unwrapped.uv(samples["position"], samples["wo"])}
