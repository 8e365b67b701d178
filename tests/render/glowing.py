"""Assets that emit, let light through or have several parts, with a known transport."""

from dataclasses import dataclass

import numpy as np

from tests.render.assets import FiberProbe, LambertAsset


@dataclass(frozen=True)
class Composite:
    """Several parts as one asset."""

    parts: tuple


@dataclass(frozen=True)
class Record:
    """Triangles that let light through."""

    first: int
    count: int
    texture: np.ndarray
    cutoff: float | None = None
    ior: tuple[float, float] | None = None


@dataclass(frozen=True)
class GlowingSurface(LambertAsset):
    """Emits `glow` to both sides, times `slope` to the power of the place on the x axis.

    one_sided: only to the side of the normal.
    """

    glow: tuple[float, float, float] = (1.0, 1.0, 1.0)
    slope: float = 1.0
    one_sided: bool = False
    emits: bool = True

    def emission(self, positions, normals, wo):
        scale = self.slope ** positions[:, :1]
        if self.one_sided:
            scale = scale * (np.sum(normals * wo, axis=1, keepdims=True) > 0)
        return (np.float32(self.glow) * scale).astype(np.float32)


@dataclass(frozen=True)
class GlowingStrands(FiberProbe):
    """Emits `glow` times 1 - h^2 to all directions."""

    glow: tuple[float, float, float] = (1.0, 1.0, 1.0)
    emits: bool = True

    def emission(self, positions, tangents, h, wo):
        return (np.float32(self.glow) * (1 - h[:, None] ** 2)).astype(np.float32)


def pane(colour, count: int) -> Record:
    """Equal transmittance on the first triangles."""
    texels = np.rint(255 * np.float64(colour)).astype(np.uint8).reshape(1, 1, -1)
    return Record(0, count, texels)
