"""Change a package entry by entry, without its models: code its entries, add a poster or lobes."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from os import PathLike

from pydantic import JsonValue

from rna_sdk.errors import PackageError
from rna_sdk.package.geometry.geometry_files import Geometry, geometry_to_bytes
from rna_sdk.package.geometry.source_vertices import SourceVertices
from rna_sdk.package.geometry.vertex_visibility import Harmonics, visibility_to_bytes
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.manifest.deflate import encode, largest_decoded
from rna_sdk.package.manifest.extensions import (
    Coding,
    Deflate,
    Environment,
    EnvironmentPart,
    EnvironmentValidation,
    Extension,
    PartTextures,
    Poster,
    Proxy,
    Source,
    StandinTextures,
    extension,
)
from rna_sdk.package.manifest.manifest_fields import GEOMETRY_ENTRIES, DecoderPrecision
from rna_sdk.package.manifest.manifest_model import Manifest
from rna_sdk.package.manifest.manifest_tiers import Agreement, TierPart
from rna_sdk.package.manifest.pictures import png_size
from rna_sdk.package.validator import inspect
from rna_sdk.package.writer import write_entries

_CODINGS = ((1, 0), (1, 1), (2, 0), (2, 1), (2, 3), (2, 4), (4, 0), (4, 3))
"""Element sizes and distances that are tried on an entry, beside those of its planes' channels."""


@dataclass(frozen=True, eq=False)
class Lobes:
    """Lobes of a part, for RNA_environment.

    Attributes:
        tier: name of the tier whose planes the decoder reads.
        lobes: how many, even, 2 to 32.
        inputs: names of the decoder's input blocks.
        decoder: serialized ONNX model, output `environment` of 9 columns a lobe.
        harmonics: (vertices, 16) int8 of `quantised_harmonics`, the visibility about the mesh's
            vertices or the curves' points, whose 16 numbers are the decoder's last inputs; None
            if it has no such inputs.
        precision: of the decoder.
        agreement: largest difference between decoder and trained model, if recorded.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     of_tier = package.tier("small").parts[0]
        >>> model = b"..."  # of ONNX
        >>> lobes = Lobes("small", 8, ("features", "normal", "half_vector"), model)
        >>> record, entries = lobes.entries("asset", of_tier)
        >>> record.lobes, list(entries)
        (8, ['extensions/RNA_environment/asset.onnx'])
    """

    tier: str
    lobes: int
    inputs: tuple[str, ...]
    decoder: bytes
    harmonics: Harmonics | None = None
    precision: DecoderPrecision = "float32"
    agreement: Agreement | None = None

    def entries(self, part: str, of_tier: TierPart) -> tuple[EnvironmentPart, dict[str, bytes]]:
        """Record and entries of the lobes; part: its name. of_tier: in `tier`."""
        start = f"extensions/{Environment.NAME}/{part}"
        decoder, visibility = f"{start}.onnx", f"{start}-visibility.safetensors"
        record = EnvironmentPart(
            planes=of_tier.planes,
            decoder=decoder,
            inputs=self.inputs,
            resolution=of_tier.resolution,
            channels=of_tier.channels,
            plane_precision=of_tier.plane_precision,
            decoder_precision=self.precision,
            agreement=self.agreement,
            lobes=self.lobes,
            visibility=None if self.harmonics is None else visibility,
        )
        files = {decoder: self.decoder}
        if self.harmonics is not None:
            files[visibility] = visibility_to_bytes(self.harmonics)
        return record, files


