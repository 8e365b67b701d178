"""A disk that sends light from its front."""

from __future__ import annotations

import numpy as np
from numba import prange

from rna_render.embree import DiscScene
from rna_render.lights.area import AreaLight
from rna_render.lights.directions import facing_frame, flat_pdf
from rna_render.lights.models import DiskModel
from rna_sdk.compiled import compiled


class DiskLight(AreaLight):
    """Sampled uniformly over its area. In its own space it faces +z, about the origin."""

    def __init__(self, model: DiskModel) -> None:
        super().__init__(model, np.pi * model.radius**2)
        self._radius = model.radius
        self.world_from_object = facing_frame(model.position, model.look_at)
        centre, normal = np.zeros((1, 3), np.float32), np.float32([[0, 0, 1]])
        self.scene = DiscScene(centre, normal, np.float32([model.radius]))

    def _sample(self, x_world, u, wi_world, distance, pdf) -> None:
        out = wi_world, distance, pdf
        _sample_disk(self.world_from_object, self._radius, self.area, x_world, u, *out)

    def _pdf(self, x_world, d_world, pdf) -> None:
        _disk_pdf(self.world_from_object, self.area, x_world, d_world, pdf)


@compiled(fastmath=())
def concentric(u1, u2):
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


@compiled(parallel=True, fastmath=())
def _sample_disk(frame, radius, area, x_world, u, wi_world, distance, pdf):
    normal, middle = frame[:3, 2], frame[:3, 3]
    for i in prange(len(x_world)):
        a, b = concentric(u[i, 0], u[i, 1])
        dx = middle[0] + radius * (a * frame[0, 0] + b * frame[0, 1]) - x_world[i, 0]
        dy = middle[1] + radius * (a * frame[1, 0] + b * frame[1, 1]) - x_world[i, 1]
        dz = middle[2] + radius * (a * frame[2, 0] + b * frame[2, 1]) - x_world[i, 2]
        r = np.sqrt(dx * dx + dy * dy + dz * dz)
        scale = 1.0 / r if r > 0.0 else 0.0
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = dx * scale, dy * scale, dz * scale
        distance[i] = r
        pdf[i] = flat_pdf(middle, normal, False, 1.0 / area, x_world[i], wi_world[i])


@compiled(parallel=True, fastmath=())
def _disk_pdf(frame, area, x_world, d_world, pdf):
    normal, middle = frame[:3, 2], frame[:3, 3]
    for i in prange(len(x_world)):
        pdf[i] = flat_pdf(middle, normal, False, 1.0 / area, x_world[i], d_world[i])
