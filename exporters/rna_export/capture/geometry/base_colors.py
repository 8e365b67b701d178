"""Base colours of the materials of a source, checked against Cycles, as records of parts."""

from __future__ import annotations

import io
import itertools
import re
from collections.abc import Collection
from dataclasses import dataclass, field
from pathlib import PurePosixPath
from typing import Any

import numpy as np
from PIL import Image

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.material_colors import ColorImage, MaterialColor
from rna_export.capture.geometry.blurred_textures import PLANE_TEXELS
from rna_sdk.errors import PackageError
from rna_sdk.package import BaseColor, Mesh
from rna_sdk.package.limits import MAX_TEXTURE_RECORDS
from rna_sdk.package.manifest.extensions import Variants
from rna_sdk.package.manifest.manifest_model import BaseColorFields, BaseColorRecord
from rna_sdk.package.textures.base_color import image_from_bytes
from rna_sdk.runtime.base_color import BaseColorMaps

WRONG_FILE, WRONG = 0.01, 0.03  # mean difference from Cycles' colours, linear
FINE = 0.01  # RMS of what planes would blur, linear: above it, print is worth a texture
UNLIKE = 0.05  # difference of plain colours, linear: above it, planes mix them in the shade
VARIANTS = f"extensions/{Variants.NAME}"
"""Folder of the images of variants."""

_POINTS = 1 << 14
_ENDINGS = {b"\x89P": "png", b"\xff\xd8": "jpg", b"RI": "webp"}


@dataclass
class BaseColors:
    """Base colours by the full name of their material.

    entries: names of the images, by material. files: of the images, by name. images: decoded.
    charts: the texture coordinates of all textures. others: see `MaterialColors`. notes: for the
    user. folder: where the files lie in a package. variants: by name.
    """

    of_material: dict[str, MaterialColor]
    charts: dict[str, Any]
    others: dict[str, dict[str, float]]
    notes: list[str]
    folder: str = "base_color"
    entries: dict[str, str] = field(default_factory=dict)
    files: dict[str, bytes] = field(default_factory=dict)
    images: dict[str, np.ndarray] = field(default_factory=dict)
    variants: dict[str, Variant] = field(default_factory=dict)

    @classmethod
    def of(cls, worker: BlenderWorker, charts: dict[str, Any], largest: int) -> BaseColors:
        """Of all materials of the source, and of its variants.

        charts: that other textures have taken. largest: texels a side of what is baked, at most.

        An image whose file does not have the colours that Cycles shows is taken as Cycles shows it.
        """
        colors = cls({}, charts, {}, [])
        colors._add(worker, largest, None)
        for variant in worker.opened["variants"]:
            colors._add_variant(worker, largest, variant["name"], variant["materials"])
        worker.show_variant(None)
        return colors

    def _add(self, worker: BlenderWorker, largest: int, only: Collection[str] | None) -> None:
        """Base colours of what the worker shows; only: of these materials; None: of all."""
        charts = self.charts
        first = worker.export_base_colors(charts, largest, only=only)
        self.of_material |= first.of_material
        self.charts, self.others = first.charts, first.others
        self.notes += first.notes
        wrong = [name for name in first.of_material if not self._add_image(name)]
        if wrong:
            self.of_material |= worker.export_base_colors(charts, largest, wrong, only).of_material
            for name in wrong:
                if not self._add_image(name):
                    del self.of_material[name]
                    self.notes.append(
                        f"material {name!r} has a base colour that is no image over its UV "
                        "coordinates: it is learnt, and as fine as the planes"
                    )

    def _add_variant(
        self, worker: BlenderWorker, largest: int, name: str, materials: dict[str, str]
    ) -> None:
        """Base colours of a variant's materials, over the charts of those that they replace."""
        pairs = materials.items()
        charts = {other: self.charts[base] for base, other in pairs if base in self.charts}
        colors = BaseColors({}, charts, {}, [], VARIANTS, files=self.files, images=self.images)
        if materials:
            worker.show_variant(name)
            colors._add(worker, largest, set(materials.values()))
        for base, other in pairs:
            fits = colors.charts.get(other) == self.charts.get(base, colors.charts.get(other))
            if base not in self.of_material or other not in colors.of_material or not fits:
                self.notes.append(
                    f"variant {name!r} is left out: material {other!r} has a base colour that is "
                    f"no colour or image over the UV coordinates of {base!r}"
                )
                return
        for base, other in pairs:
            if other in colors.charts:
                self.charts[base] = colors.charts[other]
        self.variants[name] = Variant(colors, materials)

    def _add_image(self, name: str) -> bool:
        """Keep the image of a material; whether it has Cycles' colours. True without an image."""
        image = self.of_material[name].image
        if image is None:
            return True
        file = _file(image.data)
        entry = next((key for key, known in self.files.items() if known == file), None)
        try:
            pixels = image_from_bytes(file, name) if entry is None else self.images[entry]
        except PackageError:
            return False
        if _difference(image, pixels) > (WRONG_FILE if image.data.ndim == 1 else WRONG):
            return False
        if entry is None:
            entry = self._new_entry(name, _ENDINGS[file[:2]])
            self.files[entry], self.images[entry] = file, pixels
        self.entries[name] = entry
        return True

    def _new_entry(self, material: str, ending: str) -> str:
        """A name that tells the material: hosts exchange images by it."""
        label = re.sub(r"[^A-Za-z0-9-]+", "-", material).strip("-")[:40] or "image"
        names = (f"{label}-{k}" if k else label for k in itertools.count())
        taken = {PurePosixPath(entry).stem.lower() for entry in self.files}
        free = next(name for name in names if name.lower() not in taken)
        return f"{self.folder}/{free}.{ending}"

    def records(self, mesh: Mesh, ranges: dict[str, tuple[int, int]]) -> dict[str, BaseColorRecord]:
        """Records of a part by material, in order; none where planes show its base colour as well:
        no image is finer, no two plain colours are unlike, no variant changes it.

        ranges: triangles of each material.
        """
        with_image = [name for name in ranges if name in self.entries]
        plain = [name for name in ranges if name in self.of_material and name not in self.entries]
        changed = {base for variant in self.variants.values() for base in variant.materials}
        is_worth_it = (
            not changed.isdisjoint(ranges)
            or self._are_unlike(plain)
            or any(self._is_fine(mesh, name, ranges[name]) for name in with_image)
        )
        if not is_worth_it:
            return {}
        largest = sorted(
            with_image + plain,
            key=lambda name: (name not in changed, name in plain, -ranges[name][1]),
        )
        stored = largest[:MAX_TEXTURE_RECORDS]
        return {name: self._record(name, ranges[name]) for name in ranges if name in stored}

    def changes(self, name: str, variant: str) -> BaseColorFields | None:
        """What a variant has in the place of a material's record; None: the same."""
        changed = self.variants[variant]
        other = changed.materials.get(name)
        return None if other is None else BaseColorFields(**changed.colors._members(other))

    def _are_unlike(self, plain: list[str]) -> bool:
        factors = np.array([self.of_material[name].factor for name in plain]).reshape(-1, 3)
        return len(plain) > 1 and bool(np.ptp(factors, axis=0).max() > UNLIKE)

    def _is_fine(self, mesh: Mesh, name: str, triangles: tuple[int, int]) -> bool:
        record = self._record(name, triangles)
        return blurred(mesh, BaseColor.of(record, self.images[self.entries[name]])) > FINE

    def _record(self, name: str, triangles: tuple[int, int]) -> BaseColorRecord:
        return BaseColorRecord(triangles=triangles, **self._members(name))

    def _members(self, name: str) -> dict[str, Any]:
        color = self.of_material[name]
        if color.image is None:
            return {"factor": color.factor}
        return {
            "image": self.entries[name],
            "color_space": color.image.color_space,
            "factor": color.factor,
            "wrap": color.image.wrap,
            "transform": color.image.transform,
        }