@dataclass(frozen=True)
class Unpacked:
    """A package in memory.

    Attributes:
        manifest: as it is written; its `entries` are computed anew.
        entries: name -> bytes, none of them coded.

    Examples:
        >>> package = Unpacked.read("toy.rna")
        >>> package.write("copy.rna").name
        'toy'
    """

    manifest: Manifest
    entries: Mapping[str, bytes]

    @classmethod
    def read(cls, path: str | PathLike[str]) -> Unpacked:
        """The package at `path`, its coded entries decoded.

        Raises:
            PackageError: the file cannot be read or breaks the format.
        """
        result = inspect(path)
        if result.errors or result.container is None or result.manifest is None:
            raise PackageError(result.errors, path)
        entries = {name: bytes(result.container.view(name)) for name in result.manifest.entries}
        return cls(result.manifest, entries)._without(Deflate)

    def write(self, path: str | PathLike[str]) -> Manifest:
        """Write the package whole or not at all; returns the manifest as it is read again.

        Raises:
            PackageError: it is not valid.
            OSError: the file cannot be written.
        """
        return write_entries(path, self.manifest, self.entries)

    def with_poster(self, png: bytes) -> Unpacked:
        """A copy with this PNG as its poster, which replaces any other.

        Raises:
            PackageError: POSTER_IMAGE, where the bytes are no PNG.
        """
        name, size = f"extensions/{Poster.NAME}/poster.png", png_size(png)
        if size is None:
            refuse(Code.POSTER_IMAGE, name, "no PNG", "a PNG")
        data = Poster(image=name, width=size[0], height=size[1])
        return self.with_extension(data, {name: png})

    def with_standin_textures(self, parts: Sequence[Mapping[str, bytes] | None]) -> Unpacked:
        """A copy with these PNGs of each part, by member of `PartTextures`; None for none."""
        entries: dict[str, bytes] = {}
        records: list[PartTextures | None] = []
        for part, pngs in zip(self.manifest.parts, parts, strict=True):
            start = f"extensions/{StandinTextures.NAME}/{part.name}"
            names = {member: f"{start}-{member}.png" for member in pngs or ()}
            entries |= {names[member]: png for member, png in (pngs or {}).items()}
            records.append(PartTextures(**names) if names else None)
        return self.with_extension(StandinTextures(parts=tuple(records)), entries)

    def with_proxies(self, proxies: list[list[tuple[Geometry, int]]]) -> Unpacked:
        """A copy with these proxies of each part (an empty list for none), each with its height."""
        entries, parts = {}, []
        for part, levels in zip(self.manifest.parts, proxies, strict=True):
            records: list[JsonValue] = []
            for geometry, height in levels:
                suffix = GEOMETRY_ENTRIES[part.kind].rpartition(".")[2]
                name = f"extensions/{Proxy.NAME}/{part.name}-{height}.{suffix}"
                entries[name] = geometry_to_bytes(geometry, part.kind, name)
                records.append({"geometry": name, "height": height})
            parts.append(records or None)
        return self.with_extension(Proxy.model_validate({"parts": parts}), entries)

    def with_environment(
        self, parts: Sequence[Lobes | None], validation: Sequence[EnvironmentValidation] = ()
    ) -> Unpacked:
        """A copy with these lobes of each part (None for none), which replace any others.

        validation: their error under environments that they were not trained on.

        Raises:
            KeyError: a tier is not there.
        """
        entries: dict[str, bytes] = {}
        records: list[EnvironmentPart | None] = []
        tiers = {tier.name: tier for tier in self.manifest.tiers}
        for k, (part, lobes) in enumerate(zip(self.manifest.parts, parts, strict=True)):
            record = None
            if lobes is not None:
                record, files = lobes.entries(part.name, tiers[lobes.tier].parts[k])
                entries |= files
            records.append(record)
        data = Environment(parts=tuple(records), validation=tuple(validation))
        return self.with_extension(data, entries)

    def with_source(self, parts: list[SourceVertices | None]) -> Unpacked:
        """A copy with the source's vertex of each part's vertices; None for a part without."""
        files = {
            f"extensions/{Source.NAME}/{part.name}.safetensors": vertices
            for part, vertices in zip(self.manifest.parts, parts, strict=True)
        }
        count = max(vertices.count for vertices in files.values() if vertices is not None)
        data = Source(vertices=count, parts=tuple(k if v else None for k, v in files.items()))
        return self.with_extension(data, {k: v.to_bytes() for k, v in files.items() if v})

    def with_extension(self, data: Extension, entries: Mapping[str, bytes]) -> Unpacked:
        """A copy with this data of an extension and its entries, which replace any others."""
        bare = self._without(type(data))
        manifest = bare.manifest
        changed = manifest.model_copy(
            update={
                "extensions_used": (*manifest.extensions_used, data.NAME),
                "extensions": {
                    **manifest.extensions,
                    data.NAME: data.model_dump(mode="json", by_alias=True),
                },
            }
        )
        return replace(bare, manifest=changed, entries={**bare.entries, **entries})

    def deflated(self) -> Unpacked:
        """A copy in which entries that become smaller are coded (RNA_deflate).

        Those that would inflate to more than a reader takes stay as they are.
        """
        distances = {
            part.planes: part.channels for tier in self.manifest.tiers for part in tier.parts
        }
        codings, entries = {}, dict(self.entries)
        for name, data in self.entries.items():
            size, distance, stream = _smallest(data, distances.get(name))
            if len(stream) < len(data) <= largest_decoded(len(stream)):
                entries[name] = stream
                codings[name] = Coding(
                    element_size=size,
                    distance=distance,
                    size=len(data),
                    sha256=hashlib.sha256(data).hexdigest(),
                )
        if not codings:
            return self
        coded = replace(self, entries=entries).with_extension(Deflate(entries=codings), {})
        required = (*coded.manifest.extensions_required, Deflate.NAME)
        manifest = coded.manifest.model_copy(update={"extensions_required": required})
        return replace(coded, manifest=manifest)

    def _without(self, kind: type[Extension]) -> Unpacked:
        manifest = self.manifest
        if extension(manifest, kind) is None:
            return self
        folder = f"extensions/{kind.NAME}/"
        update = {
            "extensions_used": _other(manifest.extensions_used, kind.NAME),
            "extensions_required": _other(manifest.extensions_required, kind.NAME),
            "extensions": {k: v for k, v in manifest.extensions.items() if k != kind.NAME},
        }
        entries = {k: v for k, v in self.entries.items() if not k.startswith(folder)}
        return Unpacked(manifest.model_copy(update=update), entries)


def _other(names: tuple[str, ...], name: str) -> tuple[str, ...]:
    return tuple(other for other in names if other != name)


def _smallest(data: bytes, channels: int | None) -> tuple[int, int, bytes]:
    """Element size, distance and stream of the coding that makes the fewest bytes."""
    sizes = () if channels is None else ((1, channels), (2, channels), (4, channels))
    coded = ((size, far, encode(data, size, far)) for size, far in (*_CODINGS, *sizes))
    return min(coded, key=lambda one: len(one[2]))
