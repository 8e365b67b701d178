"""What a triangle lets through: spec/RNA.md, 4.4, in float64, hit by hit as the text has it."""

import math
from collections.abc import Sequence

import numpy as np

from rna_sdk.package import Mesh, Transmittance


def tau(
    mesh: Mesh,
    records: Sequence[Transmittance],
    triangle: np.ndarray,
    weights: np.ndarray,
    d: np.ndarray,
) -> np.ndarray:
    """(n, 3) for hits on triangles (n,) with barycentric weights (n, 3) by rays along d (n, 3)."""
    result = np.zeros((len(triangle), 3))
    for row, number in enumerate(triangle):
        for record in records:
            if record.first <= number < record.first + record.count:
                corners = mesh.triangles[number]
                result[row] = _looked_up(record, mesh, corners, weights[row])
                if record.ior is not None:
                    result[row] *= 1 - _fresnel(record.ior, mesh, corners, weights[row], d[row])
    return result


def _looked_up(
    record: Transmittance, mesh: Mesh, corners: np.ndarray, weights: np.ndarray
) -> np.ndarray:
    texels = record.texture.astype(np.float64) / 255
    height, width = texels.shape[:2]
    u, v = (0.0, 0.0) if mesh.uvs is None else weights @ mesh.uvs[corners].astype(np.float64)
    s, t = u * width - 0.5, v * height - 0.5
    i, j = math.floor(s), math.floor(t)
    a, b = s - i, t - j
    texel = lambda row, column: texels[row % height, column % width]  # noqa: E731
    value = (1 - b) * ((1 - a) * texel(j, i) + a * texel(j, i + 1))
    value = value + b * ((1 - a) * texel(j + 1, i) + a * texel(j + 1, i + 1))
    return value if record.cutoff is None else (value > record.cutoff).astype(np.float64)


def _fresnel(
    ior: tuple[float, float], mesh: Mesh, corners: np.ndarray, weights: np.ndarray, d: np.ndarray
) -> float:
    p = mesh.positions[corners].astype(np.float64)
    n_g = np.cross(p[1] - p[0], p[2] - p[0])
    n = weights @ mesh.normals[corners].astype(np.float64)
    eta, c = ior[0] if d @ n_g < 0 else ior[1], abs(d @ n) / np.linalg.norm(n)
    square = eta**2 - 1 + c**2
    if square <= 0:
        return 1.0
    g = math.sqrt(square)
    ratio = (c * (g + c) - 1) / (c * (g - c) + 1)
    return float(((g - c) / (g + c)) ** 2 * (1 + ratio**2) / 2)
