"""A disk that sends light from its front."""

from __future__ import annotations

import numpy as np

from rna_render.lights.area import AreaLight
from rna_render.lights.directions import facing_frame, flat_pdf
from rna_render.lights.kinds import DISK, row_places
from rna_render.scene.light_models import DiskModel
from rna_sdk.compiled import compiled
from rna_trace.embree import DiscScene
from rna_trace.vectors import Vector

_FRAME, _RADIUS = (row_places("disk")[name] for name in ("frame", "radius"))


class DiskLight(AreaLight):
    """Sampled uniformly over its area. In its own space it faces +z, about the origin."""

    def __init__(self, model: DiskModel) -> None:
        self.world_from_object = facing_frame(model.position, model.look_at)
        shape = {"frame": self.world_from_object[:3], "radius": model.radius}
        super().__init__(model, np.pi * model.radius**2, DISK, **shape)
        centre, normal = np.zeros((1, 3), np.float32), np.array([[0, 0, 1]], np.float32)
        self.scene = DiscScene(centre, normal, np.array([model.radius], np.float32))


@compiled(fastmath=())
def _shape(numbers: np.ndarray) -> tuple[np.ndarray, float]:
    """Frame and radius."""
    return numbers[_FRAME : _FRAME + 12].reshape(3, 4), numbers[_RADIUS]


@compiled(fastmath=())
def concentric(u1: float, u2: float) -> tuple[float, float]:
    """A uniform point of the unit disk; neighbours stay neighbours.

    Shirley and Chiu, A Low Distortion Map Between Disk and Square (JGT 2(3), 1997).
    """
    a, b = 2.0 * u1 - 1.0, 2.0 * u2 - 1.0
    if a == 0.0 and b == 0.0:
        return 0.0, 0.0
    if abs(a) > abs(b):
        radius, phi = a, np.pi / 4.0 * (b / a)
    else:
        radius, phi = b, np.pi / 2.0 - np.pi / 4.0 * (a / b)
    return radius * np.cos(phi), radius * np.sin(phi)


@compiled(fastmath=())
def sample_disk(
    numbers: np.ndarray, x: Vector, u1: float, u2: float
) -> tuple[Vector, float, float]:
    """Direction, distance and density."""
    frame, radius = _shape(numbers)
    a, b = concentric(u1, u2)
    dx = frame[0, 3] + radius * (a * frame[0, 0] + b * frame[0, 1]) - x[0]
    dy = frame[1, 3] + radius * (a * frame[1, 0] + b * frame[1, 1]) - x[1]
    dz = frame[2, 3] + radius * (a * frame[2, 0] + b * frame[2, 1]) - x[2]
    r = np.sqrt(dx * dx + dy * dy + dz * dz)
    scale = 1.0 / r if r > 0.0 else 0.0
    wi = dx * scale, dy * scale, dz * scale
    return wi, r, disk_density(numbers, x, wi)


@compiled(fastmath=())
def disk_density(numbers: np.ndarray, x: Vector, d: Vector) -> float:
    """Density of directions that meet the disk, 0 where they meet its dark side."""
    frame, radius = _shape(numbers)
    return flat_pdf(frame[:3, 3], frame[:3, 2], False, 1.0 / (np.pi * radius * radius), x, d)
