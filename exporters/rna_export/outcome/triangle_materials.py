"""The material of captured points: the material of their triangle."""

import numpy as np

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import CapturedImage, ValidationView, WholeView
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves, Mesh

_STEP = np.float32(1e-3)  # of the asset's size, from a point towards its viewer


class TriangleMaterials:
    """Materials of a dataset's points.

    Attributes:
        names: of the manifest's materials, and after them of the parts; "" where there is but one.
            A point of strands, or of a dataset that does not record its triangles' materials, has
            its part in place of a material.

    Raises CaptureError where the dataset's file of materials does not fit its meshes.
    """

    def __init__(self, dataset: Dataset) -> None:
        whole = Dataset(dataset.folder)  # in one piece, as its triangles are counted
        self._first_part = len(whole.manifest.materials)
        materials = [material.name for material in whole.manifest.materials]
        names = [*materials, *(part.name for part in whole.parts)]
        self.names = names if len(names) > 1 else [""]
        self._scene, numbers = whole.scene, whole.materials
        for part, geometry in zip(whole.parts, self._scene.geometries, strict=True):
            of_part = numbers.get(part.name)
            if of_part is not None and not self._fits(of_part, geometry):
                raise CaptureError(f"{whole.folder}: its materials do not fit its triangles")
        self._numbers = [numbers.get(part.name) for part in whole.parts]
        self._step = _STEP * np.float32(self._scene.diagonal)

    def _fits(self, numbers: np.ndarray, geometry: Mesh | Curves) -> bool:
        """Whether an array has a material, or none, for each triangle."""
        if not isinstance(geometry, Mesh) or numbers.shape != (len(geometry.triangles),):
            return False
        known = (numbers >= -1) & (numbers < self._first_part)
        return numbers.dtype == np.int16 and bool(known.all())

    def is_part(self, material: int) -> bool:
        """Whether a number is a part's."""
        return material >= self._first_part

    def of_image(self, view: CapturedImage) -> np.ndarray:
        """(n,) int32, numbers of `names` for the rows of a captured image; -1 where nothing is."""
        views = view.parts if isinstance(view, WholeView) else (view,)
        rows = [self._at(v.samples) for v in views if isinstance(v, ValidationView)]
        return np.concatenate(rows)

    def _at(self, samples: dict[str, np.ndarray]) -> np.ndarray:
        position, wo = samples["position"], samples["wo"]
        hits = self._scene.intersect(position + self._step * wo, -wo)
        result = np.full(len(position), -1, np.int32)
        for part, numbers in enumerate(self._numbers):
            on = hits.geometry == part
            result[on] = self._first_part + part
            if numbers is not None:
                result[on] = numbers[hits.primitive[on]]
        return result
