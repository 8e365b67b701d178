"""A dataset of captured rays: a folder with a manifest, the geometry, shards and whole images.

toy.rays/
  manifest.json               settings, source, what is planned
  geometry.safetensors        the mesh, object space
  train/00000.safetensors     samples of some lights
  validation/00-0.safetensors one half (of two seeds) of one whole image
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from pydantic import BaseModel, ConfigDict, Field
from pydantic.alias_generators import to_camel
from safetensors.numpy import load_file, save

from rna_export.capture.worker import CLAMP_DIRECT, CLAMP_INDIRECT
from rna_sdk.errors import CaptureError
from rna_sdk.package import Mesh

SAMPLE_FIELDS = ("position", "normal", "wo", "wi", "radiance", "visible")


class _Model(BaseModel):
    model_config = ConfigDict(
        extra="forbid", frozen=True, alias_generator=to_camel, populate_by_name=True
    )


class CaptureSettings(_Model):
    """What was asked for; with the source, enough to repeat the capture."""

    samples: int = Field(16, gt=0, description="paths a view ray")
    rays: int = Field(4096, gt=0, description="view rays a light direction")
    lights: int = Field(2000, gt=0, description="light directions, one small render each")
    domain: str = Field("sphere", pattern="^(sphere|hemisphere)$", description="of wo and of wi")
    clamp_direct: float = Field(
        CLAMP_DIRECT, description="Cycles' clamp of direct light (the paper's)"
    )
    clamp_indirect: float = Field(CLAMP_INDIRECT, description="Cycles' clamp of indirect light")
    validation_views: int = Field(8, ge=1, description="whole images kept from training")
    validation_resolution: int = Field(160, gt=0, description="their width and height, pixels")
    validation_samples: int = Field(512, ge=2, description="paths a pixel, in two halves")
    lights_per_shard: int = Field(32, gt=0, description="what a stop can lose at most")
    seed: int = 0


class CaptureManifest(_Model):
    """`manifest.json` of a dataset."""

    name: str
    source: str
    source_sha256: str
    arguments: tuple[str, ...] = ()
    settings: CaptureSettings
    blender: str
    generator: str
    has_uv: bool
    cutouts: bool  # the asset has see-through parts: a hit with alpha below 1 is a sample, too
    bounds: tuple[tuple[float, float, float], tuple[float, float, float]]
    notes: tuple[str, ...] = ()

    @property
    def shards(self) -> int:
        return -(-self.settings.lights // self.settings.lights_per_shard)


@dataclass(frozen=True)
class ValidationView:
    """One captured image under one light; rows are the pixels that hit the asset."""

    index: int
    resolution: int
    pixel: np.ndarray  # (n,) int32, row * resolution + column
    samples: dict[str, np.ndarray]  # as SAMPLE_FIELDS; radiance is the mean of both halves
    halves: np.ndarray  # (2, n, 3) float32, two independent estimates of radiance

    def pick(self, visible: np.ndarray, shadowed: np.ndarray) -> np.ndarray:
        """Of a model's two outputs, (n, 3) each, the one that each row's visibility calls for."""
        return np.where(self.samples["visible"].astype(bool)[:, None], visible, shadowed)

    def image(self, values: np.ndarray) -> np.ndarray:
        """Rows (n, 3) as an image (resolution, resolution, 3), zero off the asset."""
        image = np.zeros((self.resolution**2, 3), np.float32)
        image[self.pixel] = values
        return image.reshape(self.resolution, self.resolution, 3)


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
    def create(cls, folder: Path, manifest: CaptureManifest, mesh: Mesh) -> Dataset:
        """Write geometry and manifest, the manifest last: a folder with one is a dataset."""
        folder = Path(folder)
        for part in (folder / "train", folder / "validation"):
            part.mkdir(parents=True, exist_ok=True)
        arrays = {"positions": mesh.positions, "normals": mesh.normals, "triangles": mesh.triangles}
        if mesh.uvs is not None:
            arrays["uvs"] = mesh.uvs
        write_arrays(folder / "geometry.safetensors", arrays)
        text = json.dumps(manifest.model_dump(mode="json", by_alias=True), indent=1) + "\n"
        write_atomically(folder / "manifest.json", text.encode())
        return cls(folder)

    def mesh(self) -> Mesh:
        """The captured geometry, object space, +Y up, metres."""
        arrays = load_file(self.folder / "geometry.safetensors")
        uvs = arrays.get("uvs")
        return Mesh(arrays["positions"], arrays["normals"], uvs, arrays["triangles"])

    def train_path(self, shard: int) -> Path:
        return self.folder / "train" / f"{shard:05d}.safetensors"

    def validation_path(self, view: int, half: int) -> Path:
        return self.folder / "validation" / f"{view:02d}-{half}.safetensors"

    def training_samples(self) -> dict[str, np.ndarray]:
        """All finished shards joined, one array a field of SAMPLE_FIELDS."""
        paths = [p for k in range(self.manifest.shards) if (p := self.train_path(k)).is_file()]
        if not paths:
            raise CaptureError(f"{self.folder}: no finished training shard")
        return joined([load_file(path) for path in paths], SAMPLE_FIELDS)

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
        first, second = (load_file(self.validation_path(view, half)) for half in (0, 1))
        halves = np.stack([first["radiance"], second["radiance"]])
        samples = {name: first[name] for name in SAMPLE_FIELDS} | {"radiance": halves.mean(axis=0)}
        resolution = self.manifest.settings.validation_resolution
        return ValidationView(view, resolution, first["pixel"], samples, halves)


def joined(
    parts: list[dict[str, np.ndarray]], names: Iterable[str] | None = None
) -> dict[str, np.ndarray]:
    """The rows of all parts, one array a field; of `names` only, if given."""
    return {name: np.concatenate([p[name] for p in parts]) for name in names or parts[0]}


def write_arrays(path: Path, arrays: dict[str, np.ndarray]) -> None:
    """Save as safetensors; the file appears whole or not at all."""
    write_atomically(path, save({k: np.ascontiguousarray(v) for k, v in arrays.items()}))


def write_atomically(path: Path, data: bytes) -> None:
    """Write under a temporary name, then rename."""
    temporary = path.with_name(path.name + f".{os.getpid()}.part")
    temporary.write_bytes(data)
    temporary.replace(path)
