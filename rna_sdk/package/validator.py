"""Check a whole package: container, manifest, entries, then the contents of each entry."""

import hashlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from os import PathLike

from rna_sdk.errors import PackageError
from rna_sdk.package.container.strict_json import pointer
from rna_sdk.package.container.zip_container import MANIFEST_NAME, Container, read_file
from rna_sdk.package.decoder.decoder_checks import check_decoder
from rna_sdk.package.decoder.decoder_form import PartDecoder
from rna_sdk.package.geometry.geometry_files import Geometry, geometry_from_bytes
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.geometry.source_vertices import source_vertices_from_bytes
from rna_sdk.package.geometry.vertex_visibility import vertex_count, visibility_from_bytes
from rna_sdk.package.gltf.carrier import Carrier, is_glb, read_carrier
from rna_sdk.package.issues import Code, Issue, Severity, refuse
from rna_sdk.package.limits import MAX_TEXTURE_SIDE
from rna_sdk.package.manifest.deflate import decoded_entry
from rna_sdk.package.manifest.extensions import (
    Deflate,
    Environment,
    Poster,
    Proxy,
    Source,
    StandinTextures,
    extension,
    of_part,
    variant_records,
)
from rna_sdk.package.manifest.manifest_checks import RANGE_CODES, manifest_warnings
from rna_sdk.package.manifest.manifest_fields import Bounds, Record, references
from rna_sdk.package.manifest.manifest_model import (
    Manifest,
    NormalMapRecord,
    Part,
    TransmittanceRecord,
    TriangleRange,
)
from rna_sdk.package.manifest.manifest_reader import parse_manifest
from rna_sdk.package.manifest.manifest_tiers import TierPartFields
from rna_sdk.package.manifest.pictures import png_size
from rna_sdk.package.textures.base_color import image_from_bytes
from rna_sdk.package.textures.normal_maps import NORMALS
from rna_sdk.package.textures.planes import check_finite, planes_from_bytes
from rna_sdk.package.textures.texture_form import Texture
from rna_sdk.package.textures.transmittance import texture_from_bytes

_UV_CODES = {
    "transmittance": Code.TRANSMITTANCE_UV,
    "normalMaps": Code.NORMAL_MAP_UV,
    "baseColor": Code.BASE_COLOR_UV,
}

_OUTSIDE_TOLERANCE = 1e-4
"""Part of the bounds' extent that geometry may lie outside before a warning says so."""


@dataclass
class Inspection:
    """Result of a full check of a file.

    Attributes:
        container, manifest: None where the file is too broken to have one.
        carrier: the `.glb` about the package; None for a `.rna`.
        issues: all findings, in the order of the checks.
    """

    container: Container | None = None
    manifest: Manifest | None = None
    carrier: Carrier | None = None
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
    """Check a `.rna`, or a `.glb` that carries one, and keep the opened parts."""
    result = Inspection()
    with result.collect():
        data = read_file(path)
        if is_glb(data):
            result.carrier = read_carrier(data)
            result.issues += result.carrier.warnings()
            data = data[result.carrier.package]
        result.container = Container.of(data, path)
        result.container.check_crc(MANIFEST_NAME)
        manifest = parse_manifest(bytes(result.container.view(MANIFEST_NAME)))
        result.manifest = manifest
        result.issues += manifest_warnings(manifest)
        intact = _check_entries(result, result.container, manifest)
        _decode_entries(result, result.container, manifest, intact)
        _Contents(result, result.container, manifest, intact).check()
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


class _Noted(PackageError):
    """Error of an entry whose issue is already reported."""


