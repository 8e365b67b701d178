"""A package inside a binary glTF, with a fallback: its geometry with the stand-in materials.

Holes become alpha, normal maps those of glTF, strands ribbons, images of base colour textures. Of
what the network knows, the fallback has a colour at each vertex, at most. Geometry and textures
that the package holds are not stored again.
"""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import PurePosixPath
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from rna_sdk import __version__
from rna_sdk.package.geometry import gltf_model as gltf
from rna_sdk.package.geometry.curves import Curves
from rna_sdk.package.geometry.glb_reader import split_glb
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from rna_sdk.package.geometry.quantised_mesh import quantise_mesh
from rna_sdk.package.gltf.carrier import EXTENSION
from rna_sdk.package.gltf.carrier_writer import carrying, packed
from rna_sdk.package.gltf.strand_ribbons import MAX_TRIANGLES, ribbons
from rna_sdk.package.manifest.extensions import Standin, StandinMaterial, StandinTextures, of_part
from rna_sdk.package.manifest.manifest_fields import Record
from rna_sdk.package.manifest.manifest_model import BaseColorRecord, Wrap
from rna_sdk.package.package import Package
from rna_sdk.package.textures.base_color import IDENTITY, WHITE
from rna_sdk.package.textures.normal_maps import NormalMap
from rna_sdk.package.textures.transmittance import Transmittance

_GREY = StandinMaterial(base_color=(0.5, 0.5, 0.5), roughness=1.0, metallic=0.0)
_WRAPS = {"repeat": 10497, "clamp": 33071, "mirror": 33648}
_REPEAT: tuple[Wrap, Wrap] = ("repeat", "repeat")
_IMAGES = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg"}
_FULL = 65535
_DARK = 1.0 / 255.0  # base colour that nothing is divided by

_FEWEST_TRIANGLES = 10_000
_STRAND_SHARE, _TRIANGLE_BYTES = 0.34, 30
"""Ribbons take at most this share of the package's size; of a triangle, at 8 segments each."""


class VertexColors(NamedTuple):
    """Colours of a part's vertices, (v, 3) float32, linear.

    base: the part of `color` that is the package's base colour; None where it has none.
    """

    color: NDArray[np.float32]
    base: NDArray[np.float32] | None = None


def glb_of(package: Package, colors: Mapping[int, VertexColors] | None = None) -> bytes:
    """A package as a .glb that other viewers show, too: metres, +Y up, a node for each part.

    A package without stand-in materials (RNA_standin) gets grey ones. Textures of these, and else
    colors, take the place of the base colour. colors: of the vertices of some parts, by the part's
    number.
    """
    file = _File(package)
    manifest = package.manifest
    for i, part in enumerate(manifest.parts):
        mesh = file.mesh(i)
        base = of_part(manifest, Standin, i) or _GREY
        textures = of_part(manifest, StandinTextures, i)
        vertex_colors = None if textures else (colors or {}).get(i)
        holes, reliefs = package.transmittance(i), package.normal_maps(i)
        prints: list[_Print] = []
        if vertex_colors is not None:
            if vertex_colors.base is not None:
                prints = _prints(part.base_color, holes)
            base = base.model_copy(update={"base_color": WHITE})
            rest = _without_prints(vertex_colors, prints, package.mesh(i).triangles)
            mesh.attributes["COLOR_0"] = file.colors(rest)
        looks = _Looks(file, part.name, base, holes, reliefs, prints, dict(textures or ()))
        file.add("meshes", {"name": part.name, "primitives": mesh.primitives(looks)})
        file.add("nodes", {"mesh": i, "name": part.name, **mesh.transform})
    return file.packed(
        generator=f"rna-info {__version__}",
        copyright=f"{manifest.provenance.source}; {manifest.license}",
    )


class _Range(Protocol):
    """A range of triangles."""

    @property
    def first(self) -> int: ...

    @property
    def count(self) -> int: ...


