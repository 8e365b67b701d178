"""An opened package: the public way to read a `.rna` file."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike
from types import TracebackType

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import PackageError, QueryError
from rna_sdk.package.container.zip_container import Container
from rna_sdk.package.geometry.curves import Curves
from rna_sdk.package.geometry.geometry_files import Geometry, geometry_from_bytes
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.geometry.source_vertices import SourceVertices, source_vertices_from_bytes
from rna_sdk.package.geometry.vertex_visibility import (
    Harmonics,
    vertex_count,
    visibility_from_bytes,
)
from rna_sdk.package.gltf.carrier import Carrier
from rna_sdk.package.manifest.extensions import (
    Environment,
    EnvironmentPart,
    Mixture,
    Poster,
    Proxy,
    ProxyLevel,
    Source,
    StandinTextures,
    Variants,
    changed_record,
    extension,
    of_part,
    part_sampling,
)
from rna_sdk.package.manifest.manifest_model import BaseColorFields, Manifest, Part
from rna_sdk.package.manifest.manifest_tiers import Tier, TierPart
from rna_sdk.package.textures.base_color import BaseColor, image_from_bytes, label_of
from rna_sdk.package.textures.normal_maps import NORMALS, NormalMap
from rna_sdk.package.textures.planes import Planes, planes_from_bytes
from rna_sdk.package.textures.texture_form import Texture
from rna_sdk.package.textures.transmittance import Transmittance, texture_from_bytes
from rna_sdk.package.validator import inspect


@dataclass(frozen=True, eq=False)
class EnvironmentLobes:
    """Lobes of a part (RNA_environment): light of a whole environment by one query a point.

    Attributes:
        record: the part's record in the manifest.
        planes: inputs of the decoder, as returned by `Package.planes`.
        decoder: the ONNX model, read-only bytes.
        harmonics: (vertices, 16) int8, read-only: 127 times the visibility's coefficients at the
            mesh's vertices or the curves' points; None if the decoder takes none.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     lobes = package.environment()
        >>> 0 if lobes is None else lobes.record.lobes % 2  # none, or an even number
        0
    """

    record: EnvironmentPart
    planes: Planes
    decoder: memoryview
    harmonics: Harmonics | None


class Package:
    """A valid package, in memory; created by `Package.open`.

    Returned arrays are read-only views of the file's bytes. They remain valid after `close`, and
    whatever happens to the file.

    Attributes:
        manifest: the manifest, immutable.
        carrier: the `.glb` that the package was read from; None for a `.rna`.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     mesh, tier = package.mesh(), package.manifest.tiers[0]
        ...     planes = package.planes(tier.name)
        >>> planes.texels.shape, mesh.triangles.shape[1]  # int8 planes
        ((3, 256, 256, 8), 3)
    """

    def __init__(
        self, container: Container, manifest: Manifest, carrier: Carrier | None = None
    ) -> None:
        self._container: Container | None = container
        self.manifest, self.carrier = manifest, carrier

    @classmethod
    def open(cls, path: str | PathLike[str]) -> "Package":
        """Read and fully validate the file at `path`: a `.rna`, or a `.glb` that carries one.

        Raises:
            PackageError: the file cannot be read or violates the format; see its `issues`.
        """
        result = inspect(path)
        if result.errors or result.container is None or result.manifest is None:
            raise PackageError(result.errors, path)
        return cls(result.container, result.manifest, result.carrier)

    def __repr__(self) -> str:
        if self._container is None:
            return f"<Package {self.manifest.name!r}, closed>"
        kinds = ", ".join(f"{part.name} ({part.kind})" for part in self.manifest.parts)
        tiers = ", ".join(tier.name for tier in self.manifest.tiers)
        size = f"{self.file_bytes:,} bytes"
        return f"<Package {self.manifest.name!r}: {kinds}; tiers {tiers}; {size}>"

    @property
    def file_bytes(self) -> int:
        """Size of the `.rna` in bytes.

        Raises:
            QueryError: the package is closed.
        """
        return len(self.file_data)

    @property
    def file_data(self) -> memoryview:
        """The bytes of the `.rna`, read-only, wherever it was read from.

        Raises:
            QueryError: the package is closed.
        """
        return self._opened().data

    def entry(self, name: str) -> tuple[memoryview, int | None]:
        """The bytes of an entry, read-only, and where they start in `file_data`.

        An entry that is stored in coded form (RNA_deflate) is decoded, and is nowhere in the file.

        Raises:
            QueryError: the package has no such entry, or is closed.
        """
        container = self._opened()
        if name not in container.entries:
            raise QueryError(f"no entry {name!r} in this package")
        return container.view(name), container.place(name)

    def close(self) -> None:
        """Release the file. Further calls have no effect."""
        self._container = None

    def __enter__(self) -> "Package":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.close()

    def tier(self, name: str) -> Tier:
        """The tier's record in the manifest.

        Raises:
            QueryError: the package has no tier of this name.
        """
        for tier in self.manifest.tiers:
            if tier.name == name:
                return tier
        names = ", ".join(tier.name for tier in self.manifest.tiers)
        raise QueryError(f"no tier {name!r}; this package has: {names}")

    def geometry(self, part: int = 0, pixels: float = math.inf) -> Geometry:
        """The mesh or curves of a part, according to its kind; object space, metres.

        part: index of the part.
        pixels: height in the image of the sphere about the bounds of all parts. A part with
            proxies (RNA_proxy) returns the coarsest one meant for at least this height.

        Raises:
            QueryError: the package has no such part, or is closed.
        """
        record = self._part(part)
        levels = self._proxies(part)
        names = [record.geometry, *(level.geometry for level in levels if pixels <= level.height)]
        return geometry_from_bytes(self._view(names[-1]), names[-1], record.kind)

    def box(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Lower and upper corner of the box about the geometry of all parts, each (3,) float32.

        Object space, metres. `bounds` of the manifest may be larger.

        Raises:
            QueryError: the package is closed.
        """
        boxes = [self.geometry(part).box() for part in range(len(self.manifest.parts))]
        low, high = zip(*boxes, strict=True)
        return np.min(low, axis=0), np.max(high, axis=0)

    def proxy_heights(self, part: int = 0) -> tuple[int, ...]:
        """Largest height in pixels that each proxy of a part is meant for, descending.

        See `geometry`.

        Raises:
            QueryError: the package has no such part.
        """
        self._part(part)
        return tuple(level.height for level in self._proxies(part))

    def poster(self) -> bytes | None:
        """The asset's preview image as PNG bytes (RNA_poster); None if there is none.

        Raises:
            QueryError: the package is closed.
        """
        data = extension(self.manifest, Poster)
        return bytes(self._view(data.image)) if data else None

    def standin_textures(self, part: int = 0) -> dict[str, bytes] | None:
        """PNG textures of a part's stand-in material (RNA_standin_textures); None if it has none.

        By name, as in glTF: `base_color`, `metallic_roughness` and `normal`.

        Raises:
            QueryError: the package has no such part, or is closed.
        """
        self._part(part)
        names = of_part(self.manifest, StandinTextures, part)
        return {member: bytes(self._view(name)) for member, name in names} if names else None

    def mesh(self, part: int = 0, pixels: float = math.inf) -> Mesh:
        """The mesh of a surface part, object space, metres; arguments as for `geometry`.

        Raises:
            QueryError: no such part, the part is not a surface, or the package is closed.
        """
        geometry = self.geometry(part, pixels)
        if not isinstance(geometry, Mesh):
            raise QueryError(f"a {self._part(part).kind} part has no mesh; ask for its curves()")
        return geometry

    def curves(self, part: int = 0, pixels: float = math.inf) -> Curves:
        """The curves of a fiber part, object space, metres; arguments as for `geometry`.

        Raises:
            QueryError: no such part, the part is not of fibers, or the package is closed.
        """
        geometry = self.geometry(part, pixels)
        if not isinstance(geometry, Curves):
            raise QueryError(f"a {self._part(part).kind} part has no curves; ask for its mesh()")
        return geometry

    def source_vertices(self, part: int = 0) -> SourceVertices | None:
        """Which vertex of the source each vertex of a part came from (RNA_source).

        None for a part without such numbers.

        Raises:
            QueryError: the package has no such part, or is closed.
        """
        self._part(part)
        data = extension(self.manifest, Source)
        name = None if data is None else data.parts[part]
        if data is None or name is None:
            return None
        vertices = len(self.mesh(part).positions)
        return source_vertices_from_bytes(self._view(name), name, vertices, data.vertices)

    def transmittance(self, part: int = 0) -> list[Transmittance]:
        """Holes and thin glass of a part, with their textures; empty if it is opaque.

        Raises:
            QueryError: the package has no such part, or is closed.
        """
        return [
            Transmittance(
                *record.triangles,
                texture_from_bytes(self._view(record.texture), record),
                record.cutoff,
                record.ior,
            )
            for record in self._part(part).transmittance
        ]

    def normal_maps(self, part: int = 0) -> list[NormalMap]:
        """The normal maps of a part; empty if it has none.

        Raises:
            QueryError: the package has no such part, or is closed.
        """
        return [
            NormalMap(*r.triangles, NORMALS.from_bytes(self._view(r.texture), r.texture))
            for r in self._part(part).normal_maps
        ]

    def variants(self) -> tuple[str, ...]:
        """Names of the variants of base colours (RNA_variants), for `base_color` and `load`."""
        data = extension(self.manifest, Variants)
        return tuple(variant.name for variant in data.variants) if data else ()

    def base_color(self, part: int = 0, variant: str | None = None) -> list[BaseColor]:
        """Base colour of a part, with its images; empty if it has none.

        variant: one of `variants`; None for the default base colours.

        Raises:
            PackageError: an image cannot be decoded.
            QueryError: the package has no such part or variant, or is closed.
        """
        stored = self._part(part).base_color
        records = [
            changed_record(record, change)
            for record, change in zip(stored, self._changes(part, variant), strict=True)
        ]
        images: dict[str, Texture] = {}
        for record in records:
            if record.image is not None and record.image not in images:
                images[record.image] = image_from_bytes(self._view(record.image), record.image)
        return [
            BaseColor.of(record, images.get(record.image or ""), label_of(usual) or None)
            for usual, record in zip(stored, records, strict=True)
        ]

    def _changes(self, part: int, variant: str | None) -> Sequence[BaseColorFields | None]:
        data = extension(self.manifest, Variants)
        for one in data.variants if data else ():
            if one.name == variant and (changes := one.parts[part]) is not None:
                return changes
        if variant not in (None, *self.variants()):
            known = ", ".join(map(repr, self.variants())) or "none: it has no variants"
            raise QueryError(f"found the variant {variant!r}, expected one of: {known}")
        return [None] * len(self._part(part).base_color)

    def planes(self, tier: str, part: int = 0) -> Planes:
        """A part's triplane, planes XY, YZ, ZX: an array (3, R, R, C), or Int8Planes.

        Raises:
            QueryError: the package has no such tier or part, or is closed.
        """
        record = self._tier_part(tier, part)
        return planes_from_bytes(self._view(record.planes), record)

    def decoder(self, tier: str, part: int = 0, form: str | None = None) -> memoryview:
        """The ONNX model of a part's decoder, read-only bytes.

        form: of one of the tier part's `decoders`, such as "emission"; None for the first, of
            transport or of visible light.

        Raises:
            QueryError: the package has no such tier, part or decoder, or is closed.
        """
        for record in self._tier_part(tier, part).decoders:
            if form in (None, record.form.name):
                return self._view(record.entry)
        raise QueryError(f"no decoder of {form} in part {part} of tier {tier!r}")

    def sampling(self, part: int = 0) -> tuple[Mixture, ...]:
        """Mixtures of lobes for rays that leave a part (RNA_sampling), by triangles.

        Without any, the usual one of its kind.

        Raises:
            QueryError: the package has no such part.
        """
        self._part(part)
        return part_sampling(self.manifest, part)

    def environment(self, part: int = 0) -> EnvironmentLobes | None:
        """The lobes of a part (RNA_environment), made for its full geometry; None if it has none.

        Raises:
            QueryError: the package has no such part, or is closed.
        """
        self._part(part)
        record = of_part(self.manifest, Environment, part)
        if record is None:
            return None
        harmonics = None
        if (name := record.visibility) is not None:
            vertices = vertex_count(self.geometry(part))
            harmonics = visibility_from_bytes(self._view(name), name, vertices)
        planes = planes_from_bytes(self._view(record.planes), record)
        return EnvironmentLobes(record, planes, self._view(record.decoder), harmonics)

    def _proxies(self, part: int) -> tuple[ProxyLevel, ...]:
        return of_part(self.manifest, Proxy, part) or ()

    def _part(self, part: int) -> Part:
        parts = self.manifest.parts
        if not 0 <= part < len(parts):
            raise QueryError(f"no part {part}; this package has {len(parts)}, counted from 0")
        return parts[part]

    def _tier_part(self, tier: str, part: int) -> TierPart:
        self._part(part)
        return self.tier(tier).parts[part]

    def _view(self, entry: str) -> memoryview:
        return self._opened().view(entry)

    def _opened(self) -> Container:
        if self._container is None:
            raise QueryError("the package is closed")
        return self._container
