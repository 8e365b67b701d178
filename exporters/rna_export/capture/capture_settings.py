"""Capture settings and their defaults; imports no capture code."""

from pydantic import BaseModel, ConfigDict, Field, field_validator
from pydantic.alias_generators import to_camel

SHARPEST = 0.14  # roughness
LEAST_ROUGHNESS = 0.035
"""Cycles lights sharper lobes wrongly, and mirrors not at all (docs/decisions/capture.md)."""
MAX_LIGHTS = 1_000_000
"""Far above useful numbers; reading a manifest with more lights would take very long."""
MAX_FRAME = 1_048_574
"""That Blender knows."""
WHITE_RAYS = 2048
"""In a white world: they give the light that an asset returns within a percent."""
_MAX_POSES = 32
_SHARDS = 32  # at least, where there are as many lights
_MAX_RAYS, _MAX_SAMPLES, _MAX_VIEWS, _MAX_SIDE = 1 << 24, 1 << 20, 1000, 8192
CLAMP_DIRECT, CLAMP_INDIRECT = 0.0, 30.0
"""Clamps on radiance, 0: none. The paper, 4.1, has 20 and 10 (docs/decisions/capture.md)."""


class DatasetModel(BaseModel):
    """A part of a dataset's `manifest.json`."""

    model_config = ConfigDict(
        extra="forbid", frozen=True, alias_generator=to_camel, populate_by_name=True
    )


class CaptureSettings(DatasetModel):
    """Settings of a capture; with the source, enough to repeat it."""

    samples: int = Field(16, gt=0, le=_MAX_SAMPLES, description="paths per view ray")
    rays: int = Field(4096, gt=0, le=_MAX_RAYS, description="view rays per light direction")
    lights: int = Field(
        2000, gt=0, le=MAX_LIGHTS, description="light directions, one small render each"
    )
    domain: str = Field(
        "sphere", pattern="^(sphere|hemisphere)$", description="domain of wo and wi"
    )
    parts: str = Field(
        "kinds",
        pattern="^(kinds|objects)$",
        description="units with their own planes and decoder: kinds (all surfaces, all hair) or "
        "objects (each top-level object)",
    )
    exact_geometry: bool = Field(
        False, description="keep float32 geometry; quantised geometry halves the package size"
    )
    normal_texels: int = Field(
        512,
        ge=0,
        le=_MAX_SIDE,
        description="maximum width and height of normal maps; 0: none, the planes learn them",
    )
    texture_size: int = Field(
        4096,
        ge=4,
        le=_MAX_SIDE,
        description="maximum width and height of baked base colours; images keep their size",
    )
    sharpest: float = Field(
        SHARPEST,
        gt=0,
        le=0.8,
        description="lowest roughness whose highlights view rays importance-sample",
    )
    least_roughness: float = Field(
        LEAST_ROUGHNESS, ge=0.0, le=1.0, description="smoother reflecting lobes get this roughness"
    )
    clamp_direct: float = Field(
        CLAMP_DIRECT, ge=0.0, description="Cycles' clamp on direct radiance; 0: none"
    )
    clamp_indirect: float = Field(
        CLAMP_INDIRECT, ge=0.0, description="Cycles' clamp on indirect radiance; 0: none"
    )
    glass: str = Field(
        "leave",
        pattern="^(keep|leave)$",
        description="smooth glass, which hosts render: keep (the asset is captured with its "
        "refraction and shadows) or leave (without them)",
    )
    front: str | None = Field(None, pattern="^-?[XYZ]$", description="front axis of the file")
    up: str | None = Field(None, pattern="^-?[XYZ]$", description="up axis of the file")
    rest_frame: int | None = Field(
        None,
        ge=-MAX_FRAME,
        le=MAX_FRAME,
        description="frame of an animated source from which the geometry is taken",
    )
    poses: tuple[int, ...] = Field(
        (),
        max_length=_MAX_POSES,
        description="further frames of the source to capture, alternating with the rest frame; "
        "one model is trained on all of them",
    )
    validation_views: int = Field(
        128, ge=1, le=_MAX_VIEWS, description="validation images, held out from training"
    )
    validation_resolution: int = Field(
        64, gt=0, le=_MAX_SIDE, description="width and height of validation images, pixels"
    )
    validation_samples: int = Field(
        176,
        ge=2,
        le=_MAX_SAMPLES,
        description="paths per pixel of validation images, in two independent halves",
    )
    lights_per_shard: int = Field(
        32,
        gt=0,
        le=MAX_LIGHTS,
        description="lights per shard: an interruption loses at most one shard",
    )
    seed: int = 0

    @field_validator("poses")
    @classmethod
    def _check_poses(cls, frames: tuple[int, ...]) -> tuple[int, ...]:
        if len(set(frames)) < len(frames) or any(abs(frame) > MAX_FRAME for frame in frames):
            raise ValueError(f"expected frames of Blender's, each once, up to {MAX_FRAME:,}")
        return frames

    def shared_out(self) -> "CaptureSettings":
        """These settings with smaller shards where there would be too few for many workers.

        However many there are: a dataset does not depend on the machine.
        """
        shard = max(1, min(self.lights_per_shard, self.lights // _SHARDS))
        return self.model_copy(update={"lights_per_shard": shard})

    @property
    def cut(self) -> str | None:
        """The warning of a capture whose highlights are cut; None of one without a direct clamp."""
        if not self.clamp_direct:
            return None
        return (
            f"Cycles' direct light is cut at a radiance of {self.clamp_direct:g}: smooth materials "
            "reflect too little of environments and area lights; capture the source again"
        )

    @property
    def validation_paths(self) -> int:
        """Paths of one validation image, estimated for 40% coverage."""
        return int(0.4 * self.validation_resolution**2 * self.validation_samples)

    @property
    def white_paths(self) -> int:
        """Paths of the rays in a white world: of each as many as of half a validation image's."""
        return WHITE_RAYS * (self.validation_samples // 2)

    @property
    def held_out_paths(self) -> int:
        """Paths of all that a training does not see, without emission."""
        return self.validation_views * self.validation_paths + self.white_paths

    @classmethod
    def usual(cls, kind: str, **given: object) -> "CaptureSettings":
        """The defaults for "surface", "fiber" or "both", overridden by `given`."""
        return cls(**{**_DEFAULTS.get(kind, {}), **given})


# Hair paths are expensive and noisy: more points with fewer paths train better
# (docs/decisions/fibers.md). With a surface, whose paths are cheap, both use the same number.
_FIBERS = {
    "samples": 2,
    "rays": 16384,
    "lights": 1500,
    "validation_views": 48,
    "validation_resolution": 96,  # a pixel of their pictures is 4 x 4 rays
    "validation_samples": 72,
    "lights_per_shard": 8,
}
_DEFAULTS = {"fiber": _FIBERS, "both": {**_FIBERS, "samples": 4, "rays": 12288}}