class _Contents:
    """Checks the contents of intact entries."""

    def __init__(
        self, result: Inspection, container: Container, manifest: Manifest, intact: set[str]
    ) -> None:
        self._result, self._container = result, container
        self._manifest, self._intact = manifest, intact
        self._vertices: dict[int, int] = {}  # of parts whose geometry is good
        self._seen: set[object] = set()  # tiers, parts and records may share entries
        self._sizes: dict[object, tuple[int, ...]] = {}  # of textures that are good

    def check(self) -> None:
        """Notes all issues."""
        parts = list(enumerate(self._manifest.parts))
        for k, part in parts:
            with self._result.collect():
                self._check_geometry(k, part)
        if poster := extension(self._manifest, Poster):
            declared = poster.width, poster.height
            expected = f"a PNG of {declared[0]} x {declared[1]} pixels"
            self._check_png(
                Code.POSTER_IMAGE, poster.image, expected, lambda size: size == declared
            )
        for k, part in parts:
            for proxy in of_part(self._manifest, Proxy, k) or ():
                with self._result.collect():
                    view = self._view(proxy.geometry)
                    geometry_from_bytes(view, proxy.geometry, part.kind)
        for tier in self._manifest.tiers:
            for tier_part in tier.parts:
                self._check_tier_part(tier_part, *tier_part.decoders)
        for k, _ in parts:
            if lobes := of_part(self._manifest, Environment, k):
                self._check_tier_part(lobes, lobes.optional_decoder)
                if lobes.visibility is not None and k in self._vertices:
                    with self._result.collect():
                        view = self._view(lobes.visibility)
                        visibility_from_bytes(view, lobes.visibility, self._vertices[k])

    def _view(self, entry: str) -> memoryview:
        if entry not in self._intact:
            raise _Noted([])
        return self._container.view(entry)

    def _check_geometry(self, k: int, part: Part) -> None:
        geometry = geometry_from_bytes(self._view(part.geometry), part.geometry, part.kind)
        self._vertices[k] = vertex_count(geometry)
        self._result.issues += _outside(geometry, part.bounds, pointer("parts", k, "bounds"))
        if isinstance(geometry, Mesh):
            with self._result.collect():
                data = extension(self._manifest, Source)
                if data is not None and (name := data.parts[k]) is not None:
                    view = self._view(name)
                    source_vertices_from_bytes(view, name, len(geometry.positions), data.vertices)
            self._check_standin_textures(k, geometry)
            for member, records in part.ranges.items():
                with self._result.collect():
                    self.check_textures(k, part, geometry, member, records)

    def _check_standin_textures(self, k: int, mesh: Mesh) -> None:
        textures = of_part(self._manifest, StandinTextures, k)
        if textures is not None and mesh.uvs is None:
            where = f"/extensions/{StandinTextures.NAME}/parts/{k}"
            issue = Issue.of(
                Code.STANDIN_TEXTURE, where, "a mesh without TEXCOORD_0", "texture coordinates"
            )
            self._result.issues.append(issue)
        elif textures is not None:
            expected = f"a PNG of 1 to {MAX_TEXTURE_SIDE} pixels a side"
            for _, name in textures:
                self._check_png(
                    *(Code.STANDIN_TEXTURE, name, expected),
                    lambda size: 1 <= min(size) and max(size) <= MAX_TEXTURE_SIDE,
                )

    def _check_png(
        self, code: Code, entry: str, expected: str, fits: Callable[[tuple[int, int]], bool]
    ) -> None:
        """Warns of a picture that is none, or of a size (width, height) that does not fit."""
        if entry in self._intact and self._is_new((code, entry)):
            size = png_size(self._view(entry))
            if size is None or not fits(size):
                found = "no PNG" if size is None else f"{size[0]} x {size[1]} pixels"
                self._result.issues.append(Issue.of(code, entry, found, expected))

    def check_textures(
        self, k: int, part: Part, mesh: Mesh, member: str, records: Sequence[TriangleRange]
    ) -> None:
        """Compare a part's records of one sort with its mesh, and read their textures."""
        if records and (end := sum(records[-1].triangles)) > len(mesh.triangles):
            where = pointer("parts", k, member, len(records) - 1, "triangles")
            expected = f"at most {len(mesh.triangles)} triangles"
            refuse(RANGE_CODES[member], where, f"an end at {end}", expected)
        of_variants = variant_records(self._manifest, k) if member == "baseColor" else []
        for record in (*records, *of_variants):
            for _, entry in references(record):
                size = self._texture_size(entry, record)
                # A transmittance of one texel is the same for all triangles.
                free = member == "transmittance" and size in (None, (1, 1))
                if mesh.uvs is None and not free:
                    found, expected = f"no TEXCOORD_0 beside {entry}", "texture coordinates"
                    refuse(_UV_CODES[member], part.geometry, found, expected)

    def _texture_size(self, entry: str, record: Record) -> tuple[int, ...] | None:
        """Height and width of a record's texture; None if it is not as it must be."""
        key = entry, getattr(record, "cutoff", None) is not None
        if self._is_new(key):
            with self._result.collect():
                self._sizes[key] = _texture(self._view(entry), entry, record).shape[:2]
        return self._sizes.get(key)

    def _check_tier_part(self, part: TierPartFields, *decoders: PartDecoder) -> None:
        if self._is_new((part.planes, part.resolution, part.channels, part.plane_precision)):
            with self._result.collect():
                check_finite(planes_from_bytes(self._view(part.planes), part), part.planes)
        for decoder in decoders:
            if self._is_new(decoder):
                with self._result.collect():
                    self._result.issues += check_decoder(self._view(decoder.entry), decoder)

    def _is_new(self, key: object) -> bool:
        is_new = key not in self._seen
        self._seen.add(key)
        return is_new


def _texture(data: memoryview, entry: str, record: Record) -> Texture:
    """The texture in the entry that a record of a range of triangles names."""
    if isinstance(record, TransmittanceRecord):
        return texture_from_bytes(data, record)
    if isinstance(record, NormalMapRecord):
        return NORMALS.from_bytes(data, entry)
    return image_from_bytes(data, entry)


def _outside(geometry: Geometry, bounds: Bounds, where: str) -> list[Issue]:
    low, high = (corner.tolist() for corner in geometry.box())
    for axis in range(3):
        slack = _OUTSIDE_TOLERANCE * (bounds.max[axis] - bounds.min[axis])
        if low[axis] < bounds.min[axis] - slack or high[axis] > bounds.max[axis] + slack:
            found = f"{low[axis]:.6g} to {high[axis]:.6g} along {'xyz'[axis]}"
            expected = f"{bounds.min[axis]:.6g} to {bounds.max[axis]:.6g}"
            return [Issue.of(Code.GEOMETRY_OUTSIDE, where, found, expected)]
    return []
