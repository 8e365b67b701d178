"""A dataset of captured rays: a folder with a manifest, the geometry, shards and whole images.

toy.rays/
  manifest.json               parts, settings, source, what is planned
  files.json                  SHA-256 of the files below, once a capture has finished
  geometry/NAME.safetensors   the mesh or the strands of a part, object space
  poses/00012.safetensors     positions of the parts at a frame of the source, arrays NAME
  transmittance/0.safetensors texture of a material that lets light through, as in a package
  normals/0.safetensors       normal map of a material, as in a package
  base_color/paper.png        image of a material's base colour, or .jpg, .webp
  glass.glb                   smooth glass that is left to hosts, if there is any
  materials.safetensors       material of each triangle, arrays NAME, numbers of the manifest's
  train/00000.safetensors     samples of some lights, arrays NAME/FIELD
  emission/00000.safetensors  samples of what the asset emits, if it does
  validation/00-0.safetensors one half (of two seeds) of one whole image, likewise
  validation/white.safetensors samples in a white world, which albedo is measured with
  nearby/1f0c.safetensors     nearby light of some rows, which trainings trace and keep
"""

import hashlib
from collections.abc import Iterable, Mapping
from functools import cached_property
from pathlib import Path

import numpy as np
from pydantic import ValidationError
from safetensors import SafetensorError
from safetensors.numpy import load_file

from rna_export.capture.dataset.dataset_manifest import CaptureManifest, what_is_wrong
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.sample_files import DAMAGED, rows_of, write_arrays
from rna_export.capture.dataset.validation_view import WholeView
from rna_export.capture.geometry.stored_geometry import geometry_arrays
from rna_sdk.errors import CaptureError
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.package import Curves, Mesh, SourceVertices
from rna_sdk.package.textures.normal_maps import NORMALS
from rna_sdk.package.textures.transmittance import TRANSMITTANCE
from rna_trace import PartsScene, mesh_transmittance

_MADE = ("geometry", "transmittance", "normals", "base_color", "train", "emission", "validation")
FOLDERS = (*_MADE, "poses")
"""Folders of a dataset, of which some have no poses."""


