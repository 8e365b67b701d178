"""A package as an ordinary binary glTF: its geometry with the stand-in materials.

Holes become alpha, normal maps those of glTF, strands tubes. Of what the network knows it
has a colour at each vertex, at most.
"""

from __future__ import annotations

import io
import json
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk import __version__
from rna_sdk.package.geometry import gltf_model as gltf
from rna_sdk.package.geometry.glb_writer import pack_glb
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.geometry.strand_tubes import tubes
from rna_sdk.package.manifest.extensions import Standin, StandinMaterial, of_part
from rna_sdk.package.package import Package
from rna_sdk.package.textures.normal_maps import NormalMap
from rna_sdk.package.textures.transmittance import Transmittance

_GREY = StandinMaterial(base_color=(0.5, 0.5, 0.5), roughness=1.0, metallic=0.0)
_TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3"}
_REPEAT = 10497


def standin_glb(package: Package, colors: Mapping[int, NDArray[np.float32]] | None = None) -> bytes:
    """The parts of a package as a .glb, metres, +Y up: a node each, named as the part.

    A package without stand-in materials (RNA_standin) gets grey ones. Textures of these, and else
    colors, take the place of the base colour. colors: of the vertices of some parts, by the part's
    number, (v, 3), linear.
    """
    file = _File()
    manifest = package.manifest
    for i, part in enumerate(manifest.parts):
        geometry = package.geometry(i)
        mesh = geometry if isinstance(geometry, Mesh) else tubes(geometry)
        base = of_part(manifest, Standin, i) or _GREY
        textures = package.standin_textures(i)
        vertex_colors = None if textures else (colors or {}).get(i)
        if vertex_colors is not None:
            base = base.model_copy(update={"base_color": (1.0, 1.0, 1.0)})
        holes, reliefs = package.transmittance(i), package.normal_maps(i)
        looks = _Looks(file, part.name, base, holes, reliefs, textures)
        file.add("nodes", {"mesh": i, "name": part.name})
        file.add(
            "meshes",
            {"name": part.name, "primitives": _primitives(file, mesh, vertex_colors, looks)},
        )
    return file.packed(
        generator=f"rna-info {__version__}",
        copyright=f"{manifest.provenance.source}; {manifest.license}",
    )


class _File:
    """The arrays of a glTF document that grow, and its buffer."""

    def __init__(self) -> None:
        self._lists: dict[str, list[dict[str, Any]]] = {}
        self._blob: list[bytes] = []
        self._size = 0

    def add(self, name: str, member: dict[str, Any]) -> int:
        """Append to the array `name`; its index there."""
        members = self._lists.setdefault(name, [])
        members.append(member)
        return len(members) - 1

    def view(self, data: bytes, **members: int) -> int:
        """A buffer view of these bytes."""
        view = {"buffer": 0, "byteOffset": self._size, "byteLength": len(data), **members}
        padded = data + bytes(-len(data) % 4)
        self._blob.append(padded)
        self._size += len(padded)
        return self.add("bufferViews", view)

    def array(self, rows: NDArray[Any], *, index: bool = False, ranged: bool = False) -> int:
        """An accessor of (n, 1 to 3) float32 or uint32."""
        data = np.ascontiguousarray(rows, rows.dtype.newbyteorder("<")).tobytes()
        target = gltf.ELEMENT_ARRAY_BUFFER if index else gltf.ARRAY_BUFFER
        accessor: dict[str, Any] = {
            "bufferView": self.view(data, target=target),
            "componentType": gltf.UNSIGNED_INT if index else gltf.FLOAT,
            "count": len(rows),
            "type": _TYPES[rows.shape[1]],
        }
        if ranged:
            accessor |= {"min": rows.min(axis=0).tolist(), "max": rows.max(axis=0).tolist()}
        return self.add("accessors", accessor)

    def texture(self, png: bytes) -> dict[str, int]:
        """A texture that repeats."""
        image = self.add("images", {"bufferView": self.view(png), "mimeType": "image/png"})
        if "samplers" not in self._lists:
            self.add("samplers", {"wrapS": _REPEAT, "wrapT": _REPEAT})
        return {"index": self.add("textures", {"source": image, "sampler": 0})}

    def packed(self, **asset: str) -> bytes:
        """The file."""
        blob = b"".join(self._blob)
        document = {
            "asset": {"version": "2.0", **asset},
            "scene": 0,
            "scenes": [{"nodes": list(range(len(self._lists["nodes"])))}],
            **self._lists,
            "buffers": [{"byteLength": len(blob)}],
        }
        return pack_glb(json.dumps(document, separators=(",", ":")).encode(), blob)