class _Print(NamedTuple):
    """An image of base colour on a range of triangles, as a texture of glTF can have it."""

    first: int
    count: int
    image: str
    factor: tuple[float, float, float]
    wrap: tuple[Wrap, Wrap]


def _prints(records: Sequence[BaseColorRecord], holes: Sequence[Transmittance]) -> list[_Print]:
    """The images of base colour that viewers know, where no hole needs their alpha."""
    result = []
    for record in records:
        first, count = record.triangles
        is_known = record.color_space in (None, "srgb") and record.transform in (None, IDENTITY)
        is_solid = all(
            hole.first + hole.count <= first or first + count <= hole.first for hole in holes
        )
        if record.image and PurePosixPath(record.image).suffix in _IMAGES and is_known and is_solid:
            wrap = record.wrap or _REPEAT
            result.append(_Print(first, count, record.image, record.factor or WHITE, wrap))
    return result


def _without_prints(
    colors: VertexColors, prints: Sequence[_Print], triangles: NDArray[np.uint32]
) -> NDArray[np.float32]:
    """Colours of vertices (v, 3), divided by the base colour where a texture has that."""
    result = colors.color.copy()
    for each in prints:
        vertices = np.unique(triangles[each.first : each.first + each.count])
        base = colors.base[vertices] if colors.base is not None else 1.0
        result[vertices] = colors.color[vertices] / np.maximum(base, _DARK)
    return result


class _File:
    """The arrays of a glTF document that grow, and its buffer, which begins with the package."""

    def __init__(self, package: Package) -> None:
        self._package = package
        self._lists: dict[str, list[dict[str, Any]]] = {}
        self._blob: list[bytes | memoryview] = []
        self._size = 0
        self._textures: dict[tuple[str, tuple[Wrap, Wrap]], dict[str, int]] = {}
        self.view(self._append(package.file_data), len(package.file_data))
        self.is_quantised = False

    def add(self, name: str, member: dict[str, Any]) -> int:
        """Append to the array `name`; its index there."""
        members = self._lists.setdefault(name, [])
        members.append(member)
        return len(members) - 1

    def view(self, start: int, size: int, **members: int) -> int:
        """A buffer view."""
        view = {"buffer": 0, "byteOffset": start, "byteLength": size, **members}
        return self.add("bufferViews", view)

    def mesh(self, part: int) -> _PartMesh:
        """The geometry of a part, in place if the package has it in a form that glTF knows."""
        geometry, name = self._package.geometry(part), self._package.manifest.parts[part].geometry
        if isinstance(geometry, Curves):
            most = int(_STRAND_SHARE * len(self._package.file_data)) // _TRIANGLE_BYTES
            most = min(MAX_TRIANGLES, max(most, _FEWEST_TRIANGLES))
            data = memoryview(mesh_to_glb(quantise_mesh(ribbons(geometry, most))))
            return _PartMesh(self, data, self._append(data), name)
        data, start = self._package.entry(name)
        return _PartMesh(self, data, self._append(data) if start is None else start, name)

    def colors(self, colors: NDArray[np.float32]) -> int:
        """An accessor of linear colours (v, 3) from 0 to 1, in 16 bits a channel."""
        rows = np.full((len(colors), 4), _FULL, "<u2")
        rows[:, :3] = np.rint(np.clip(colors, 0.0, 1.0) * np.float32(_FULL))
        view = self.view(self._append(rows.tobytes()), rows.nbytes, target=gltf.ARRAY_BUFFER)
        form = {"componentType": gltf.UNSIGNED_SHORT, "normalized": True, "type": "VEC4"}
        return self.add("accessors", {"bufferView": view, "count": len(rows), **form})

    def texture(self, png: bytes) -> dict[str, int]:
        """A texture that repeats."""
        return self._texture(self._append(png), len(png), "image/png", _REPEAT)

    def texture_of(self, entry: str, wrap: tuple[Wrap, Wrap] = _REPEAT) -> dict[str, int]:
        """A texture that is an image of the package."""
        if (entry, wrap) not in self._textures:
            data, start = self._package.entry(entry)
            start = self._append(data) if start is None else start
            kind = _IMAGES[PurePosixPath(entry).suffix]
            self._textures[entry, wrap] = self._texture(start, len(data), kind, wrap)
        return self._textures[entry, wrap]

    def packed(self, **asset: str) -> bytes:
        """The file."""
        parts = list(range(len(self._lists["nodes"])))
        name = self._package.manifest.name
        root = self.add("nodes", {"name": name, "children": parts, "extensions": carrying(0)})
        document: dict[str, Any] = {
            "asset": {"version": "2.0", **asset},
            "extensionsUsed": [EXTENSION],
            "scene": 0,
            "scenes": [{"nodes": [root]}],
            **self._lists,
        }
        if self.is_quantised:
            document["extensionsUsed"].append(gltf.QUANTIZATION)
            document["extensionsRequired"] = [gltf.QUANTIZATION]
        return packed(document, b"".join(self._blob))

    def _texture(self, start: int, size: int, kind: str, wrap: tuple[Wrap, Wrap]) -> dict[str, int]:
        image = self.add("images", {"bufferView": self.view(start, size), "mimeType": kind})
        sampler = dict(zip(("wrapS", "wrapT"), (_WRAPS[side] for side in wrap), strict=True))
        samplers = self._lists.setdefault("samplers", [])
        if sampler not in samplers:
            samplers.append(sampler)
        place = {"source": image, "sampler": samplers.index(sampler)}
        return {"index": self.add("textures", place)}

    def _append(self, data: bytes | memoryview) -> int:
        """Where the bytes are in the buffer, once they are in it; a multiple of 4."""
        start = self._size
        padding = bytes(-len(data) % 4)
        self._blob += [data, padding]
        self._size += len(data) + len(padding)
        return start


