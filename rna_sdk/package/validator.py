"""Check a whole package: container, manifest, entries, then what is inside each entry."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from os import PathLike

from rna_sdk.errors import PackageError
from rna_sdk.package.container.strict_json import pointer
from rna_sdk.package.container.zip_container import MANIFEST_NAME, Container
from rna_sdk.package.decoder.decoder_checks import check_decoder
from rna_sdk.package.decoder.decoder_form import PartDecoder
from rna_sdk.package.geometry.geometry_files import Geometry, geometry_from_bytes
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.geometry.source_vertices import source_vertices_from_bytes
from rna_sdk.package.geometry.vertex_visibility import vertex_count, visibility_from_bytes
from rna_sdk.package.issues import Code, Issue, Severity
from rna_sdk.package.manifest.deflate import decoded_entry
from rna_sdk.package.manifest.extensions import (
    Deflate,
    Environment,
    Proxy,
    Source,
    extension,
    variant_records,
)
from rna_sdk.package.manifest.manifest_checks import manifest_warnings
from rna_sdk.package.manifest.manifest_fields import Bounds
from rna_sdk.package.manifest.manifest_model import Manifest, NormalMapRecord, TransmittanceRecord
from rna_sdk.package.manifest.manifest_reader import parse_manifest
from rna_sdk.package.manifest.manifest_tiers import TierPartFields
from rna_sdk.package.manifest.pictures import poster_issues, texture_issues
from rna_sdk.package.textures.base_color import check_base_color, image_from_bytes
from rna_sdk.package.textures.normal_maps import NORMALS, check_normal_maps
from rna_sdk.package.textures.planes import check_finite, planes_from_bytes
from rna_sdk.package.textures.texture_form import Texture
from rna_sdk.package.textures.transmittance import check_records, texture_from_bytes

_OUTSIDE_TOLERANCE = 1e-4
"""Part of the bounds' extent that geometry may lie outside before a warning says so."""


@dataclass
class Inspection:
    """Result of a full check of a file.

    Attributes:
        container, manifest: None where the file is too broken to have one.
        issues: all findings, in the order of the checks.
    """

    container: Container | None = None
    manifest: Manifest | None = None
    issues: list[Issue] = field(default_factory=list)

    @property
    def errors(self) -> list[Issue]:
        return [issue for issue in self.issues if issue.severity is Severity.ERROR]

    @contextmanager
    def collect(self) -> Iterator[None]:
        """Note the issues that stop the block, and go on behind it."""
        try:
            yield
        except PackageError as error:
            self.issues += error.issues


def validate(path: str | PathLike[str]) -> list[Issue]:
    """All issues of the file; a package is valid when none is an error.

    Nothing in the file is executed, unpickled or extracted, and no size is trusted before it
    was checked. Does not raise for anything the file holds.

    Examples:
        >>> validate("toy.rna")
        []
        >>> validate("no-such-file.rna")[0].code
        'FILE_UNREADABLE'
    """
    return inspect(path).issues


def inspect(path: str | PathLike[str]) -> Inspection:
    """Check the file, and keep what was opened on the way."""
    result = Inspection()
    with result.collect():
        result.container = Container.open(path)
        result.container.check_crc(MANIFEST_NAME)
        manifest = parse_manifest(bytes(result.container.view(MANIFEST_NAME)))
        result.manifest = manifest
        result.issues += manifest_warnings(manifest)
        intact = _check_entries(result, result.container, manifest)
        _decode_entries(result, result.container, manifest, intact)
        _check_contents(result, result.container, manifest, intact)
    return result


def _check_entries(result: Inspection, container: Container, manifest: Manifest) -> set[str]:
    """Compare the archive with the manifest; the names of the entries that are as declared."""
    for name, entry in container.entries.items():
        if name != MANIFEST_NAME and name not in manifest.entries:
            issue = Issue.of(Code.ENTRY_UNDECLARED, entry.header_offset, name, "a declared entry")
            result.issues.append(issue)
    intact = set()
    for name, record in manifest.entries.items():
        where = pointer("entries", name)
        if name not in container.entries:
            result.issues.append(Issue.of(Code.ENTRY_MISSING, where, "nothing", name))
            continue
        size = container.entries[name].size
        if size != record.size:
            issue = Issue.of(Code.ENTRY_SIZE, f"{where}/size", f"{size} bytes", record.size)
            result.issues.append(issue)
            continue
        with result.collect():
            container.check_crc(name)
            digest = hashlib.sha256(container.view(name)).hexdigest()
            if digest == record.sha256:
                intact.add(name)
            else:
                issue = Issue.of(Code.ENTRY_HASH, f"{where}/sha256", digest, record.sha256)
                result.issues.append(issue)
    return intact


def _decode_entries(
    result: Inspection, container: Container, manifest: Manifest, intact: set[str]
) -> None:
    """Decode coded entries in the container; entries that fail are removed from `intact`."""
    data = extension(manifest, Deflate)
    for name, coding in (data.entries if data else {}).items():
        if name in intact:
            intact.discard(name)
            with result.collect():
                container.put_decoded(name, decoded_entry(container.stored(name), name, coding))
                intact.add(name)