class _Looks:
    """The materials of a part, one for each set of textures that a triangle may have."""

    def __init__(
        self,
        file: _File,
        name: str,
        base: StandinMaterial,
        holes: list[Transmittance],
        reliefs: list[NormalMap],
        textures: Mapping[str, bytes] | None,
    ) -> None:
        self._file, self._name, self._base, self._textures = file, name, base, textures
        self._holes, self._reliefs = holes, reliefs
        self._made: dict[tuple[int | None, int | None], int] = {}

    def borders(self) -> list[int]:
        """The triangles at which another material may begin or end."""
        records: list[Transmittance | NormalMap] = [*self._holes, *self._reliefs]
        return [end for r in records for end in (r.first, r.first + r.count)]

    def material_at(self, triangle: int) -> int:
        """Index of the material of a triangle."""
        holes, relief = key = _of(self._holes, triangle), _of(self._reliefs, triangle)
        if key not in self._made:
            self._made[key] = self._file.add("materials", self._material(holes, relief))
        return self._made[key]

    def _textured(self, textures: Mapping[str, bytes]) -> dict[str, Any]:
        """A part with textures has neither holes nor reliefs."""
        images = {member: self._file.texture(png) for member, png in textures.items()}
        surface = {
            "baseColorTexture": images["base_color"],
            "metallicRoughnessTexture": images["metallic_roughness"],
        }
        return {"pbrMetallicRoughness": surface, "normalTexture": images["normal"]}

    def _material(self, hole: int | None, relief: int | None) -> dict[str, Any]:
        if self._textures is not None:
            return {"name": self._name, "doubleSided": True, **self._textured(self._textures)}
        base = self._base
        surface: dict[str, Any] = {
            "baseColorFactor": [*base.base_color, 1.0],
            "metallicFactor": base.metallic,
            "roughnessFactor": base.roughness,
        }
        material = {"name": self._name, "pbrMetallicRoughness": surface, "doubleSided": True}
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


def _of(records: Sequence[Transmittance | NormalMap], triangle: int) -> int | None:
    """Number of the record whose range has the triangle."""
    for i, record in enumerate(records):
        if record.first <= triangle < record.first + record.count:
            return i
    return None


def _primitives(
    file: _File, mesh: Mesh, colors: NDArray[np.float32] | None, looks: _Looks
) -> list[dict[str, Any]]:
    """The triangles of a mesh, cut where materials change; the vertices are shared."""
    lengths = np.linalg.norm(mesh.normals, axis=1, keepdims=True)
    attributes = {
        "POSITION": file.array(mesh.positions, ranged=True),
        "NORMAL": file.array(mesh.normals / lengths),
    }
    if mesh.uvs is not None:
        attributes["TEXCOORD_0"] = file.array(mesh.uvs)
    if colors is not None:
        attributes["COLOR_0"] = file.array(colors)
    borders = sorted({0, len(mesh.triangles), *looks.borders()})
    return [
        {
            "attributes": attributes,
            "indices": file.array(mesh.triangles[first:end].reshape(-1, 1), index=True),
            "material": looks.material_at(first),
        }
        for first, end in pairwise(borders)
    ]


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
