"""The extensions that the specification defines: models of their data in the manifest."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, ClassVar, TypeVar

from pydantic import AfterValidator, Field, field_validator
from pydantic_core import PydanticCustomError

from rna_sdk.package.container.strict_json import model_of
from rna_sdk.package.limits import MAX_FILE_BYTES, MAX_INTEGER, MAX_PARTS, MAX_PROXIES
from rna_sdk.package.manifest.manifest_fields import EntryPath, Positive, Record
from rna_sdk.package.manifest.manifest_model import Manifest


def _is_element_size(value: int) -> int:
    if value not in (1, 2, 4):
        raise PydanticCustomError("FIELD_VALUE", "1, 2 or 4")
    return value


ElementSize = Annotated[int, AfterValidator(_is_element_size)]
Share = Annotated[float, Field(ge=0, le=1)]


class Extension(Record):
    """Base of the data of an extension."""

    NAME: ClassVar[str]


class Coding(Record):
    """Coding of an entry, and size and hash of the decoded bytes."""

    element_size: ElementSize = Field(description="Bytes.")
    distance: int = Field(ge=0, le=MAX_INTEGER, description="Elements, to the one taken away.")
    size: int = Field(ge=0, le=MAX_FILE_BYTES, description="Bytes when decoded.")
    sha256: str = Field(pattern="^[0-9a-f]{64}$", description="Of the decoded bytes.")


class Deflate(Extension):
    """Entries that are stored in coded form."""

    NAME: ClassVar[str] = "RNA_deflate"
    entries: dict[EntryPath, Coding]


class Poster(Extension):
    """A picture of the asset."""

    NAME: ClassVar[str] = "RNA_poster"
    image: EntryPath = Field(description="Entry with a PNG, sRGB with alpha.")
    width: Positive = Field(description="Pixels.")
    height: Positive = Field(description="Pixels.")


class StandinMaterial(Record):
    """A simple material for a part, as in glTF; linear."""

    base_color: tuple[Share, Share, Share]
    roughness: Share
    metallic: Share


class Standin(Extension):
    """Materials for viewports and the albedo of denoisers."""

    NAME: ClassVar[str] = "RNA_standin"
    parts: tuple[StandinMaterial, ...] = Field(min_length=1, max_length=MAX_PARTS)


class ProxyLevel(Record):
    """Coarser geometry of a part, for an asset that is small in the image."""

    geometry: EntryPath = Field(description="Entry with the mesh or the curves.")
    height: Positive = Field(description="Largest height of the bounding sphere, pixels.")


def _descends(value: tuple[ProxyLevel, ...]) -> tuple[ProxyLevel, ...]:
    if any(a.height <= b.height for a, b in pairwise(value)):
        raise PydanticCustomError("FIELD_VALUE", "each height below the one before")
    return value


ProxyLevels = Annotated[
    tuple[ProxyLevel, ...],
    Field(min_length=1, max_length=MAX_PROXIES),
    AfterValidator(_descends),
]


class Proxy(Extension):
    """Coarser geometry of the parts; null for a part that has none."""

    NAME: ClassVar[str] = "RNA_proxy"
    parts: tuple[ProxyLevels | None, ...] = Field(min_length=1, max_length=MAX_PARTS)

    @field_validator("parts")
    @classmethod
    def _has_one(cls, value: tuple[ProxyLevels | None, ...]) -> tuple[ProxyLevels | None, ...]:
        if not any(value):
            raise PydanticCustomError("FIELD_VALUE", "a proxy of some part")
        return value


T = TypeVar("T", bound=Extension)
EXTENSIONS: tuple[type[Extension], ...] = (Deflate, Poster, Standin, Proxy)


def extension(manifest: Manifest, of: type[T]) -> T | None:
    """The data of the extension in a manifest that was checked; None if it is not used."""
    data = manifest.extensions.get(of.NAME)
    return None if data is None else model_of(of, data)
