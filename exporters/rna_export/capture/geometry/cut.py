"""A dataset whose surfaces are cut into pieces with their own planes.

The pieces are parts of the package. What lies near a seam is learnt by the pieces on both sides.
"""

from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np
import trimesh

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_manifest import BASE_COLOR, CapturedPart
from rna_export.capture.dataset.dataset_part import DatasetPart, View
from rna_export.capture.dataset.validation_view import EmissionView, ValidationView, WhiteView
from rna_sdk.errors import CaptureError
from rna_sdk.package import Mesh
from rna_sdk.package.geometry.quantised_mesh import QuantisedMesh
from rna_sdk.package.limits import MAX_PARTS
from rna_trace import PartsScene

_MARGIN = 0.02  # of a piece's longest side: 5 texels of 256, on either side of a seam
_STEP = 1e-3  # of the asset's size, from a point towards its viewer


class CutDataset(Dataset):
    """A dataset's captured rays; each surface is cut into parts NAME_0, NAME_1, ...

    Raises `CaptureError` for more parts than a package holds, or fewer triangles than pieces.
    """

    def __init__(self, dataset: Dataset, pieces: int):
        self.folder, self.manifest, self.cut = dataset.folder, dataset.manifest, pieces
        self._whole = dataset.parts
        if len(self.parts) > MAX_PARTS:
            raise CaptureError(
                f"{self.folder}: a cut in {pieces} gives {len(self.parts)} parts, expected at most "
                f"{MAX_PARTS}"
            )

    @cached_property
    def parts(self) -> tuple[DatasetPart, ...]:
        return tuple(piece for part in self._whole for piece in self._pieces(part))

    def _pieces(self, part: DatasetPart) -> list[DatasetPart]:
        if part.kind != "surface":
            return [DatasetPart(self, part.captured)]
        if part.captured.transmittance or part.captured.normal_maps:
            raise CaptureError(
                f"{self.folder}: part {part.name} has materials with transmittance or normal maps; "
                "expected neither of a part that is cut into pieces "
                "(rna-capture --normal-texels 0 maps no normals)"
            )
        mesh = part.geometry()
        assert isinstance(mesh, Mesh)  # as its kind says
        if len(mesh.triangles) < self.cut:
            raise CaptureError(
                f"{self.folder}: part {part.name} has {len(mesh.triangles)} triangles, expected at "
                f"least {self.cut} to cut it into as many pieces"
            )
        cut = cut_triangles(mesh, self.cut)
        seams = _Seams([_taken(mesh, triangles) for triangles in cut])
        colors = [_within(part.captured, triangles) for triangles in cut]
        return [Piece(self, part, k, seams, colors[k]) for k in range(self.cut)]


def as_cut(dataset: Dataset, pieces: int) -> Dataset:
    """The dataset with its surfaces cut into the given number of pieces; itself for 1."""
    return dataset if pieces == 1 else CutDataset(dataset, pieces)


