"""Base colours of the materials of a source, checked against Cycles, as records of parts."""

import io
import itertools
import re
from collections import Counter
from collections.abc import Collection
from dataclasses import dataclass, field
from pathlib import PurePosixPath
from typing import Any

import numpy as np
from PIL import Image

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.material_colors import ColorImage, MaterialColor, Piece
from rna_export.capture.geometry.blurred_textures import PLANE_TEXELS
from rna_sdk.errors import PackageError
from rna_sdk.package import BaseColor, Mesh
from rna_sdk.package.limits import MAX_TEXTURE_RECORDS as _MOST
from rna_sdk.package.manifest.extensions import Variants
from rna_sdk.package.manifest.manifest_model import BaseColorFields, BaseColorRecord
from rna_sdk.package.textures.base_color import image_from_bytes
from rna_sdk.runtime.base_color import BaseColorMaps

WRONG_FILE, WRONG = 0.01, 0.03  # mean difference from Cycles' colours, linear
FINE = 0.01  # RMS of what planes would blur, linear: above it, print is worth a texture
UNLIKE = 0.05  # difference of plain colours, linear: above it, planes mix them in the shade
VARIANTS = f"extensions/{Variants.NAME}"
"""Folder of the images of variants."""

Ranges = dict[Piece, tuple[int, int]]
"""Triangles of each piece in a part: the first, and how many."""

_POINTS = 1 << 14
_ENDINGS = {b"\x89P": "png", b"\xff\xd8": "jpg", b"RI": "webp"}
_WHOLE = -1  # in the place of a piece's tile: of all of them


