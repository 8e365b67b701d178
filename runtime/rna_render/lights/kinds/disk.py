"""A disk that sends light from its front."""

from typing import Any

import numpy as np

from rna_render.lights.base import PlacedLight, light_numbers
from rna_render.lights.directions import facing_frame, flat_pdf
from rna_render.scene.light_models import DiskModel
from rna_sdk.machine.compiled import compiled
from rna_trace.embree import DiscScene
from rna_trace.vectors import Vector, vector_at


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
def _density(light: Any, x: Vector, d: Vector) -> float:
    """Density of directions that meet the disk, 0 where they meet its dark side."""
    per_area = 1.0 / (np.pi * light.radius * light.radius)
    return flat_pdf(light.frame[:, 3], light.frame[:, 2], False, per_area, x, d)


@compiled(fastmath=())
def _sample(
    numbers: np.ndarray,
    x_world: np.ndarray,
    u: np.ndarray,
    wi_world: np.ndarray,
    distance: np.ndarray,
    pdf: np.ndarray,
) -> None:
    light = numbers[0]
    frame, radius = light.frame, light.radius
    for i in range(len(x_world)):
        x = vector_at(x_world, i)
        a, b = concentric(u[i, 0], u[i, 1])
        dx = frame[0, 3] + radius * (a * frame[0, 0] + b * frame[0, 1]) - x[0]
        dy = frame[1, 3] + radius * (a * frame[1, 0] + b * frame[1, 1]) - x[1]
        dz = frame[2, 3] + radius * (a * frame[2, 0] + b * frame[2, 1]) - x[2]
        r = np.sqrt(dx * dx + dy * dy + dz * dz)
        scale = 1.0 / r if r > 0.0 else 0.0
        wi = dx * scale, dy * scale, dz * scale
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = wi
        distance[i], pdf[i] = r, _density(light, x, wi)


@compiled(fastmath=())
def _densities(
    numbers: np.ndarray, x_world: np.ndarray, d_world: np.ndarray, pdf: np.ndarray
) -> None:
    light = numbers[0]
    for i in range(len(x_world)):
        pdf[i] = _density(light, vector_at(x_world, i), vector_at(d_world, i))


class DiskLight(PlacedLight):
    """Sampled uniformly over its area. In its own space it faces +z, about the origin."""

    kind = "disk"
    NUMBERS = light_numbers(("frame", (3, 4)), ("radius", ()))
    sample_kernel = staticmethod(_sample)
    density_kernel = staticmethod(_densities)

    def __init__(self, model: DiskModel) -> None:
        self.world_from_object = facing_frame(model.position, model.look_at)
        shape = {"frame": self.world_from_object[:3], "radius": model.radius}
        super().__init__(model, np.pi * model.radius**2, **shape)
        centre, normal = np.zeros((1, 3), np.float32), np.array([[0, 0, 1]], np.float32)
        self.scene = DiscScene(centre, normal, np.array([model.radius], np.float32))


make = DiskLight