def _check_contents(
    result: Inspection, container: Container, manifest: Manifest, intact: set[str]
) -> None:
    vertices: dict[int, int] = {}  # of parts whose geometry is good
    for k, part in enumerate(manifest.parts):
        if part.geometry in intact:
            with result.collect():
                view = container.view(part.geometry)
                geometry = geometry_from_bytes(view, part.geometry, part.kind)
                vertices[k] = vertex_count(geometry)
                result.issues += _outside(geometry, part.bounds, pointer("parts", k, "bounds"))
                if isinstance(geometry, Mesh):
                    _check_source(container, manifest, k, geometry, intact)
                    result.issues += texture_issues(container, manifest, k, geometry, intact)
                    textures = _Textures(result, container, intact)
                    where = pointer("parts", k, "transmittance")
                    check_records(part, geometry, textures.of_transmittance, where)
                    where = pointer("parts", k, "normalMaps")
                    check_normal_maps(part, geometry, textures.of_normals, where)
                    where = pointer("parts", k, "baseColor")
                    more = variant_records(manifest, k)
                    check_base_color(part, geometry, textures.of_image, where, more)
    result.issues += poster_issues(container, manifest, intact)
    _check_proxies(result, container, manifest, intact)
    checked: set[object] = set()  # tiers and parts may share entries
    for tier in manifest.tiers:
        for tier_part in tier.parts:
            _check_planes(result, container, tier_part, intact, checked)
            for decoder in tier_part.decoders:
                _check_decoder(result, container, decoder, intact, checked)
    data = extension(manifest, Environment)
    for k, record in enumerate(data.parts if data else ()):
        if record is not None:
            _check_planes(result, container, record, intact, checked)
            _check_decoder(result, container, record.optional_decoder, intact, checked)
            name = record.visibility
            if name is not None and name in intact and k in vertices:
                with result.collect():
                    visibility_from_bytes(container.view(name), name, vertices[k])


def _check_source(
    container: Container, manifest: Manifest, part: int, mesh: Mesh, intact: set[str]
) -> None:
    data = extension(manifest, Source)
    name = None if data is None else data.parts[part]
    if data is not None and name is not None and name in intact:
        view = container.view(name)
        source_vertices_from_bytes(view, name, len(mesh.positions), data.vertices)


def _check_proxies(
    result: Inspection, container: Container, manifest: Manifest, intact: set[str]
) -> None:
    data = extension(manifest, Proxy)
    for part, proxies in zip(manifest.parts, data.parts if data else (), strict=False):
        for proxy in proxies or ():
            if proxy.geometry in intact:
                with result.collect():
                    view = container.view(proxy.geometry)
                    geometry_from_bytes(view, proxy.geometry, part.kind)


def _check_planes(
    result: Inspection,
    container: Container,
    part: TierPartFields,
    intact: set[str],
    checked: set[object],
) -> None:
    form = part.planes, part.resolution, part.channels, part.plane_precision
    if part.planes in intact and form not in checked:
        checked.add(form)
        with result.collect():
            check_finite(planes_from_bytes(container.view(part.planes), part), part.planes)


def _check_decoder(
    result: Inspection,
    container: Container,
    decoder: PartDecoder,
    intact: set[str],
    checked: set[object],
) -> None:
    if decoder.entry in intact and decoder not in checked:
        checked.add(decoder)
        with result.collect():
            result.issues += check_decoder(container.view(decoder.entry), decoder)


class _Textures:
    """The textures of one part; each issue is reported once."""

    def __init__(self, result: Inspection, container: Container, intact: set[str]) -> None:
        self._result, self._container, self._intact = result, container, intact
        self._refused: set[tuple[str, bool]] = set()

    def of_transmittance(self, record: TransmittanceRecord) -> Texture | None:
        """The record's texture; None where it is not as it must be."""
        has_cutoff = record.cutoff is not None
        return self._read(record.texture, has_cutoff, lambda data: texture_from_bytes(data, record))

    def of_normals(self, record: NormalMapRecord) -> Texture | None:
        """The normal map of a record, or None if it is invalid."""
        return self._read(
            record.texture, False, lambda data: NORMALS.from_bytes(data, record.texture)
        )

    def of_image(self, entry: str) -> Texture | None:
        """The image of base colour in an entry, or None if it cannot be decoded."""
        return self._read(entry, False, lambda data: image_from_bytes(data, entry))

    def _read(
        self, entry: str, has_cutoff: bool, parse: Callable[[memoryview], Texture]
    ) -> Texture | None:
        if entry in self._intact and (entry, has_cutoff) not in self._refused:
            with self._result.collect():
                return parse(self._container.view(entry))
            self._refused.add((entry, has_cutoff))
        return None


def _outside(geometry: Geometry, bounds: Bounds, where: str) -> list[Issue]:
    low, high = (corner.tolist() for corner in geometry.box())
    for axis in range(3):
        slack = _OUTSIDE_TOLERANCE * (bounds.max[axis] - bounds.min[axis])
        if low[axis] < bounds.min[axis] - slack or high[axis] > bounds.max[axis] + slack:
            found = f"{low[axis]:.6g} to {high[axis]:.6g} along {'xyz'[axis]}"
            expected = f"{bounds.min[axis]:.6g} to {bounds.max[axis]:.6g}"
            return [Issue.of(Code.GEOMETRY_OUTSIDE, where, found, expected)]
    return []