@dataclass
class BaseColors:
    """Base colours by the piece of a material.

    entries: names of the images, by piece. files: of the images, by name. images: decoded. known:
    names by file and tile. charts: the texture coordinates of all textures. others: see
    `MaterialColors`. notes: for the user. folder: where the files lie in a package. variants: by
    name. obstacles: by material, why its base colour is no image.
    """

    of_piece: dict[Piece, MaterialColor]
    charts: dict[str, Any]
    others: dict[str, dict[str, float]]
    notes: list[str]
    folder: str = "base_color"
    entries: dict[Piece, str] = field(default_factory=dict)
    files: dict[str, bytes] = field(default_factory=dict)
    images: dict[str, np.ndarray] = field(default_factory=dict)
    known: dict[tuple[bytes, int], str] = field(default_factory=dict)
    variants: dict[str, "Variant"] = field(default_factory=dict)
    obstacles: dict[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, worker: BlenderWorker, charts: dict[str, Any], largest: int) -> "BaseColors":
        """Base colours of all materials of the source and of its variants.

        charts: that other textures have taken. largest: texels a side of what is baked, at most.

        An image whose file does not have the colours that Cycles shows is taken as Cycles shows it.
        """
        colors = cls({}, charts, {}, [])
        colors._add(worker, largest, None)
        for variant in worker.opened["variants"]:
            colors._add_variant(worker, largest, variant["name"], variant["materials"])
        worker.show_variant(None)
        return colors

    @property
    def materials(self) -> tuple[str, ...]:
        """Full names of those that have a base colour."""
        return tuple(dict.fromkeys(name for name, _ in self.of_piece))

    def _add(self, worker: BlenderWorker, largest: int, only: Collection[str] | None) -> None:
        """Base colours of the shown materials; only: of these materials; None: of all."""
        charts = self.charts
        first = worker.export_base_colors(charts, largest, only=only)
        self.of_piece |= first.of_piece
        self.charts, self.others = first.charts, first.others
        self.notes += first.notes
        self.obstacles |= first.obstacles
        wrong = [piece for piece in first.of_piece if not self._add_image(piece)]
        if wrong:
            names = {name for name, _ in wrong}
            again = worker.export_base_colors(charts, largest, wrong, only=names).of_piece
            self._add_checked({piece: again[piece] for piece in wrong})

    def _add_checked(self, colors: dict[Piece, MaterialColor]) -> None:
        """Base colours that agree with Cycles' colours; a note of each other one."""
        for piece, color in colors.items():
            self.of_piece[piece] = color
            if not self._add_image(piece):
                del self.of_piece[piece]
                name, tile = piece
                self.notes.append(
                    f"material {name!r} has a base colour{f' in tile {tile}' * (tile > 0)} that is "
                    "no image over its UV coordinates: it is learnt, and as fine as the planes"
                )

    def _add_variant(
        self, worker: BlenderWorker, largest: int, name: str, materials: dict[str, str]
    ) -> None:
        """Base colours of a variant's materials, over the charts of those that they replace."""
        pairs = materials.items()
        charts = {other: self.charts[base] for base, other in pairs if base in self.charts}
        colors = BaseColors({}, charts, {}, [], VARIANTS)
        colors.files, colors.images, colors.known = self.files, self.images, self.known
        if materials:
            worker.show_variant(name)
            colors._add(worker, largest, set(materials.values()))
        for base, other in pairs:
            fits = colors.charts.get(other) == self.charts.get(base, colors.charts.get(other))
            if base not in self.materials or other not in colors.materials or not fits:
                self.notes.append(
                    f"variant {name!r} is left out: material {other!r} has a base colour that is "
                    f"no colour or image over the UV coordinates of {base!r}"
                )
                return
        for base, other in pairs:
            if other in colors.charts:
                self.charts[base] = colors.charts[other]
        self.variants[name] = Variant(colors, materials)

    def _add_image(self, piece: Piece) -> bool:
        """Keep the image of a piece; whether it has Cycles' colours. True without an image."""
        image, tile = self.of_piece[piece].image, piece[1]
        if image is None:
            return True
        file = _file(image.data)
        entry = self.known.get((file, tile))
        try:
            pixels = image_from_bytes(file, piece[0]) if entry is None else self.images[entry]
        except PackageError:
            return False
        if _difference(image, pixels) > (WRONG_FILE if image.data.ndim == 1 else WRONG):
            return False
        if entry is None:
            entry = self.known[file, tile] = self._new_entry(piece, _ENDINGS[file[:2]])
            self.files[entry], self.images[entry] = file, pixels
        self.entries[piece] = entry
        return True

    def _new_entry(self, piece: Piece, ending: str) -> str:
        """A name that tells the material and tile: hosts exchange images by it."""
        material, tile = piece
        label = re.sub(r"[^A-Za-z0-9-]+", "-", material).strip("-")[:40] or "image"
        label += f"-{tile}" if tile > 0 else ""
        names = (f"{label}-{k}" if k else label for k in itertools.count())
        taken = {PurePosixPath(entry).stem.lower() for entry in self.files}
        free = next(name for name in names if name.lower() not in taken)
        return f"{self.folder}/{free}.{ending}"

    def fitted(self, worker: BlenderWorker, largest: int, pieces: Ranges) -> Ranges:
        """The pieces of a part, with no more images than it has records.

        Where there are more, the tiles of a material are one piece, with what Blender bakes.
        """
        while len(shown := [piece for piece in pieces if piece in self.entries]) > _MOST:
            name, images = Counter(name for name, _ in shown).most_common(1)[0]
            if images == 1:
                break
            whole, own = (name, _WHOLE), [range_ for (n, _), range_ in pieces.items() if n == name]
            if whole not in self.entries:
                tiles = sum(n == name and tile > 0 for n, tile in shown)
                self.notes.append(
                    f"material {name!r} has {tiles} UDIM tiles, and a part {_MOST} images: they "
                    "are baked as one"
                )
                baked = worker.export_base_colors(self.charts, largest, whole=[name], only=[name])
                self.notes += baked.notes
                self._add_checked({whole: baked.of_piece[name, 0]} if baked.of_piece else {})
            pieces = {piece: of for piece, of in pieces.items() if piece[0] != name}
            pieces[whole] = min(own)[0], sum(count for _, count in own)
        return dict(sorted(pieces.items(), key=lambda item: item[1]))

    def records(self, mesh: Mesh, pieces: Ranges) -> dict[Piece, BaseColorRecord]:
        """Records of a part by piece, in order; none where planes show its base colour as well:
        no image is finer, no two plain colours are unlike, no variant changes it.
        """
        with_image = [piece for piece in pieces if piece in self.entries]
        plain = [piece for piece in pieces if piece in self.of_piece and piece not in self.entries]
        changed = {base for variant in self.variants.values() for base in variant.materials}
        is_worth_it = (
            not changed.isdisjoint(name for name, _ in pieces)
            or self._are_unlike(plain)
            or any(self._is_fine(mesh, piece, pieces[piece]) for piece in with_image)
        )
        if not is_worth_it:
            return {}
        largest = sorted(
            with_image + plain,
            key=lambda piece: (piece[0] not in changed, piece in plain, -pieces[piece][1]),
        )
        stored = largest[:_MOST]
        return {piece: self._record(piece, pieces[piece]) for piece in pieces if piece in stored}

    def changes(self, material: str, variant: str) -> BaseColorFields | None:
        """Replacement of a material's record in a variant; None: the same."""
        changed = self.variants[variant]
        other = changed.materials.get(material)
        return None if other is None else BaseColorFields(**changed.colors._members((other, 0)))

    def _are_unlike(self, plain: list[Piece]) -> bool:
        factors = np.array([self.of_piece[piece].factor for piece in plain]).reshape(-1, 3)
        return len(plain) > 1 and bool(np.ptp(factors, axis=0).max() > UNLIKE)

    def _is_fine(self, mesh: Mesh, piece: Piece, triangles: tuple[int, int]) -> bool:
        record = self._record(piece, triangles)
        return blurred(mesh, BaseColor.of(record, self.images[self.entries[piece]])) > FINE

    def _record(self, piece: Piece, triangles: tuple[int, int]) -> BaseColorRecord:
        return BaseColorRecord(triangles=triangles, **self._members(piece))

    def _members(self, piece: Piece) -> dict[str, Any]:
        color = self.of_piece[piece]
        if color.image is None:
            return {"factor": color.factor}
        return {
            "image": self.entries[piece],
            "color_space": color.image.color_space,
            "factor": color.factor,
            "wrap": color.image.wrap,
            "transform": color.image.transform,
        }