@dataclass
class Variant:
    """Base colours of a variant's materials. materials: by name, that of the one in its place."""

    colors: BaseColors
    materials: dict[str, str]


def blurred(mesh: Mesh, color: BaseColor) -> float:
    """RMS difference, linear, of a base colour from what texels of planes would show of it."""
    low, high = mesh.box()
    corners = mesh.positions[mesh.triangles[color.first : color.first + color.count]]
    corners = corners.astype(np.float64)
    area = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    rng = np.random.default_rng(0)
    triangle = color.first + rng.choice(len(area), _POINTS, p=area / area.sum())
    root, v = np.sqrt(rng.random(_POINTS)), rng.random(_POINTS)
    at = triangle, (root * (1.0 - v)).astype(np.float32), (root * v).astype(np.float32)
    maps = BaseColorMaps(mesh, [color])
    width = float((high - low).max()) / PLANE_TEXELS
    return float(np.sqrt(np.square(maps.at(*at) - maps.at(*at, width)).mean()))


def _difference(image: ColorImage, pixels: np.ndarray) -> float:
    """Mean difference of an image, looked up at its points, from the colours of Cycles."""
    points, number = len(image.uvs), np.arange(len(image.uvs), dtype=np.uint32)
    nowhere, none = np.zeros((points, 3), np.float32), np.zeros(points, np.float32)
    mesh = Mesh(nowhere, nowhere, image.uvs.astype(np.float32), np.tile(number[:, None], (1, 3)))
    how = image.color_space, (1.0, 1.0, 1.0), image.wrap, image.transform
    maps = BaseColorMaps(mesh, [BaseColor(0, points, pixels, *how)])
    return float(np.abs(maps.at(number, none, none) - np.clip(image.shown, 0.0, 1.0)).mean())


def _file(data: np.ndarray) -> bytes:
    """Bytes of a file; texels are written as PNG."""
    if data.ndim == 1:
        return data.tobytes()
    file = io.BytesIO()
    Image.fromarray(data).save(file, "PNG", optimize=True)
    return file.getvalue()
