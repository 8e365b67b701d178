"""A package inside a binary glTF, with a fallback: its geometry with the stand-in materials.

Holes become alpha, normal maps those of glTF, strands ribbons, images of base colour textures. Of
what the network knows, the fallback has a colour at each vertex and the light that leaves there, at
most. Geometry and textures that the package holds are not stored again.
"""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rna_sdk import __version__
from rna_sdk.package.geometry import gltf_model as gltf
from rna_sdk.package.geometry.curves import Curves
from rna_sdk.package.geometry.glb_reader import split_glb
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from rna_sdk.package.geometry.quantised_mesh import quantise_mesh
from rna_sdk.package.gltf.fallback_file import FallbackFile
from rna_sdk.package.gltf.fallback_glow import Palette, add_glow
from rna_sdk.package.gltf.fallback_looks import Looks, Print, prints_of
from rna_sdk.package.gltf.strand_ribbons import MAX_TRIANGLES, ribbons
from rna_sdk.package.manifest.extensions import Standin, StandinMaterial, StandinTextures, of_part
from rna_sdk.package.manifest.manifest_fields import Record
from rna_sdk.package.package import Package
from rna_sdk.package.textures.base_color import WHITE

_GREY = StandinMaterial(base_color=(0.5, 0.5, 0.5), roughness=1.0, metallic=0.0)
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


def glb_of(
    package: Package,
    colors: Mapping[int, VertexColors] | None = None,
    glows: Mapping[int, Palette] | None = None,
) -> bytes:
    """A package as a .glb that other viewers show, too: metres, +Y up, a node for each part.

    A package without stand-in materials (RNA_standin) gets grey ones. Textures of these, and else
    colors, take the place of the base colour. colors: of the vertices of some parts, by the part's
    number. glows: emission of some parts, with a place for each vertex, or one for all of them.
    """
    file = FallbackFile(package)
    manifest = package.manifest
    for i, part in enumerate(manifest.parts):
        mesh = _mesh(file, package, i)
        base = of_part(manifest, Standin, i) or _GREY
        textures = of_part(manifest, StandinTextures, i)
        vertex_colors = None if textures else (colors or {}).get(i)
        holes, reliefs = package.transmittance(i), package.normal_maps(i)
        prints: list[Print] = []
        if vertex_colors is not None:
            if vertex_colors.base is not None:
                prints = prints_of(part.base_color, holes)
            base = base.model_copy(update={"base_color": WHITE})
            rest = _without_prints(vertex_colors, prints, package.mesh(i).triangles)
            mesh.attributes["COLOR_0"] = file.colors(rest)
        glow = {}
        if (palette := (glows or {}).get(i)) is not None:
            places = np.broadcast_to(palette.places, (mesh.count, 2))
            glow = add_glow(file, mesh.attributes, palette._replace(places=places))
        looks = Looks(file, part.name, base, holes, reliefs, prints, dict(textures or ()), glow)
        file.add("meshes", {"name": part.name, "primitives": mesh.primitives(looks)})
        file.add("nodes", {"mesh": i, "name": part.name, **mesh.transform})
    return file.packed(
        generator=f"rna-info {__version__}",
        copyright=f"{manifest.provenance.source}; {manifest.license}",
    )


def _without_prints(
    colors: VertexColors, prints: Sequence[Print], triangles: NDArray[np.uint32]
) -> NDArray[np.float32]:
    """Colours of vertices (v, 3), divided by the base colour where a texture has that."""
    result = colors.color.copy()
    for each in prints:
        vertices = np.unique(triangles[each.first : each.first + each.count])
        base = colors.base[vertices] if colors.base is not None else 1.0
        result[vertices] = colors.color[vertices] / np.maximum(base, _DARK)
    return result


def _mesh(file: FallbackFile, package: Package, part: int) -> "_PartMesh":
    """The geometry of a part, in place if the package has it in a form that glTF knows."""
    geometry, name = package.geometry(part), package.manifest.parts[part].geometry
    if isinstance(geometry, Curves):
        most = int(_STRAND_SHARE * len(package.file_data)) // _TRIANGLE_BYTES
        most = min(MAX_TRIANGLES, max(most, _FEWEST_TRIANGLES))
        data = memoryview(mesh_to_glb(quantise_mesh(ribbons(geometry, most))))
        return _PartMesh(file, data, file.append(data), name)
    data, start = package.entry(name)
    return _PartMesh(file, data, file.append(data) if start is None else start, name)


class _PartMesh:
    """The mesh of a package's own .glb, whose bytes are at `start` of the buffer.

    Attributes:
        attributes: accessors by name.
        count: of vertices.
        transform: members of the node, those of quantised positions.
    """

    def __init__(self, file: FallbackFile, data: memoryview, start: int, name: str) -> None:
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
        self.count = document.accessors[primitive.attributes.POSITION].count
        self.transform = _dumped(node, "translation", "scale")
        named = _dumped(primitive.attributes, *gltf.Attributes.model_fields)
        self.attributes = {
            which: self._add(document.accessors[number]) for which, number in named.items()
        }

    def primitives(self, looks: Looks) -> list[dict[str, Any]]:
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
