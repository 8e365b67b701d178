"""Base colours of the materials of a source, checked against Cycles, as records of parts."""

from __future__ import annotations

import io
import itertools
import re
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
from rna_sdk.package.manifest.manifest_model import BaseColorRecord
from rna_sdk.package.textures.base_color import image_from_bytes
from rna_sdk.runtime.base_color import BaseColorMaps

WRONG_FILE, WRONG = 0.01, 0.03  # mean difference from Cycles' colours, linear
FINE = 0.01  # RMS of what planes would blur, linear: above it, print is worth a texture
_POINTS = 1 << 14
_ENDINGS = {b"\x89P": "png", b"\xff\xd8": "jpg", b"RI": "webp"}


@dataclass
class BaseColors:
    """Base colours by the full name of their material.

    entries: names of the images, by material. files: of the images, by name. images: decoded.
    charts: the texture coordinates of all textures. others: see `MaterialColors`. notes: for the
    user.
    """

    of_material: dict[str, MaterialColor]
    charts: dict[str, Any]
    others: dict[str, dict[str, float]]
    notes: list[str]
    entries: dict[str, str] = field(default_factory=dict)
    files: dict[str, bytes] = field(default_factory=dict)
    images: dict[str, np.ndarray] = field(default_factory=dict)

    @classmethod
    def of(cls, worker: BlenderWorker, charts: dict[str, Any], largest: int) -> BaseColors:
        """Of all materials of the source.

        charts: that other textures have taken. largest: texels a side of what is baked, at most.

        An image whose file does not have the colours that Cycles shows is taken as Cycles shows it.
        """
        first = worker.export_base_colors(charts, largest)
        colors = cls(dict(first.of_material), first.charts, first.others, list(first.notes))
        wrong = [name for name in first.of_material if not colors._add_image(name)]
        if wrong:
            colors.of_material |= worker.export_base_colors(charts, largest, wrong).of_material
            for name in wrong:
                if not colors._add_image(name):
                    del colors.of_material[name]
                    colors.notes.append(
                        f"material {name!r} has a base colour that is no image over its UV "
                        "coordinates: it is learnt, and as fine as the planes"
                    )
        return colors

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
        return f"base_color/{free}.{ending}"

    def records(self, mesh: Mesh, ranges: dict[str, tuple[int, int]]) -> list[BaseColorRecord]:
        """Records of a part; none if no image of it is finer than planes would be.

        ranges: triangles of each material.
        """
        with_image = [name for name in ranges if name in self.entries]
        if not any(self._is_fine(mesh, name, ranges[name]) for name in with_image):
            return []
        plain = [name for name in ranges if name in self.of_material and name not in self.entries]
        largest = sorted(with_image + plain, key=lambda name: (name in plain, -ranges[name][1]))
        kept = largest[:MAX_TEXTURE_RECORDS]
        return [self._record(name, ranges[name]) for name in ranges if name in kept]

    def _is_fine(self, mesh: Mesh, name: str, triangles: tuple[int, int]) -> bool:
        record = self._record(name, triangles)
        return blurred(mesh, BaseColor.of(record, self.images[self.entries[name]])) > FINE

    def _record(self, name: str, triangles: tuple[int, int]) -> BaseColorRecord:
        color = self.of_material[name]
        if color.image is None:
            return BaseColorRecord(triangles=triangles, factor=color.factor)
        return BaseColorRecord(
            triangles=triangles,
            image=self.entries[name],
            color_space=color.image.color_space,
            factor=color.factor,
            wrap=color.image.wrap,
            transform=color.image.transform,
        )


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