class _PartMesh:
    """The mesh of a package's own .glb, whose bytes are at `start` of the buffer.

    Attributes:
        attributes: accessors by name.
        transform: members of the node, those of quantised positions.
    """

    def __init__(self, file: _File, data: memoryview, start: int, name: str) -> None:
        document, place = split_glb(data, name)
        primitive, node = document.meshes[0].primitives[0], document.nodes[0]
        file.is_quantised |= document.is_quantised
        self._file = file
        self._views = [
            file.view(
                start + place.start + view.byte_offset,
                view.byte_length,
                **_dumped(view, "byte_stride", "target"),
            )
            for view in document.buffer_views
        ]
        self._indices = document.accessors[primitive.indices]
        self.transform = _dumped(node, "translation", "scale")
        named = _dumped(primitive.attributes, *gltf.Attributes.model_fields)
        self.attributes = {
            which: self._add(document.accessors[number]) for which, number in named.items()
        }

    def primitives(self, looks: _Looks) -> list[dict[str, Any]]:
        """The triangles, cut where materials change; the vertices are shared."""
        count = self._indices.count // 3
        borders = sorted({0, count, *looks.borders()})
        return [
            {
                "attributes": self.attributes,
                "indices": self._triangles(first, end),
                "material": looks.material_at(first),
            }
            for first, end in pairwise(borders)
        ]

    def _triangles(self, first: int, end: int) -> int:
        size = 2 if self._indices.component_type == gltf.UNSIGNED_SHORT else 4
        offset = self._indices.byte_offset + 3 * first * size
        return self._add(self._indices, byteOffset=offset, count=3 * (end - first))

    def _add(self, accessor: gltf.Accessor, **members: int) -> int:
        fields = accessor.model_dump(mode="json", by_alias=True, exclude_none=True)
        view = self._views[accessor.buffer_view]
        return self._file.add("accessors", {**fields, "bufferView": view, **members})


def _dumped(record: Record, *names: str) -> dict[str, Any]:
    """Some members of a record that are there, by their names in JSON."""
    return record.model_dump(mode="json", include=set(names), by_alias=True, exclude_none=True)


