"""A dataset of captured rays: a folder with a manifest, the geometry, shards and whole images.

toy.rays/
  manifest.json               settings, source, what is planned
  geometry.safetensors        the mesh or the strands, object space
  train/00000.safetensors     samples of some lights
  validation/00-0.safetensors one half (of two seeds) of one whole image
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from safetensors import SafetensorError
from safetensors.numpy import load_file, save

from rna_export.capture.settings import CaptureSettings, DatasetModel
from rna_sdk.errors import CaptureError, PackageError
from rna_sdk.package import Curves, Domain, Mesh
from rna_sdk.runtime import Asset

SAMPLE_FIELDS: dict[str, dict[str, int]] = {
    "surface": {"position": 3, "normal": 3, "wo": 3, "wi": 3, "radiance": 3, "visible": 1},
    "fiber": {
        "position": 3,
        "tangent": 3,
        "h": 1,
        "wo": 3,
        "wi": 3,
        "radiance": 3,
        "direct": 3,  # the part of the radiance that scattered once; it has no noise
        "visible": 1,
    },
}
"""Kind of asset -> what a sample holds, with its number of columns."""

_NO_QUERY = ("radiance", "direct", "visible", "pixel")


class CaptureManifest(DatasetModel):
    """`manifest.json` of a dataset."""

    name: str
    kind: Literal["surface", "fiber"]
    source: str
    source_sha256: str
    arguments: tuple[str, ...] = ()
    settings: CaptureSettings
    blender: str
    generator: str
    cutouts: bool  # the asset has see-through parts: a hit with alpha below 1 is a sample, too
    bounds: tuple[tuple[float, float, float], tuple[float, float, float]]
    notes: tuple[str, ...] = ()
    scene_domain: Domain | None = None  # of --for; in the place of settings.domain

    @property
    def domain(self) -> Domain:
        """Directions of all samples."""
        everywhere = self.settings.domain
        return self.scene_domain or Domain(wo=everywhere, wi=everywhere)

    @property
    def fields(self) -> dict[str, int]:
        """What a sample holds: see SAMPLE_FIELDS."""
        return SAMPLE_FIELDS[self.kind]

    @property
    def shards(self) -> int:
        return -(-self.settings.lights // self.settings.lights_per_shard)


@dataclass(frozen=True)
class ValidationView:
    """One captured image under one light; rows are the pixels that hit the asset."""

    index: int
    resolution: int
    pixel: np.ndarray  # (n,) int32, row * resolution + column
    samples: dict[str, np.ndarray]  # fields of SAMPLE_FIELDS; radiance is the mean of both halves
    halves: np.ndarray  # (2, n, 3) float32, two independent estimates of radiance

    @property
    def queries(self) -> dict[str, np.ndarray]:
        """What a model is asked, by name, in the order of `evaluate`'s arguments."""
        return queries_of(self.samples)

    def pick(self, visible: np.ndarray, shadowed: np.ndarray) -> np.ndarray:
        """Of a model's two outputs, (n, 3) each, the one that each row's visibility calls for."""
        return np.where(self.samples["visible"].astype(bool)[:, None], visible, shadowed)

    def shaded_by(self, asset: Asset) -> np.ndarray:
        """Radiance of the rows, (n, 3) float32, as the runtime answers."""
        return self.pick(*asset.evaluate(*self.queries.values()))

    def image(self, values: np.ndarray) -> np.ndarray:
        """Rows (n, 3) as an image (resolution, resolution, 3), zero off the asset."""
        image = np.zeros((self.resolution**2, 3), np.float32)
        image[self.pixel] = values
        return image.reshape(self.resolution, self.resolution, 3)


