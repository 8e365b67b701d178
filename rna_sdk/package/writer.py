"""Write a package: the same input gives the same bytes, and never a file that is not valid."""

import hashlib
import json
import os
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path

from rna_sdk.errors import PackageError
from rna_sdk.files.atomic_file import atomic_file
from rna_sdk.package.container.strict_json import pointer
from rna_sdk.package.container.zip_container import MANIFEST_NAME
from rna_sdk.package.container.zip_writer import write_container
from rna_sdk.package.geometry.geometry_files import Geometry, geometry_to_bytes
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.manifest.manifest_fields import Record, references
from rna_sdk.package.manifest.manifest_model import EntryRecord, Manifest
from rna_sdk.package.manifest.manifest_tiers import Tier, TierPart
from rna_sdk.package.textures.normal_maps import NORMALS
from rna_sdk.package.textures.planes import DTYPES, Planes, planes_to_bytes
from rna_sdk.package.textures.texture_form import Texture
from rna_sdk.package.textures.transmittance import TRANSMITTANCE
from rna_sdk.package.validator import inspect


@dataclass(frozen=True, eq=False)
class TierData:
    """The data of one part in one tier.

    Attributes:
        planes: (3, R, R, C) float16 or float32, or Int8Planes, as in the manifest's tier part.
        decoder: serialized ONNX model of transport, or of visible light.
        others: models of the tier part's other forms, by name ("shadowed", "emission").
    """

    planes: Planes
    decoder: bytes
    others: Mapping[str, bytes] = field(default_factory=dict)


def write_package(
    path: str | PathLike[str],
    manifest: Manifest,
    geometries: Sequence[Geometry],
    data: Mapping[str, Sequence[TierData]],
    textures: Mapping[str, Texture | bytes] | None = None,
) -> Manifest:
    """Write a package to `path`, atomically.

    The file is written under a temporary name beside `path`, validated, and renamed. Entries that
    the manifest names twice are stored once.

    Args:
        path: the `.rna` file to create or replace.
        manifest: the manifest; its `entries` are computed here. Posters and proxies are not
            supported; `rna-export` adds them.
        geometries: one per part: a Mesh for a surface, Curves for fibers.
        data: for each tier, by name, the data of each part.
        textures: by entry name: transmittance textures and normal maps as (H, W, C) uint8, images
            of base colour as bytes of their files.

    Returns:
        The manifest as written.

    Raises:
        PackageError: the arguments do not form a valid package.
        OSError: the file cannot be written.

    Examples:
        >>> with Package.open("curls.rna") as package:
        ...     curves, name = package.curves(), "small"
        ...     part = TierData(package.planes(name), bytes(package.decoder(name)))
        ...     bare = {"extensions": {}, "extensions_used": ()}
        ...     manifest = package.manifest.model_copy(update=bare)
        >>> written = write_package("copy.rna", manifest, [curves], {name: [part]})
        >>> written.tiers[0].name
        'small'
    """
    contents = _Contents(manifest)
    contents.add_parts(geometries, textures or {})
    contents.add_tiers(data)
    return write_entries(path, manifest, contents.entries)


def write_entries(
    path: str | PathLike[str], manifest: Manifest, contents: Mapping[str, bytes]
) -> Manifest:
    """Like `write_package`, from serialized entries, name -> data."""
    records = {
        name: EntryRecord(size=len(value), sha256=hashlib.sha256(value).hexdigest())
        for name, value in contents.items()
    }
    complete = manifest.model_copy(update={"entries": records})
    entries = [(name, contents[name]) for name in _ordered(manifest, records)]
    return _write(Path(path), [(MANIFEST_NAME, _manifest_bytes(complete)), *entries])


def _write(target: Path, entries: list[tuple[str, bytes]]) -> Manifest:
    with atomic_file(target) as temporary:
        with open(temporary, "wb") as file:
            write_container(file, entries)
            file.flush()
            os.fsync(file.fileno())
        result = inspect(temporary)
        if result.errors or result.manifest is None:
            raise PackageError(result.errors, target)
    return result.manifest


