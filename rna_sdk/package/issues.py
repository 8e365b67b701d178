"""Everything that can be wrong with a package: the table of codes, and one finding."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum, StrEnum
from typing import NoReturn

from rna_sdk.errors import PackageError


class Severity(StrEnum):
    """An error makes a reader refuse the package; a warning does not."""

    ERROR = "error"
    WARNING = "warning"


class Code(Enum):
    """The stable issue codes. Each value is (severity, the fault in one sentence).

    `spec/ISSUES.md` is generated from this table.
    """

    def __init__(self, severity: Severity, meaning: str) -> None:
        self.severity = severity
        self.meaning = meaning

    # The file and its ZIP container
    FILE_UNREADABLE = (Severity.ERROR, "The file cannot be opened.")
    FILE_EMPTY = (Severity.ERROR, "The file has no bytes.")
    FILE_TOO_LARGE = (Severity.ERROR, "The file is larger than the container can address.")
    ZIP_NOT_ZIP = (Severity.ERROR, "The file is not a ZIP archive.")
    ZIP_TRUNCATED = (Severity.ERROR, "A ZIP record or its data reaches past where it must end.")
    ZIP_DIRECTORY = (Severity.ERROR, "The ZIP central directory is malformed.")
    ZIP_ZIP64 = (Severity.ERROR, "The archive uses ZIP64 or several disks.")
    ZIP_TOO_MANY = (Severity.ERROR, "The archive has more entries than allowed.")
    ZIP_ENCRYPTED = (Severity.ERROR, "An entry is encrypted.")
    ZIP_HEADER = (Severity.ERROR, "A flag, version, date or attribute is not the fixed one.")
    ZIP_COMPRESSED = (Severity.ERROR, "An entry is not stored (compression method 0).")
    ZIP_SIZE = (Severity.ERROR, "A stored entry declares two different sizes.")
    ZIP_NAME = (Severity.ERROR, "An entry's name is not a plain relative path.")
    ZIP_DUPLICATE = (Severity.ERROR, "Two entries have the same name, letter case ignored.")
    ZIP_LOCAL_HEADER = (Severity.ERROR, "A local header disagrees with the central directory.")
    ZIP_EXTRA = (Severity.ERROR, "An extra field is not the zero-filled padding field.")
    ZIP_OVERLAP = (Severity.ERROR, "Two entries share bytes of the file.")
    ZIP_GAP = (Severity.ERROR, "Bytes of the file belong to no entry.")
    ZIP_ALIGNMENT = (Severity.ERROR, "An entry's data does not start on a 64-byte boundary.")
    ZIP_ORDER = (Severity.ERROR, "manifest.json is not the first entry.")
    ZIP_CRC = (Severity.ERROR, "An entry's bytes do not have the CRC-32 in its header.")

    # A .glb that carries a package (RNA_relightable_asset)
    GLB_CONTAINER = (Severity.ERROR, "The file is not a well-formed binary glTF.")
    GLB_NO_PACKAGE = (Severity.ERROR, "The glTF carries no package.")
    GLB_SEVERAL = (Severity.ERROR, "The glTF carries several packages.")
    GLB_PACKAGE = (Severity.ERROR, "A node names no buffer view that can hold a package.")
    GLB_ALIGNMENT = (Severity.ERROR, "The package does not start on a 64-byte boundary.")
    GLB_DECLARATION = (Severity.WARNING, "The extension is not declared as optional.")
    GLB_FALLBACK = (Severity.WARNING, "The package has no fallback of its own.")

    # manifest.json, and the JSON inside other entries
    MANIFEST_TOO_LARGE = (Severity.ERROR, "manifest.json is larger than allowed.")
    MANIFEST_NOT_JSON = (Severity.ERROR, "manifest.json is not a JSON object in UTF-8.")
    JSON_DUPLICATE_KEY = (Severity.ERROR, "A JSON object has the same key twice.")
    JSON_NOT_FINITE = (Severity.ERROR, "A JSON number is NaN, infinite or out of range.")
    FORMAT_UNKNOWN = (Severity.ERROR, "The manifest does not declare the format of RNA packages.")
    VERSION_TOO_NEW = (Severity.ERROR, "The package is of a newer version of the format.")
    VERSION_TOO_OLD = (Severity.ERROR, "The package is of an older version of the format.")
    KIND_UNSUPPORTED = (Severity.ERROR, "This version does not know the kind of part.")
    EXTENSION_REQUIRED = (Severity.ERROR, "The package requires an unknown extension.")
    EXTENSION_UNKNOWN = (Severity.WARNING, "The package uses an unknown extension.")
    EXTENSION_UNDECLARED = (Severity.ERROR, "An extension is present but not in extensionsUsed.")
    FIELD_UNKNOWN = (Severity.ERROR, "The manifest has a field that the format does not define.")
    FIELD_MISSING = (Severity.ERROR, "The manifest lacks a field.")
    FIELD_VALUE = (Severity.ERROR, "A field has the wrong type or a value out of range.")
    BOUNDS_EMPTY = (Severity.ERROR, "The bounds have no extent along an axis.")
    TIER_DUPLICATE = (Severity.ERROR, "Two tiers have the same name.")
    PART_DUPLICATE = (Severity.ERROR, "Two parts have the same name.")
    PARTS_DIFFER = (Severity.ERROR, "A tier's parts or emissive parts are not the required ones.")
    INPUT_UNKNOWN = (Severity.ERROR, "A decoder input block is not known, or named twice.")
    INPUT_KIND = (Severity.ERROR, "An input block is for another kind of part, or uses the light.")
    REFERENCE_MISSING = (Severity.ERROR, "A path in the manifest names no declared entry.")

    # Entries against the manifest
    ENTRY_UNDECLARED = (Severity.ERROR, "The archive holds an entry that the manifest lacks.")
    ENTRY_MISSING = (Severity.ERROR, "The manifest declares an entry that the archive lacks.")
    ENTRY_UNREFERENCED = (Severity.ERROR, "Nothing in the manifest refers to a declared entry.")
    ENTRY_SIZE = (Severity.ERROR, "An entry's size is not the declared one.")
    ENTRY_HASH = (Severity.ERROR, "An entry's SHA-256 is not the declared one.")

    # extensions/
    DEFLATE_STREAM = (Severity.ERROR, "A coded entry does not inflate to its declared bytes.")
    DEFLATE_SIZE = (Severity.ERROR, "A coded entry declares too many bytes for those stored.")
    ENVIRONMENT_VISIBILITY = (
        Severity.ERROR,
        "The visibility is not a valid tensor file of one row a vertex.",
    )
    STANDIN_TEXTURE = (
        Severity.WARNING,
        "A texture of a stand-in is not a PNG of 1 to 8192 pixels, or has no coordinates.",
    )
    POSTER_IMAGE = (Severity.WARNING, "The poster is not a PNG of the declared size.")

    # geometry/*.glb, geometry/*.safetensors
    GEOMETRY_CONTAINER = (Severity.ERROR, "The geometry is not a well-formed file of its kind.")
    GEOMETRY_PROFILE = (Severity.ERROR, "The file is outside the profile of its kind of geometry.")
    GEOMETRY_RANGE = (Severity.ERROR, "A view, accessor or tensor does not fit into its bytes.")
    GEOMETRY_ARRAY = (Severity.ERROR, "The arrays of the geometry have wrong shapes or dtypes.")
    GEOMETRY_NOT_FINITE = (Severity.ERROR, "A value of a vertex or curve point is NaN or infinite.")
    GEOMETRY_INDEX = (Severity.ERROR, "A triangle names a vertex that does not exist.")
    GEOMETRY_NORMAL = (Severity.ERROR, "A vertex normal is not of unit length.")
    GEOMETRY_BOUNDS = (Severity.ERROR, "The accessor's min and max differ from its positions'.")
    GEOMETRY_STRANDS = (Severity.ERROR, "The offsets do not part the points into whole strands.")
    GEOMETRY_SEGMENT = (Severity.ERROR, "Two points in a row of a strand are equal.")
    GEOMETRY_STEPS = (Severity.ERROR, "Quantised steps have no length, or a strand too many.")
    GEOMETRY_RADIUS = (Severity.ERROR, "A radius is not greater than 0.")
    GEOMETRY_OUTSIDE = (Severity.WARNING, "Part of the geometry lies outside the bounds.")

    # transmittance/*.safetensors
    TRANSMITTANCE_RANGE = (Severity.ERROR, "Records of transmittance share or lack triangles.")
    TRANSMITTANCE_TEXTURE = (
        Severity.ERROR,
        "The texture is not a valid tensor file of the required form.",
    )
    NORMAL_MAP_RANGE = (Severity.ERROR, "Records of normal maps share or lack triangles.")
    NORMAL_MAP_TEXTURE = (
        Severity.ERROR,
        "The map is not a valid tensor file of the required form.",
    )
    NORMAL_MAP_UV = (Severity.ERROR, "A mesh with a normal map has no texture coordinates.")
    TRANSMITTANCE_UV = (Severity.ERROR, "A mesh with a texture has no texture coordinates.")

    # textures/*
    BASE_COLOR_RANGE = (Severity.ERROR, "Records of base colour share or lack triangles.")
    BASE_COLOR_IMAGE = (
        Severity.ERROR,
        "The image is not a PNG, JPEG or WebP that can be decoded, of 1 to 8192 pixels a side.",
    )
    BASE_COLOR_UV = (Severity.ERROR, "A mesh with an image has no texture coordinates.")

    # features/*.safetensors
    PLANES_HEADER = (Severity.ERROR, "The planes are not a well-formed safetensors file.")
    PLANES_TENSOR = (Severity.ERROR, "The file's tensors are not the required ones.")
    PLANES_DTYPE = (Severity.ERROR, "A tensor's dtype differs from the tier's planePrecision.")
    PLANES_SHAPE = (Severity.ERROR, "The tensors' shapes differ from the tier's.")
    PLANES_ALIGNMENT = (Severity.ERROR, "The tensor data does not start on a 64-byte boundary.")
    PLANES_NOT_FINITE = (Severity.ERROR, "The planes hold NaN, or values beyond 1e18.")

    # decoders/*.onnx
    DECODER_TOO_LARGE = (Severity.ERROR, "The decoder is larger than allowed.")
    DECODER_PROFILE = (Severity.ERROR, "The decoder is not the declared one of the format's form.")
    DECODER_COST = (Severity.ERROR, "A query's values or multiply-adds exceed the limits.")
    DECODER_RESULT = (Severity.ERROR, "The decoder breaks the output contract on a test query.")
    DECODER_SATURATION = (Severity.WARNING, "Weights in int8 can saturate a sum of two in 16 bits.")


@dataclass(frozen=True)
class Issue:
    """One finding.

    Attributes:
        code: a name in `Code`, stable across versions.
        severity: error or warning.
        pointer_or_offset: an int is a byte offset in the file; a string is a JSON pointer
            into manifest.json ("" is all of it), or `ENTRY#POINTER` into another entry.
        message: the code's sentence.
        found, expected: what is there, and what the format asks for.
    """

    code: str
    severity: Severity
    pointer_or_offset: str | int
    message: str
    found: str
    expected: str

    @classmethod
    def of(cls, code: Code, where: str | int, found: object, expected: object) -> "Issue":
        """The issue with this code, its severity and sentence taken from the table."""
        return cls(code.name, code.severity, where, code.meaning, _shown(found), _shown(expected))

    def __str__(self) -> str:
        where = self.pointer_or_offset
        place = f"byte {where}" if isinstance(where, int) else where or "manifest.json"
        text = f"{self.severity.value} {self.code} at {place}: {self.message}"
        return f"{text} Found {self.found}; expected {self.expected}."


def _shown(value: object) -> str:
    """Text of at most 200 characters, with unprintable ones escaped."""
    text = str(value)[:200]
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)


def is_valid(issues: Iterable[Issue]) -> bool:
    """Whether a package with these issues is valid: none of them is an error."""
    return all(issue.severity is not Severity.ERROR for issue in issues)


def refuse(code: Code, where: str | int, found: object, expected: object) -> NoReturn:
    """Raise PackageError with one issue."""
    raise PackageError([Issue.of(code, where, found, expected)])
