"""One part of a dataset: the samples that a model is trained on."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import numpy as np
from safetensors import SafetensorError
from safetensors.numpy import load_file

from rna_export.capture.dataset.dataset_manifest import (
    BASE_COLOR,
    CapturedPart,
    CaptureManifest,
    emission_fields,
    white_fields,
)
from rna_export.capture.dataset.nearby_rows import of_image
from rna_export.capture.dataset.sample_files import DAMAGED, damaged, joined, read_part
from rna_export.capture.dataset.validation_view import EmissionView, ValidationView, WhiteView
from rna_export.capture.geometry.stored_geometry import (
    exact_from_arrays,
    geometry_from_arrays,
    source_from_arrays,
)
from rna_sdk.errors import CaptureError, PackageError
from rna_sdk.package import BaseColor, Curves, Mesh, SourceVertices
from rna_sdk.package.geometry.curves_file import check_curves
from rna_sdk.package.geometry.glb_reader import check_mesh
from rna_sdk.package.manifest.extensions import changed_record
from rna_sdk.package.manifest.manifest_model import (
    BaseColorFields,
    NormalMapRecord,
    TransmittanceRecord,
)
from rna_sdk.package.textures.base_color import image_from_bytes
from rna_sdk.package.textures.normal_maps import NORMALS, NormalMap
from rna_sdk.package.textures.transmittance import Transmittance, texture_from_bytes

if TYPE_CHECKING:
    from rna_export.capture.dataset.dataset_folder import Dataset

T = TypeVar("T")
View = TypeVar("View", ValidationView, EmissionView, WhiteView)

_SHARED = 0.95  # of the pixels of a half, at least, that the other one has, too
_MARGIN = 0.1  # of a part's longest side
_LEAST_SHARE = 1 / 500  # of an image's pixels; fewer say nothing of a part


class DatasetPart:
    """The samples, images and geometry of one part.

    Attributes:
        dataset: that it is a part of.
        captured: what the manifest says of it.
        name, kind, bounds, fields: see `CapturedPart`.
    """

    def __init__(self, dataset: Dataset, part: CapturedPart):
        self.dataset, self.captured = dataset, part
        self.name, self.kind = part.name, part.kind
        self.bounds, self.fields = part.bounds, dataset.manifest.fields(part)

    @property
    def folder(self) -> Path:
        """Folder of the dataset."""
        return self.dataset.folder

    @property
    def manifest(self) -> CaptureManifest:
        """Manifest of the dataset."""
        return self.dataset.manifest

    def geometry(self) -> Mesh | Curves:
        """The captured mesh, or the strands: object space, +Y up, metres."""
        geometry = self._read_geometry(self._checked_geometry)
        path = self.dataset.geometry_path(self.name)
        self._check_places(path, np.array(geometry.box()))
        return geometry

    def met_by_rays(self) -> Mesh | Curves:
        """The geometry as Cycles has it, which quantisation of `geometry` would move.

        A highlight of roughness 0.02 is 0.0004 radians wide; normals at the hits of a quantised
        bevel are wrong by more (docs/decisions/capture.md).
        """
        exact = self._read_geometry(exact_from_arrays)
        return self.geometry() if exact is None else exact

    def _checked_geometry(self, arrays: dict[str, np.ndarray]) -> Mesh | Curves:
        """Geometry that a package can hold; raises TypeError and PackageError for others."""
        geometry = geometry_from_arrays(arrays, self.kind)
        if isinstance(geometry, Mesh):
            check_mesh(geometry, "/geometry")
        else:
            check_curves(geometry, "/geometry")
        return geometry

    def _check_places(self, path: Path, places: np.ndarray) -> None:
        """Raises CaptureError for points (n, 3) that are far outside of the part's bounds."""
        low, high = np.array(self.bounds)
        margin = _MARGIN * (high - low).max()
        if not ((places >= low - margin) & (places <= high + margin)).all():
            raise CaptureError(DAMAGED.format(path, f"outside of the bounds of part {self.name}"))

    def source_vertices(self) -> SourceVertices | None:
        """The source's vertex of each of the mesh's vertices; None where they are not known."""
        return self._read_geometry(source_from_arrays)

    def _read_geometry(self, of: Callable[[dict[str, np.ndarray]], T]) -> T:
        path = self.dataset.geometry_path(self.name)
        try:
            return of(load_file(path))
        except (OSError, TypeError, KeyError, SafetensorError, PackageError) as error:
            raise CaptureError(DAMAGED.format(path, error)) from error

    def positions(self, frame: int) -> np.ndarray:
        """(v, 3) float32, where the vertices are in a pose that rays are captured in."""
        path = self.dataset.pose_path(frame)
        try:
            return load_file(path)[self.name]
        except (OSError, KeyError, SafetensorError) as error:
            raise CaptureError(DAMAGED.format(path, error)) from error

    def transmittance(self) -> tuple[Transmittance, ...]:
        """Transmittance of its triangles; empty for an opaque part."""
        return tuple(
            Transmittance(*record.triangles, self._texture(record), record.cutoff, record.ior)
            for record in self.captured.transmittance
        )

    def normal_maps(self) -> tuple[NormalMap, ...]:
        """The relief of its triangles; none of a part without."""
        return tuple(
            NormalMap(*record.triangles, self._map(record)) for record in self.captured.normal_maps
        )

    def base_color(self, variant: int | None = None) -> tuple[BaseColor, ...]:
        """Base colour of its triangles, the source's own or a variant's; none of a part without."""
        records = self.captured.base_color
        if variant is not None:
            pairs = zip(records, self.captured.changes(variant), strict=True)
            records = tuple(changed_record(record, change) for record, change in pairs)
        images = {
            name: self._read_texture(name, partial(image_from_bytes, name=name))
            for name in _image_names(records)
        }
        return tuple(
            BaseColor.of(record, None if record.image is None else images[record.image])
            for record in records
        )

    def base_color_files(self) -> dict[str, bytes]:
        """The files of the images of its base colour, by the names in their records."""
        names = _image_names(self.captured.base_color)
        return {name: self._read_texture(name, bytes) for name in names}

    def variant_files(self) -> dict[str, bytes]:
        """The files of images that variants alone have, by the names in their records."""
        changes = [one for variant in self.captured.variants for one in variant]
        names = _image_names([one for one in changes if one is not None])
        shared = _image_names(self.captured.base_color)
        return {name: self._read_texture(name, bytes) for name in names if name not in shared}

    def textures(self) -> dict[str, np.ndarray]:
        """Textures of transmittance and normal maps, by the names in their records."""
        textures = {record.texture: self._texture(record) for record in self.captured.transmittance}
        maps = {record.texture: self._map(record) for record in self.captured.normal_maps}
        return {**textures, **maps}

    def _texture(self, record: TransmittanceRecord) -> np.ndarray:
        return self._read_texture(record.texture, lambda data: texture_from_bytes(data, record))

    def _map(self, record: NormalMapRecord) -> np.ndarray:
        return self._read_texture(
            record.texture, lambda data: NORMALS.from_bytes(data, record.texture)
        )

    def _read_texture(self, name: str, parse: Callable[[memoryview], T]) -> T:
        path = self.folder / name
        try:
            return parse(memoryview(path.read_bytes()))
        except (OSError, PackageError) as error:
            raise CaptureError(DAMAGED.format(path, error)) from error

    def training_samples(self, shards: int | None = None) -> dict[str, np.ndarray]:
        """The part's rows of the finished shards joined, one array a field.

        shards: take so many at most, spread over all; None takes all.
        """
        paths = self.dataset.finished_shards()
        if shards is not None:
            paths = paths[:: -(-len(paths) // shards)]
        return self.samples_of(paths)

    def samples_of(self, paths: Iterable[Path]) -> dict[str, np.ndarray]:
        """The part's rows of these shards joined, one array a field."""
        samples = joined([self._read(path, self.fields) for path in paths])
        if not len(samples["visible"]):
            raise CaptureError(f"{self.folder}: no view ray met part {self.name}")
        return samples

    def emission_samples(self) -> dict[str, np.ndarray]:
        """The part's samples of emission, one array per field of `emission_fields`."""
        paths = self.dataset.finished_emission()
        return joined([self._read(path, emission_fields(self.kind)) for path in paths])

    def emission_views(self) -> list[EmissionView]:
        """The finished images of emission; the part may have no row in them."""
        fields = emission_fields(self.kind)
        return [
            self._view(EmissionView, index, self.dataset.emission_image_path, fields)
            for index in range(self.manifest.emission_images)
        ]

    def _read(self, path: Path, fields: Mapping[str, int]) -> dict[str, np.ndarray]:
        """Rows of a file, float32; a visibility with colours from 0 to 1, (n, 3)."""
        rows = read_part(path, self.name, fields)
        self._check_places(path, rows["position"])
        if "visible" in rows and rows["visible"].ndim == 2:
            rows["visible"] = rows["visible"].astype(np.float32) / np.float32(255.0)
        if BASE_COLOR in rows:
            rows[BASE_COLOR] = rows[BASE_COLOR].astype(np.float32)
        return rows

    def validation_views(self) -> list[ValidationView]:
        """The finished validation images that show the part in more than a few pixels."""
        views = [self.view(index) for index in self.dataset.finished_views()]
        views = [v for v in views if len(v.pixel) > _LEAST_SHARE * v.resolution**2]
        if not views:
            raise CaptureError(
                f"{self.folder}: no validation image shows part {self.name} in more than a few "
                "pixels: hide it from renders or join it to another object"
            )
        return views

    def view(self, index: int) -> ValidationView:
        """The part in one validation image; it may have no row there."""
        return self._view(ValidationView, index, self.dataset.validation_path, self.fields)

    def white_view(self) -> WhiteView | None:
        """The part's samples in a white world; None of a dataset that has none."""
        path = self.dataset.white_path
        if not path.is_file():
            return None
        samples = self._read(path, white_fields(self.fields))
        rows = np.arange(len(samples["weight"]), dtype=np.int32)
        halves = samples["radiance"][None]
        return WhiteView(0, len(rows), rows, samples, halves, self._trace_nearby)

    def _view(
        self,
        kind: type[View],
        index: int,
        path_of: Callable[[int, int], Path],
        fields: Mapping[str, int],
    ) -> View:
        paths = [path_of(index, half) for half in (0, 1)]
        first, second = (self._read(p, {**fields, "pixel": 1}) for p in paths)
        # Where a ray just misses in Cycles and meets glass, alpha is noise: one half may lack it.
        pixel, *rows = np.intersect1d(first["pixel"], second["pixel"], return_indices=True)
        resolution = self.manifest.settings.validation_resolution
        there = (pixel >= 0) & (pixel < resolution**2)
        if pixel.dtype.kind not in "iu" or not there.all():
            raise damaged(paths[0], f"pixels that an image of {resolution} has not")
        if len(pixel) < _SHARED * max(len(first["pixel"]), len(second["pixel"])):
            raise damaged(paths[1], "its pixels differ from the pixels of the first half")
        halves = np.stack([first["radiance"][rows[0]], second["radiance"][rows[1]]])
        samples = {name: first[name][rows[0]] for name in fields}
        samples["radiance"] = halves.mean(axis=0)
        return kind(index, resolution, pixel, samples, halves, self._trace_nearby)

    def _trace_nearby(
        self, samples: dict[str, np.ndarray], lengths: tuple[float, ...]
    ) -> np.ndarray:
        return of_image(samples, self, lengths)


def _image_names(records: Iterable[BaseColorFields]) -> list[str]:
    names = (record.image for record in records)
    return [name for name in dict.fromkeys(names) if name is not None]