@dataclass
class Variant:
    """Base colours of a variant's materials. materials: by name, its replacement's name."""

    colors: BaseColors
    materials: dict[str, str]


def blurred(mesh: Mesh, color: BaseColor) -> float:
    """RMS difference, linear, of a base colour from its values at texels of planes."""
    low, high = mesh.box()
    corners = mesh.positions[mesh.triangles[color.first : color.first + color.count]]
    corners = corners.astype(np.float64)
    area = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    rng = np.random.default_rng(0)
    triangle = color.first + rng.choice(len(area), _POINTS, p=area / area.sum())
    root, v = np.sqrt(rng.random(_POINTS)), rng.random(_POINTS)
    b1, b2 = (root * (1.0 - v)).astype(np.float32), (root * v).astype(np.float32)
    maps = BaseColorMaps(mesh, [color])
    width = float((high - low).max()) / PLANE_TEXELS
    blur = maps.at(triangle, b1, b2) - maps.at(triangle, b1, b2, width)
    return float(np.sqrt(np.square(blur).mean()))


def _difference(image: ColorImage, pixels: np.ndarray) -> float:
    """Mean difference of an image, looked up at its points, from the colours of Cycles."""
    points, number = len(image.uvs), np.arange(len(image.uvs), dtype=np.uint32)
    nowhere, none = np.zeros((points, 3), np.float32), np.zeros(points, np.float32)
    mesh = Mesh(nowhere, nowhere, image.uvs.astype(np.float32), np.tile(number[:, None], (1, 3)))
    maps = BaseColorMaps(
        mesh,
        [
            BaseColor(
                0,
                points,
                pixels,
                color_space=image.color_space,
                factor=(1.0, 1.0, 1.0),
                wrap=image.wrap,
                transform=image.transform,
            )
        ],
    )
    return float(np.abs(maps.at(number, none, none) - np.clip(image.shown, 0.0, 1.0)).mean())


def _file(data: np.ndarray) -> bytes:
    """Bytes of a file; texels are written as PNG."""
    if data.ndim == 1:
        return data.tobytes()
    file = io.BytesIO()
    Image.fromarray(data).save(file, "PNG", optimize=True)
    return file.getvalue()
