"""Write a package: the same input gives the same bytes, and never a file that is not valid."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path

from rna_sdk.errors import PackageError
from rna_sdk.package.container import MANIFEST_NAME
from rna_sdk.package.container_writer import write_container
from rna_sdk.package.geometry import Geometry, geometry_to_bytes
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.manifest import EntryRecord, Manifest
from rna_sdk.package.planes import DTYPES, Planes, planes_to_bytes
from rna_sdk.package.validator import inspect


@dataclass(frozen=True, eq=False)
class TierData:
    """The data of one tier.

    Attributes:
        planes: (3, R, R, C) float16 or float32, or Int8Planes, as the manifest's tier says.
        decoder: the serialized ONNX model.
    """

    planes: Planes
    decoder: bytes


def write_package(
    path: str | PathLike[str], manifest: Manifest, geometry: Geometry, tiers: Mapping[str, TierData]
) -> Manifest:
    """Write a package to `path`, whole or not at all.

    The file is written under a temporary name beside `path`, validated, and then renamed.

    Args:
        path: the `.rna` file to make or replace.
        manifest: the manifest; its `entries` are computed here.
        geometry: a Mesh for a surface asset, Curves for a fiber asset.
        tiers: the data of every tier of the manifest, by name.

    Returns:
        The manifest as written, with entries.

    Raises:
        PackageError: what was given does not make a valid package.
        OSError: the file cannot be written.
    """
    contents = _contents(manifest, geometry, tiers)
    records = {
        name: EntryRecord(size=len(data), sha256=hashlib.sha256(data).hexdigest())
        for name, data in contents.items()
    }
    complete = manifest.model_copy(update={"entries": records})
    entries = [(MANIFEST_NAME, manifest_to_json(complete)), *contents.items()]
    target = Path(path)
    temporary = target.with_name(f".{target.name}.{os.getpid()}.partial")
    try:
        with open(temporary, "wb") as file:
            write_container(file, entries)
            file.flush()
            os.fsync(file.fileno())
        errors = inspect(temporary).errors
        if errors:
            raise PackageError(errors, path)
        os.replace(temporary, target)
    finally:
        temporary.unlink(missing_ok=True)
    return complete


def manifest_to_json(manifest: Manifest) -> bytes:
    """manifest.json: UTF-8, two spaces of indentation, fields in the order of the model."""
    fields = manifest.model_dump(mode="json", by_alias=True)
    return (json.dumps(fields, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()


def _contents(
    manifest: Manifest, geometry: Geometry, tiers: Mapping[str, TierData]
) -> dict[str, bytes]:
    """Entry name -> data, in the order of the file: geometry, then planes and decoders."""
    names = [tier.name for tier in manifest.tiers]
    if sorted(names) != sorted(tiers):
        refuse(Code.REFERENCE_MISSING, "/tiers", f"data of {sorted(tiers)}", f"of {sorted(names)}")
    contents = {manifest.geometry: geometry_to_bytes(geometry, manifest.kind)}
    for i, tier in enumerate(manifest.tiers):
        data = tiers[tier.name]
        if data.planes.dtype.name not in DTYPES:
            where = f"/tiers/{i}/planePrecision"
            refuse(Code.PLANES_DTYPE, where, data.planes.dtype, tier.plane_precision)
        made = {tier.planes: planes_to_bytes(data.planes), tier.decoder: bytes(data.decoder)}
        for name, value in made.items():
            # Tiers may share an entry, but then it must be the same.
            if contents.setdefault(name, value) != value:
                refuse(Code.ENTRY_HASH, f"/tiers/{i}", f"other data for {name}", "one content")
    return contents