class _Looks:
    """The materials of a part, one for each set of textures that a triangle may have.

    textures: entries by member of RNA_standin_textures; empty for none.
    """

    def __init__(
        self,
        file: _File,
        name: str,
        base: StandinMaterial,
        holes: list[Transmittance],
        reliefs: list[NormalMap],
        prints: list[_Print],
        textures: Mapping[str, str],
    ) -> None:
        self._file, self._name, self._base, self._textures = file, name, base, textures
        self._records: tuple[Sequence[_Range], ...] = (holes, reliefs, prints)
        self._holes, self._reliefs, self._prints = holes, reliefs, prints
        self._made: dict[tuple[int | None, ...], int] = {}

    def borders(self) -> list[int]:
        """The triangles at which another material may begin or end."""
        every = (record for records in self._records for record in records)
        return [end for r in every for end in (r.first, r.first + r.count)]

    def material_at(self, triangle: int) -> int:
        """Index of the material of a triangle."""
        key = tuple(_of(records, triangle) for records in self._records)
        if key not in self._made:
            self._made[key] = self._file.add("materials", self._material(*key))
        return self._made[key]

    def _textured(self) -> dict[str, Any]:
        """A part with textures has neither holes nor reliefs."""
        images = {name: self._file.texture_of(entry) for name, entry in self._textures.items()}
        surface = {
            "baseColorTexture": images["base_color"],
            "metallicRoughnessTexture": images["metallic_roughness"],
        }
        return {"pbrMetallicRoughness": surface, "normalTexture": images["normal"]}

    def _material(self, hole: int | None, relief: int | None, print_: int | None) -> dict[str, Any]:
        if self._textures:
            return {"name": self._name, "doubleSided": True, **self._textured()}
        base = self._base
        surface: dict[str, Any] = {
            "baseColorFactor": [*base.base_color, 1.0],
            "metallicFactor": base.metallic,
            "roughnessFactor": base.roughness,
        }
        material = {"name": self._name, "pbrMetallicRoughness": surface, "doubleSided": True}
        if print_ is not None:
            of = self._prints[print_]
            surface["baseColorFactor"][:3] = of.factor
            surface["baseColorTexture"] = self._file.texture_of(of.image, of.wrap)
        if hole is not None:
            record = self._holes[hole]
            alpha = 255 - record.texture.mean(axis=2).round().astype(np.uint8)
            if alpha.size == 1:
                surface["baseColorFactor"][3] = float(alpha.item()) / 255.0
            else:
                white = np.full((*alpha.shape, 3), 255, np.uint8)
                surface["baseColorTexture"] = self._file.texture(_png(np.dstack([white, alpha])))
            material["alphaMode"] = "BLEND" if record.cutoff is None else "MASK"
            if record.cutoff is not None:
                material["alphaCutoff"] = 1.0 - record.cutoff
        if relief is not None:
            pixels = _gltf_normals(self._reliefs[relief].texture)
            material["normalTexture"] = self._file.texture(_png(pixels))
        return material


def _of(records: Sequence[_Range], triangle: int) -> int | None:
    """Number of the record whose range has the triangle."""
    for i, record in enumerate(records):
        if record.first <= triangle < record.first + record.count:
            return i
    return None


def _gltf_normals(texels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A map (h, w, 2) of the package, 127 + 127 x, as glTF has it: (h, w, 3), 127.5 (1 + x)."""
    xy = (texels.astype(np.float64) - 127.0) / 127.0
    z = np.sqrt(np.maximum(0.0, 1.0 - (xy**2).sum(axis=2)))
    scaled = np.round(127.5 * (1.0 + np.dstack([xy, z])))
    pixels: NDArray[np.uint8] = np.clip(scaled, 0, 255).astype(np.uint8)
    return pixels


def _png(pixels: NDArray[np.uint8]) -> bytes:
    """A PNG of (h, w, 3 or 4) uint8."""
    from PIL import Image  # loads with the first image

    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "PNG")
    return file.getvalue()
