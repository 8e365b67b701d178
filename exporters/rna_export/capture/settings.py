"""What can be asked of a capture, with the usual values; loads nothing that captures."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field
from pydantic.alias_generators import to_camel

SHARPEST = 0.14  # roughness
CLAMP_DIRECT, CLAMP_INDIRECT = 20.0, 10.0  # of radiance; the paper, section 4.1


class DatasetModel(BaseModel):
    """A part of a dataset's `manifest.json`."""

    model_config = ConfigDict(
        extra="forbid", frozen=True, alias_generator=to_camel, populate_by_name=True
    )


class CaptureSettings(DatasetModel):
    """What was asked for; with the source, enough to repeat the capture."""

    samples: int = Field(16, gt=0, description="paths a view ray")
    rays: int = Field(4096, gt=0, description="view rays a light direction")
    lights: int = Field(2000, gt=0, description="light directions, one small render each")
    domain: str = Field("sphere", pattern="^(sphere|hemisphere)$", description="of wo and of wi")
    parts: str = Field(
        "kinds",
        pattern="^(kinds|objects)$",
        description="what has planes and a decoder of its own: all surfaces and all hair, or each "
        "object that is parented to no other",
    )
    exact_geometry: bool = Field(
        False, description="keep geometry in float32, not in steps that halve a package's size"
    )
    normal_texels: int = Field(
        512, ge=0, description="along a side of a normal map, at most; 0: normal maps are learnt"
    )
    sharpest: float = Field(
        SHARPEST, gt=0, le=0.8, description="roughness of the smoothest material of a surface"
    )
    clamp_direct: float = Field(
        CLAMP_DIRECT, description="Cycles' clamp of direct light (the paper's)"
    )
    clamp_indirect: float = Field(CLAMP_INDIRECT, description="Cycles' clamp of indirect light")
    front: str | None = Field(
        None, pattern="^-?[XYZ]$", description="axis of the file that is the asset's front"
    )
    up: str | None = Field(None, pattern="^-?[XYZ]$", description="axis of the file that is up")
    validation_views: int = Field(8, ge=1, description="whole images kept from training")
    validation_resolution: int = Field(160, gt=0, description="their width and height, pixels")
    validation_samples: int = Field(512, ge=2, description="paths a pixel, in two halves")
    lights_per_shard: int = Field(32, gt=0, description="what a stop can lose at most")
    seed: int = 0

    @property
    def validation_paths(self) -> int:
        """To trace for one validation image, about: the part that the asset covers is a guess."""
        return int(0.4 * self.validation_resolution**2 * self.validation_samples)

    @classmethod
    def usual(cls, kind: str, **asked: object) -> CaptureSettings:
        """The defaults for "surface", "fiber" or "both", but for what was asked for."""
        return cls(**{**_DEFAULTS.get(kind, {}), **asked})


# Hair's paths are dear and noisy: more points of fewer paths are better (docs/decisions/fibers.md).
# Beside a surface, whose paths are cheap, as many paths a light serve both.
_FIBERS = {
    "samples": 2,
    "rays": 16384,
    "lights": 1500,
    "validation_resolution": 128,
    "validation_samples": 256,
    "lights_per_shard": 8,
}
_DEFAULTS = {"fiber": _FIBERS, "both": {**_FIBERS, "samples": 4, "rays": 12288}}