class Dataset:
    """A dataset folder, complete or not. Raises `CaptureError` when it is not one.

    Attributes:
        cut: of each surface, how many parts are made: see `rna_export.capture.geometry.cut`.
    """

    cut = 1

    def __init__(self, folder: Path):
        self.folder = Path(folder)
        path = self.folder / "manifest.json"
        if not path.is_file():
            raise CaptureError(f"{self.folder}: not a dataset, it has no manifest.json")
        try:
            self.manifest = CaptureManifest.model_validate_json(path.read_bytes())
        except ValidationError as error:
            raise CaptureError(f"{path}: {what_is_wrong(error)}") from error

    @classmethod
    def create(
        cls,
        folder: Path,
        manifest: CaptureManifest,
        geometries: Mapping[str, Mesh | Curves],
        textures: Mapping[str, np.ndarray | bytes] | None = None,
        poses: Mapping[int, Mapping[str, np.ndarray]] | None = None,
        sources: Mapping[str, SourceVertices] | None = None,
        glass: bytes | None = None,
        exact: Mapping[str, Mesh] | None = None,
        materials: Mapping[str, np.ndarray] | None = None,
    ) -> "Dataset":
        """Write geometry and textures, and the manifest, that last: with one it is a dataset.

        geometries: of each part. textures: by the names that records have, the texels of all
        transmittance and normal maps, and the files of images of base colour.
        poses: by frame, except the rest frame: positions of each part, (v, 3) float32.
        sources: vertices of the source, of those parts that have any. glass: a .glb of the glass
        that is left to hosts. exact: meshes before they were quantised, of parts that were.
        materials: of each surface, (t,) int16, places of its triangles' materials in those of the
        manifest; -1 for none.
        """
        folder = Path(folder)
        for inner in _MADE:
            (folder / inner).mkdir(parents=True, exist_ok=True)
        for name, texture in (textures or {}).items():
            if not isinstance(texture, bytes):
                form = NORMALS if name.startswith("normals/") else TRANSMITTANCE
                texture = form.to_bytes(texture, name)
            (folder / name).parent.mkdir(parents=True, exist_ok=True)  # of variants
            write_atomically(folder / name, texture)
        for name, geometry in geometries.items():
            arrays = geometry_arrays(
                geometry, source=(sources or {}).get(name), exact=(exact or {}).get(name)
            )
            write_arrays(_geometry_path(folder, name), arrays)
        for frame, parts in (poses or {}).items():
            (folder / "poses").mkdir(exist_ok=True)
            write_arrays(_pose_path(folder, frame), parts)
        if glass is not None:
            write_atomically(_glass_path(folder), glass)
        if materials:
            write_arrays(_materials_path(folder), materials)
        manifest.write(folder / "manifest.json")
        return cls(folder)

    @cached_property
    def parts(self) -> tuple[DatasetPart, ...]:
        """The parts, in the order that the package has them."""
        return tuple(DatasetPart(self, part) for part in self.manifest.parts)

    @cached_property
    def scene(self) -> PartsScene:
        """All parts at rest, for rays."""
        geometries = [part.geometry() for part in self.parts]
        records = [part.transmittance() for part in self.parts]
        return PartsScene(geometries, list(map(mesh_transmittance, geometries, records)))

    @cached_property
    def geometry_digest(self) -> str:
        """Digest of the files of all geometry and transmittance."""
        digest = hashlib.sha256()
        for folder in ("geometry", "transmittance"):
            for path in sorted((self.folder / folder).glob("*.safetensors")):
                digest.update(path.name.encode() + path.read_bytes())
        return digest.hexdigest()

    @property
    def only(self) -> DatasetPart:
        """The part of an asset that has one. Raises `CaptureError` for one that has several."""
        if len(self.parts) > 1:
            names = ", ".join(part.name for part in self.parts)
            raise CaptureError(f"{self.folder}: found parts {names}; expected an asset of one part")
        return self.parts[0]

    def part(self, name: str) -> DatasetPart:
        """The part of this name. Raises `CaptureError` if there is none."""
        for part in self.parts:
            if part.name == name:
                return part
        names = ", ".join(part.name for part in self.parts)
        raise CaptureError(f"{self.folder}: found no part {name!r}, expected one of {names}")

    @property
    def materials(self) -> dict[str, np.ndarray]:
        """Material of each triangle by surface: see `create`. None for older datasets."""
        path = _materials_path(self.folder)
        try:
            return load_file(path) if path.is_file() else {}
        except (OSError, SafetensorError) as error:
            raise CaptureError(DAMAGED.format(path, error)) from error

    @property
    def glass(self) -> bytes | None:
        """A .glb of the glass that is left to hosts; None for none."""
        path = _glass_path(self.folder)
        return path.read_bytes() if path.is_file() else None

    def whole_views(self) -> list[WholeView]:
        """The finished validation images, each of all parts together."""
        return [WholeView(tuple(p.view(k) for p in self.parts)) for k in self.finished_views()]

    def lights_finished(self) -> int:
        """Number of captured lights before the first gap."""
        settings = self.manifest.settings
        shards = 0
        while shards < self.manifest.shards and self.train_path(shards).is_file():
            shards += 1
        return min(shards * settings.lights_per_shard, settings.lights)

    def used_rays(self) -> int:
        """Samples of the finished training shards, of all parts."""
        shards = [p for k in range(self.manifest.shards) if (p := self.train_path(k)).is_file()]
        return sum(rows_of(p, part.name, "wo") for p in shards for part in self.manifest.parts)

    def rays_captured(self) -> int:
        """View rays of the finished training shards, used or not."""
        settings = self.manifest.settings
        lights = 0
        for k in range(self.manifest.shards):
            if self.train_path(k).is_file():
                first = k * settings.lights_per_shard
                lights += min(settings.lights_per_shard, settings.lights - first)
        return lights * settings.rays

    def plan_lights(self, lights: int) -> None:
        """Change the planned number of lights; those captured already stay the same."""
        self.change_settings({"lights": lights})

    def change_settings(self, changes: Mapping[str, int | float]) -> None:
        """Change settings of files that are not captured yet."""
        settings = self.manifest.settings.model_copy(update=dict(changes))
        self.manifest = self.manifest.model_copy(update={"settings": settings})
        self.manifest.write(self.folder / "manifest.json")

    def remove_unfinished(self) -> None:
        """Delete the unfinished files of a killed capture, by their temporary names."""
        for folder in FOLDERS:
            for path in (self.folder / folder).glob("*.safetensors.*.part"):
                path.unlink(missing_ok=True)

    def record_processors(self, keys: Iterable[str]) -> None:
        """Note in the manifest which processors rendered, by `rna_sdk.machine.cpu`."""
        processors = tuple(sorted({*self.manifest.processors, *keys}))
        if processors != self.manifest.processors:
            self.manifest = self.manifest.model_copy(update={"processors": processors})
            self.manifest.write(self.folder / "manifest.json")

    def geometry_path(self, part: str) -> Path:
        return _geometry_path(self.folder, part)

    def pose_path(self, frame: int) -> Path:
        return _pose_path(self.folder, frame)

    def train_path(self, shard: int) -> Path:
        return self.folder / "train" / f"{shard:05d}.safetensors"

    def validation_path(self, view: int, half: int) -> Path:
        return self.folder / "validation" / f"{view:02d}-{half}.safetensors"

    def emission_path(self, shard: int) -> Path:
        return self.folder / "emission" / f"{shard:05d}.safetensors"

    def emission_image_path(self, view: int, half: int) -> Path:
        return self.folder / "validation" / f"emission-{view:02d}-{half}.safetensors"

    @property
    def white_path(self) -> Path:
        return self.folder / "validation" / "white.safetensors"

    def finished_emission(self) -> list[Path]:
        """Paths of the shards of emission that are there. Raises `CaptureError` if none is."""
        shards = range(self.manifest.emission_shards)
        paths = [path for k in shards if (path := self.emission_path(k)).is_file()]
        if not paths:
            raise CaptureError(f"{self.folder}: no finished shard of emission")
        return paths

    def finished_shards(self) -> list[Path]:
        """Paths of the training shards that are there. Raises `CaptureError` if none is."""
        paths = [p for k in range(self.manifest.shards) if (p := self.train_path(k)).is_file()]
        if not paths:
            raise CaptureError(f"{self.folder}: no finished training shard")
        return paths

    def finished_views(self) -> list[int]:
        """Validation images of which both halves are there. `CaptureError` if none is."""
        views = [k for k in range(self.manifest.settings.validation_views) if self._is_finished(k)]
        if not views:
            raise CaptureError(f"{self.folder}: no finished validation image")
        return views

    def _is_finished(self, view: int) -> bool:
        return all(self.validation_path(view, half).is_file() for half in (0, 1))


def _pose_path(folder: Path, frame: int) -> Path:
    return folder / "poses" / f"{frame:05d}.safetensors"


def _materials_path(folder: Path) -> Path:
    return folder / "materials.safetensors"


def _glass_path(folder: Path) -> Path:
    return folder / "glass.glb"


def _geometry_path(folder: Path, part: str) -> Path:
    return folder / "geometry" / f"{part}.safetensors"
