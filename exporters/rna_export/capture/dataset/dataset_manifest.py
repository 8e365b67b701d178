"""`manifest.json` of a dataset: parts, source, plan."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Literal, Self

from pydantic import Field, ValidationError, model_validator

from rna_export.capture.capture_settings import CaptureSettings, DatasetModel
from rna_export.capture.preflight.verdicts import MaterialVerdict
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.package import Domain
from rna_sdk.package.manifest.manifest_fields import Name
from rna_sdk.package.manifest.manifest_model import (
    BaseColorFields,
    BaseColorRecord,
    NormalMapRecord,
    TransmittanceRecord,
)

MAX_NUMBER = 1e18
"""Largest number of samples and bounds: float32 holds its square."""
MIN_SIZE = 1e-5
"""Least size of a part over its distance: smaller differences vanish in float32."""

SAMPLE_FIELDS: dict[str, dict[str, int]] = {
    "surface": {"position": 3, "normal": 3, "wo": 3, "wi": 3, "radiance": 3, "visible": 1},
    "fiber": {
        "position": 3,
        "tangent": 3,
        "h": 1,
        "wo": 3,
        "wi": 3,
        "radiance": 3,
        "direct": 3,  # the part of the radiance that scattered once; it has no noise
        "visible": 1,
    },
}
"""Kind of part -> arrays of a sample, with their number of columns."""

BASE_COLOR = "base_color"
"""A sample's base colour, float16; of parts that have any."""

EMISSION_SHARE = 0.15  # of the training shards
_OF_A_LIGHT = ("wi", "direct", "visible")


def emission_fields(kind: str) -> dict[str, int]:
    """Fields of samples of emission."""
    return {name: n for name, n in SAMPLE_FIELDS[kind].items() if name not in _OF_A_LIGHT}


def white_fields(of_part: Mapping[str, int]) -> dict[str, int]:
    """Fields of samples in a white world, of a part whose samples have those of `of_part`.

    `weight`: 1 over the density of wi, per steradian.
    """
    return {**{name: n for name, n in of_part.items() if name != "direct"}, "weight": 1}


def what_is_wrong(error: ValidationError) -> str:
    """The first error in one line: its location and cause."""
    first = error.errors()[0]
    where = ".".join(map(str, first["loc"]))
    return f"{where}: {first['msg']}" if where else str(first["msg"])


class CapturedPart(DatasetModel):
    """A mesh or all strands of an asset, which get planes and a decoder of their own."""

    name: Name
    kind: Literal["surface", "fiber"]
    bounds: tuple[tuple[float, float, float], tuple[float, float, float]]
    transmittance: tuple[TransmittanceRecord, ...] = ()  # textures are files of the dataset
    normal_maps: tuple[NormalMapRecord, ...] = ()  # likewise
    base_color: tuple[BaseColorRecord, ...] = ()  # images are files of the dataset
    variants: tuple[tuple[BaseColorFields | None, ...], ...] = ()  # of each; none: as it is

    def changes(self, variant: int) -> tuple[BaseColorFields | None, ...]:
        """Replacement of each record of base colour in a variant."""
        return self.variants[variant] or (None,) * len(self.base_color)

    @model_validator(mode="after")
    def _has_a_box(self) -> Self:
        low, high = self.bounds
        largest = max(map(abs, (*low, *high)))
        sides = [b - a for a, b in zip(low, high, strict=True)]
        if not (largest <= MAX_NUMBER and min(sides) >= 0 and max(sides) >= MIN_SIZE * largest > 0):
            raise ValueError(
                f"found bounds {self.bounds}, expected the lower and the upper corner of a box, at "
                f"most {MAX_NUMBER:g}, whose size float32 can tell"
            )
        return self


class CaptureManifest(DatasetModel):
    """`manifest.json` of a dataset."""

    name: str
    parts: tuple[CapturedPart, ...] = Field(min_length=1)
    source: str
    source_sha256: str
    arguments: tuple[str, ...] = ()
    settings: CaptureSettings
    rest_frame: int | None = None  # of the source, that the geometry is of; None: not recorded
    poses: tuple[int, ...] = ()  # frames of the source, the rest frame first; none: that alone
    variants: tuple[str, ...] = ()  # names of other prints of the source
    blender: str
    generator: str
    opaque_cutouts: bool  # light through some materials counts as theirs: alpha may be below 1
    emitters: tuple[str, ...] = ()  # materials that emit light
    materials: tuple[MaterialVerdict, ...] = ()  # how well each is learnt
    notes: tuple[str, ...] = ()
    processors: tuple[str, ...] = ()  # that rendered: where one is another, bits may differ
    scene_domain: Domain | None = None  # of --for; in the place of settings.domain

    @property
    def domain(self) -> Domain:
        """Directions of all samples."""
        everywhere = self.settings.domain
        return self.scene_domain or Domain(wo=everywhere, wi=everywhere)

    @property
    def all_notes(self) -> tuple[str, ...]:
        """The notes of the capture, and those that follow from its settings."""
        cut = self.settings.cut
        return self.notes if cut is None else (*self.notes, cut)

    @property
    def pose_count(self) -> int:
        """Number of captured poses; rays and images alternate between them."""
        return max(len(self.poses), 1)

    @property
    def prints(self) -> tuple[int | None, ...]:
        """Prints that rays are captured in by turns: None for the source's own, then the variants
        that change something."""
        changing = (
            k
            for k in range(len(self.variants))
            if any(change is not None for part in self.parts for change in part.changes(k))
        )
        return None, *changing

    @property
    def transmits(self) -> bool:
        """Whether rays pass through any part."""
        return any(part.transmittance for part in self.parts)

    @property
    def shards(self) -> int:
        return -(-self.settings.lights // self.settings.lights_per_shard)

    @property
    def emission_shards(self) -> int:
        """Number of shards of emission, each with as many rays as a training shard."""
        return max(1, round(EMISSION_SHARE * self.shards)) if self.emitters else 0

    @property
    def emission_images(self) -> int:
        """Number of images of emission, which are not used in training."""
        return max(1, self.settings.validation_views // 4) if self.emitters else 0

    def fields(self, part: CapturedPart) -> dict[str, int]:
        """Fields of a sample of a part: see SAMPLE_FIELDS.

        Where rays pass through parts, the visibility has a colour: 255 times it. A part with
        records of base colour has samples of it, linear.
        """
        fields = dict(SAMPLE_FIELDS[part.kind])
        if self.transmits:
            fields["visible"] = 3
        if part.base_color:
            fields[BASE_COLOR] = 3
        return fields

    def write(self, path: Path) -> None:
        """Writes JSON atomically."""
        text = json.dumps(self.model_dump(mode="json", by_alias=True), indent=1) + "\n"
        write_atomically(path, text.encode())