def queries_of(samples: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The part of captured samples that is asked; the rest is what it should be answered with."""
    return {name: rows for name, rows in samples.items() if name not in _NO_QUERY}


def all_queries(views: list[ValidationView]) -> list[np.ndarray]:
    """The arguments of `evaluate` for every pixel of the images."""
    parts = zip(*(view.queries.values() for view in views), strict=True)
    return [np.concatenate(part) for part in parts]


class Dataset:
    """A dataset folder, complete or not. Raises `CaptureError` when it is not one."""

    def __init__(self, folder: Path):
        self.folder = Path(folder)
        path = self.folder / "manifest.json"
        if not path.is_file():
            raise CaptureError(f"{self.folder}: not a dataset, it has no manifest.json")
        try:
            self.manifest = CaptureManifest.model_validate_json(path.read_bytes())
        except ValueError as error:
            raise CaptureError(f"{path}: {error}") from error

    @classmethod
    def create(cls, folder: Path, manifest: CaptureManifest, geometry: Mesh | Curves) -> Dataset:
        """Write geometry and manifest, the manifest last: a folder with one is a dataset."""
        folder = Path(folder)
        for part in (folder / "train", folder / "validation"):
            part.mkdir(parents=True, exist_ok=True)
        arrays = {k: v for k, v in vars(geometry).items() if v is not None}
        write_arrays(folder / "geometry.safetensors", arrays)
        _write_manifest(folder, manifest)
        return cls(folder)

    def geometry(self) -> Mesh | Curves:
        """The captured mesh, or the strands: object space, +Y up, metres."""
        path = self.folder / "geometry.safetensors"
        try:
            arrays = load_file(path)
            if self.manifest.kind == "fiber":
                return Curves(**arrays)
            return Mesh(**{"uvs": None, **arrays})
        except (OSError, TypeError, SafetensorError, PackageError) as error:
            raise CaptureError(_DAMAGED.format(path, error)) from error

    def lights_finished(self) -> int:
        """From the first one on, without a gap."""
        settings = self.manifest.settings
        shards = 0
        while shards < self.manifest.shards and self.train_path(shards).is_file():
            shards += 1
        return min(shards * settings.lights_per_shard, settings.lights)

    def leave_out_lights_from(self, light: int) -> None:
        """Shorten the plan to the lights before this one."""
        settings = self.manifest.settings.model_copy(update={"lights": light})
        self.manifest = self.manifest.model_copy(update={"settings": settings})
        _write_manifest(self.folder, self.manifest)

    def train_path(self, shard: int) -> Path:
        return self.folder / "train" / f"{shard:05d}.safetensors"

    def validation_path(self, view: int, half: int) -> Path:
        return self.folder / "validation" / f"{view:02d}-{half}.safetensors"

    def training_samples(self, shards: int | None = None) -> dict[str, np.ndarray]:
        """The finished shards joined, one array a field of `manifest.fields`.

        shards: take so many at most, spread over all; None takes all.
        """
        paths = [p for k in range(self.manifest.shards) if (p := self.train_path(k)).is_file()]
        if not paths:
            raise CaptureError(f"{self.folder}: no finished training shard")
        if shards is not None:
            paths = paths[:: -(-len(paths) // shards)]
        return joined([_read_arrays(path, self.manifest.fields) for path in paths])

    def validation_views(self) -> list[ValidationView]:
        """The finished validation images."""
        count = self.manifest.settings.validation_views
        views = [self._view(k) for k in range(count) if self._view_is_finished(k)]
        if not views:
            raise CaptureError(f"{self.folder}: no finished validation image")
        return views

    def _view_is_finished(self, view: int) -> bool:
        return all(self.validation_path(view, half).is_file() for half in (0, 1))

    def _view(self, view: int) -> ValidationView:
        names = (*self.manifest.fields, "pixel")
        first, second = (_read_arrays(self.validation_path(view, h), names) for h in (0, 1))
        if not np.array_equal(first["pixel"], second["pixel"]):
            path = self.validation_path(view, 1)
            reason = "its pixels are not those of the first half"
            raise CaptureError(_DAMAGED.format(path, reason) + _MADE_AGAIN)
        halves = np.stack([first["radiance"], second["radiance"]])
        samples = {name: first[name] for name in self.manifest.fields}
        samples["radiance"] = halves.mean(axis=0)
        resolution = self.manifest.settings.validation_resolution
        return ValidationView(view, resolution, first["pixel"], samples, halves)


def _write_manifest(folder: Path, manifest: CaptureManifest) -> None:
    text = json.dumps(manifest.model_dump(mode="json", by_alias=True), indent=1) + "\n"
    write_atomically(folder / "manifest.json", text.encode())


def joined(parts: list[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    """The rows of all parts, one array a field."""
    return {name: np.concatenate([p[name] for p in parts]) for name in parts[0]}


def _read_arrays(path: Path, names: Iterable[str]) -> dict[str, np.ndarray]:
    """The named arrays of a part, as many rows each. Raises CaptureError if it is damaged."""
    try:
        arrays = load_file(path)
    except (OSError, SafetensorError) as error:
        raise CaptureError(_DAMAGED.format(path, error) + _MADE_AGAIN) from error
    missing = [name for name in names if name not in arrays]
    lengths = {len(values) for values in arrays.values()}
    if missing or len(lengths) > 1:
        reason = f"no {', '.join(missing)}" if missing else "its arrays differ in length"
        raise CaptureError(_DAMAGED.format(path, reason) + _MADE_AGAIN)
    return {name: arrays[name] for name in names}


_DAMAGED = "{}: damaged ({})"
_MADE_AGAIN = "; delete it, and the same rna-capture makes it again"


def write_arrays(path: Path, arrays: dict[str, np.ndarray]) -> None:
    """Save as safetensors; the file appears whole or not at all."""
    write_atomically(path, save({k: np.ascontiguousarray(v) for k, v in arrays.items()}))


def write_atomically(path: Path, data: bytes) -> None:
    """Write under a temporary name, then rename."""
    temporary = path.with_name(path.name + f".{os.getpid()}.part")
    temporary.write_bytes(data)
    temporary.replace(path)
