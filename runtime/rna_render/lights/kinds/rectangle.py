"""A rectangle that sends light from its front, sampled by the solid angle that it fills.

Ureña, Fajardo and King, An Area-Preserving Parametrization for Spherical Rectangles (EGSR 2013).
"""

from typing import Any

import numpy as np

from rna_render.lights.base import PlacedLight, light_numbers
from rna_render.lights.directions import facing_frame, flat_pdf
from rna_render.scene.light_models import RectangleModel
from rna_sdk.machine.compiled import compiled
from rna_trace.embree import TriangleScene
from rna_trace.vectors import Vector, vector_at

# Steradians. The solid angle is a difference of angles, exact to 1e-15; below this it is sampled
# uniformly over the area instead, which is as good for what looks so small.
MIN_SOLID_ANGLE = 1e-7


@compiled(fastmath=())
def _seen_from(
    frame: np.ndarray, half: np.ndarray, x: Vector
) -> tuple[float, float, float, float, float]:
    """Edges x0, x1, y0, y1 of the rectangle as seen from x, and x's height over its front."""
    px, py, pz = x[0] - frame[0, 3], x[1] - frame[1, 3], x[2] - frame[2, 3]
    a = px * frame[0, 0] + py * frame[1, 0] + pz * frame[2, 0]
    b = px * frame[0, 1] + py * frame[1, 1] + pz * frame[2, 1]
    height = px * frame[0, 2] + py * frame[1, 2] + pz * frame[2, 2]
    return -half[0] - a, half[0] - a, -half[1] - b, half[1] - b, height


@compiled(fastmath=())
def _edge_angle(x: float, y: float, sign: float, height: float) -> float:
    """Angle between the planes through x and two edges that meet in a corner, (x, y, -height).

    cos = sign x y / (sqrt(x^2 + h^2) sqrt(y^2 + h^2)), section 4 of the paper, as an arctangent:
    an arccosine would lose angles near 0 and pi.
    """
    return float(np.arctan2(height * np.sqrt(x * x + y * y + height * height), sign * x * y))


@compiled(fastmath=())
def _solid_angle(x0: float, x1: float, y0: float, y1: float, height: float) -> tuple[float, float]:
    """Solid angle of the rectangle, and k of section 5: 2 pi minus the two angles at x0."""
    k = 2.0 * np.pi - _edge_angle(x0, y1, 1.0, height) - _edge_angle(x0, y0, -1.0, height)
    right = _edge_angle(x1, y0, 1.0, height) + _edge_angle(x1, y1, -1.0, height)
    return right - k, k


@compiled(fastmath=())
def _density(light: Any, x: Vector, d: Vector) -> float:
    """Density of directions that meet the rectangle, 0 where they meet its dark side."""
    frame, half = light.frame, light.half
    per_area = 1.0 / (4.0 * half[0] * half[1])
    uniform = flat_pdf(frame[:, 3], frame[:, 2], False, per_area, x, d)
    if uniform == 0.0:  # from behind, too
        return 0.0
    x0, x1, y0, y1, height = _seen_from(frame, half, x)
    solid_angle, _ = _solid_angle(x0, x1, y0, y1, height)
    return uniform if solid_angle < MIN_SOLID_ANGLE else 1.0 / solid_angle


@compiled(fastmath=())
def _point(
    x0: float, x1: float, y0: float, y1: float, height: float, u1: float, u2: float
) -> tuple[float, float]:
    """The point that u means, relative to x in the rectangle's axes (section 5 of the paper)."""
    solid_angle, k = _solid_angle(x0, x1, y0, y1, height)
    if solid_angle < MIN_SOLID_ANGLE:
        return x0 + u1 * (x1 - x0), y0 + u2 * (y1 - y0)
    b0 = -y0 / np.sqrt(height * height + y0 * y0)
    b1 = y1 / np.sqrt(height * height + y1 * y1)
    angle = u1 * solid_angle + k
    sine = np.sin(angle)
    f = (np.cos(angle) * b0 - b1) / (sine if abs(sine) > 1e-300 else 1e-300)
    c = np.copysign(1.0 / np.sqrt(max(f * f + b0 * b0, 1.0)), f)
    x = c * height / np.sqrt(max(1.0 - c * c, 1e-300))
    x = min(max(x, x0), x1)
    squared = x * x + height * height
    h0, h1 = y0 / np.sqrt(squared + y0 * y0), y1 / np.sqrt(squared + y1 * y1)
    h = h0 + u2 * (h1 - h0)
    y = h * np.sqrt(squared / max(1.0 - h * h, 1e-300))
    return x, min(max(y, y0), y1)


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
    frame, half = light.frame, light.half
    for i in range(len(x_world)):
        x = vector_at(x_world, i)
        x0, x1, y0, y1, height = _seen_from(frame, half, x)
        a, b = 0.0, 0.0
        if height > 0.0:
            a, b = _point(x0, x1, y0, y1, height, u[i, 0], u[i, 1])
        r = np.sqrt(a * a + b * b + height * height)
        scale = 1.0 / r if r > 0.0 else 0.0
        wi = (
            scale * (a * frame[0, 0] + b * frame[0, 1] - height * frame[0, 2]),
            scale * (a * frame[1, 0] + b * frame[1, 1] - height * frame[1, 2]),
            scale * (a * frame[2, 0] + b * frame[2, 1] - height * frame[2, 2]),
        )
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = wi
        distance[i], pdf[i] = r, _density(light, x, wi)


@compiled(fastmath=())
def _densities(
    numbers: np.ndarray, x_world: np.ndarray, d_world: np.ndarray, pdf: np.ndarray
) -> None:
    light = numbers[0]
    for i in range(len(x_world)):
        pdf[i] = _density(light, vector_at(x_world, i), vector_at(d_world, i))


class RectangleLight(PlacedLight):
    """A rectangle that faces +z in its own space, centred at the origin, its height along +y."""

    kind = "rectangle"
    NUMBERS = light_numbers(("frame", (3, 4)), ("half", 2))
    sample_kernel = staticmethod(_sample)
    density_kernel = staticmethod(_densities)

    def __init__(self, model: RectangleModel) -> None:
        width, height = model.size
        self.world_from_object = facing_frame(model.position, model.look_at, model.up)
        half = np.array([width / 2.0, height / 2.0])
        shape = {"frame": self.world_from_object[:3], "half": half}
        super().__init__(model, width * height, **shape)
        corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
        positions = (corners * [*half, 0.0]).astype(np.float32)
        self.scene = TriangleScene([(positions, np.array([[0, 1, 2], [0, 2, 3]], np.uint32))])


make = RectangleLight