class Piece(DatasetPart):
    """One piece of a cut surface."""

    def __init__(
        self,
        dataset: CutDataset,
        whole: DatasetPart,
        number: int,
        seams: "_Seams",
        colors: dict[str, Any],
    ):
        bounds = _with_margin(seams, number, whole)
        changes = {"name": f"{whole.name}_{number}", "bounds": bounds, **colors}
        super().__init__(dataset, whole.captured.model_copy(update=changes))
        self._whole, self._number, self._seams = whole, number, seams

    def geometry(self) -> Mesh:
        return self._seams.meshes[self._number]

    def source_vertices(self) -> None:
        """Not known of a piece."""

    def training_samples(self, shards: int | None = None) -> dict[str, np.ndarray]:
        """Samples in the piece's bounds, with the edges of its neighbours."""
        return self._near(self._whole.training_samples(shards))

    def emission_samples(self) -> dict[str, np.ndarray]:
        """Emission samples in the piece's bounds."""
        return self._near(self._whole.emission_samples())

    def _near(self, samples: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        low, high = np.array(self.bounds, np.float32)
        position = samples["position"]
        near = np.all((position >= low) & (position <= high), axis=1)
        if not near.any():
            raise CaptureError(f"{self.folder}: no view ray met part {self.name}")
        fields = samples.keys() - ({BASE_COLOR} - self.fields.keys())
        return {name: rows[near] for name, rows in samples.items() if name in fields}

    def view(self, index: int) -> ValidationView:
        """The rows that lie on the piece itself."""
        return self._on_piece(self._whole.view(index))

    def emission_views(self) -> list[EmissionView]:
        """The rows of emission views that lie on the piece itself."""
        return [self._on_piece(view) for view in self._whole.emission_views()]

    def white_view(self) -> WhiteView | None:
        """The rows of the white world that lie on the piece itself."""
        view = self._whole.white_view()
        return None if view is None else self._on_piece(view)

    def _on_piece(self, view: View) -> View:
        on = self._seams.piece_at(view.samples["position"], view.samples["wo"]) == self._number
        samples = {name: rows[on] for name, rows in view.samples.items()}
        return replace(view, pixel=view.pixel[on], samples=samples, halves=view.halves[:, on])


class _Seams:
    """The pieces of one surface, and which of them a captured point lies on."""

    def __init__(self, meshes: list[Mesh]):
        self.meshes = meshes
        self._scene = PartsScene(meshes)
        corners = np.concatenate([mesh.positions for mesh in meshes])
        self._step = np.float32(_STEP * np.ptp(corners, axis=0).max())

    def piece_at(self, position: np.ndarray, wo: np.ndarray) -> np.ndarray:
        """(n,) int32, the piece that rays along -wo meet at positions (n, 3); 0 if none does."""
        hits = self._scene.intersect(position + self._step * wo, -wo)
        return np.asarray(np.maximum(hits.geometry, 0))


def _with_margin(
    seams: _Seams, number: int, whole: DatasetPart
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """The box of a piece with a margin, within the box of the whole surface."""
    low, high = seams.meshes[number].box()
    margin = _MARGIN * (high - low).max()
    least, most = np.array(whole.bounds, np.float32)
    low, high = np.maximum(low - margin, least), np.minimum(high + margin, most)
    return tuple(low.tolist()), tuple(high.tolist())


def _within(captured: CapturedPart, triangles: np.ndarray) -> dict[str, Any]:
    """Base colour and variants of some triangles of a part, whose numbers grow, by member."""
    records, numbers = [], []
    for k, record in enumerate(captured.base_color):
        first, count = record.triangles
        low, high = np.searchsorted(triangles, [first, first + count]).tolist()
        if high > low:
            records.append(record.model_copy(update={"triangles": (low, high - low)}))
            numbers.append(k)
    changes = (captured.changes(k) for k in range(len(captured.variants)))
    variants = tuple(tuple(of_variant[k] for k in numbers) for of_variant in changes)
    return {"base_color": tuple(records), "variants": variants}


def cut_triangles(mesh: Mesh, pieces: int) -> list[np.ndarray]:
    """Numbers of the triangles of each piece: of equal area, cut across the longest sides."""
    corners = mesh.positions[mesh.triangles].astype(np.float64)
    area = np.maximum(trimesh.triangles.area(corners), 1e-30)
    return _halved(np.arange(len(corners)), corners, area, pieces)


def _halved(
    triangles: np.ndarray, corners: np.ndarray, area: np.ndarray, pieces: int
) -> list[np.ndarray]:
    if pieces == 1:
        return [triangles]
    triangle_corners = corners[triangles]
    axis = int(np.argmax(np.ptp(triangle_corners.reshape(-1, 3), axis=0)))
    order = np.argsort(triangle_corners[:, :, axis].mean(axis=1), kind="stable")
    first = pieces // 2
    until = np.cumsum(area[triangles][order])
    count = int(np.searchsorted(until, until[-1] * first / pieces))
    count = int(np.clip(count, first, len(triangles) - (pieces - first)))
    halves = (order[:count], first), (order[count:], pieces - first)
    return [p for half, n in halves for p in _halved(np.sort(triangles[half]), corners, area, n)]


def _taken(mesh: Mesh, triangles: np.ndarray) -> Mesh:
    """These triangles alone; quantised as the whole is, so that the vertices of seams are equal."""
    used, index = np.unique(mesh.triangles[triangles], return_inverse=True)
    local = index.reshape(-1, 3).astype(np.uint32)
    stored = mesh if mesh.quantised is None else mesh.quantised
    uvs = None if stored.uvs is None else stored.uvs[used]
    arrays = {
        "positions": stored.positions[used],
        "normals": stored.normals[used],
        "uvs": uvs,
        "triangles": local,
    }
    if isinstance(stored, QuantisedMesh):
        return replace(stored, **arrays).restored()
    return Mesh(**arrays)