def _ordered(manifest: Manifest, entries: Iterable[str]) -> list[str]:
    """The entries behind the manifest: those that every tier needs first.

    Geometry and textures; what several tiers share; what each tier has alone, tier after tier; the
    others, which are those of extensions, in their own order. A reader then finds all of one tier
    in two ranges of bytes.
    """
    tier_names = [dict.fromkeys(_names(tier.parts)) for tier in manifest.tiers]
    users = Counter(name for names in tier_names for name in names)
    of_tiers = [name for names in tier_names for name in names]
    shared = [name for name in of_tiers if users[name] > 1]
    return list(dict.fromkeys([*_names(manifest.parts), *shared, *of_tiers, *entries]))


def _names(records: tuple[Record, ...]) -> list[str]:
    """Entries that the records name, some perhaps twice."""
    return [entry for _, entry in references(records)]


def _manifest_bytes(manifest: Manifest) -> bytes:
    """manifest.json: UTF-8, two spaces of indentation, members in the order of the model."""
    fields = manifest.model_dump(mode="json", by_alias=True)
    return (json.dumps(fields, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()


def _texture_bytes(member: str | int, texture: Texture | bytes, entry: str) -> bytes:
    """The entry of a texture that a record in this member of a part names."""
    if isinstance(texture, bytes):
        return texture
    form = TRANSMITTANCE if member == "transmittance" else NORMALS
    return form.to_bytes(texture, entry)


class _Contents:
    """Gathers the entries of a package.

    Attributes:
        entries: name -> data.
    """

    def __init__(self, manifest: Manifest) -> None:
        self._manifest = manifest
        self.entries: dict[str, bytes] = {}

    def add_parts(
        self, geometries: Sequence[Geometry], textures: Mapping[str, Texture | bytes]
    ) -> None:
        """Geometry and textures of every part."""
        parts = self._manifest.parts
        if len(geometries) != len(parts):
            found, expected = f"{len(geometries)} geometries", f"{len(parts)}, one a part"
            refuse(Code.PARTS_DIFFER, "/parts", found, expected)
        for k, (part, geometry) in enumerate(zip(parts, geometries, strict=True)):
            for path, entry in references(part):
                where = pointer("parts", k, *path)
                if path[0] == "geometry":
                    self._add(where, entry, geometry_to_bytes(geometry, part.kind, where))
                elif entry in textures:
                    self._add(where, entry, _texture_bytes(path[0], textures[entry], entry))
                else:
                    refuse(Code.REFERENCE_MISSING, where, "no such texture", entry)

    def add_tiers(self, data: Mapping[str, Sequence[TierData]]) -> None:
        """Planes and decoders of every tier."""
        tiers = self._manifest.tiers
        names = [tier.name for tier in tiers]
        if sorted(names) != sorted(data):
            found, expected = f"data of {sorted(data)}", f"of {sorted(names)}"
            refuse(Code.REFERENCE_MISSING, "/tiers", found, expected)
        for i, tier in enumerate(tiers):
            self._add_tier(i, tier, data[tier.name])

    def _add_tier(self, i: int, tier: Tier, data: Sequence[TierData]) -> None:
        if len(data) != len(tier.parts):
            found, expected = f"data of {len(data)} parts", f"of {len(tier.parts)}"
            refuse(Code.PARTS_DIFFER, f"/tiers/{i}", found, expected)
        for k, (part, part_data) in enumerate(zip(tier.parts, data, strict=True)):
            self._add_tier_part(i, k, part, part_data)

    def _add_tier_part(self, i: int, k: int, part: TierPart, data: TierData) -> None:
        where = pointer("tiers", i, "parts", k)
        if data.planes.dtype.name not in DTYPES:
            dtype, expected = data.planes.dtype, part.plane_precision
            refuse(Code.PLANES_DTYPE, f"{where}/planePrecision", dtype, expected)
        self._add(where, part.planes, planes_to_bytes(data.planes))
        declared = {decoder.form.name: decoder for decoder in part.decoders}
        decoders = {part.decoders[0].form.name: data.decoder, **data.others}
        for name in [*(decoders.keys() - declared), *(declared.keys() - decoders)]:
            found = "one" if name in decoders else "none"
            refuse(Code.PARTS_DIFFER, f"{where}/{name}", f"{found} in the data", "as here")
        for name, decoder in declared.items():
            self._add("/".join((where, *decoder.form.path)), decoder.entry, bytes(decoders[name]))

    def _add(self, where: str, name: str, data: bytes) -> None:
        """Parts and tiers may share an entry, but then it must be the same."""
        if self.entries.setdefault(name, data) != data:
            refuse(Code.ENTRY_HASH, where, f"other data for {name}", "one content")
