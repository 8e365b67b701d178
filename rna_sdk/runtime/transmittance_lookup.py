"""Transmittance of holes and thin glass: spec/RNA.md, 4.4, in numpy.

For tests, tools and readers in Python; renderers have their own kernels for the same formula.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import indices
from rna_sdk.package import Mesh, Transmittance

Float = NDArray[np.float64]


def transmittance(
    mesh: Mesh,
    records: Sequence[Transmittance],
    triangle: NDArray[np.integer],
    u: NDArray[np.floating],
    v: NDArray[np.floating],
    direction: NDArray[np.floating],
) -> NDArray[np.float32]:
    """Fraction of light that passes straight through a mesh at ray hits; 0 where it is opaque.

    records: the part's (`asset.parts[k].transmittance_records`). triangle: (n,) indices of the hit
    triangles. u, v: (n,) barycentric coordinates of the second and third corner. direction: (n, 3)
    unit ray directions, object space.

    Returns (n, 3) float32 RGB, 0 to 1.

    Raises:
        QueryError: `triangle` is no such array, or a triangle is not there.

    Examples:
        >>> asset = load("toy.rna")  # opaque
        >>> first, middle = np.zeros(1, np.int32), np.full(1, 1 / 3, np.float32)
        >>> down, records = np.float32([[0, -1, 0]]), asset.transmittance_records
        >>> transmittance(asset.mesh, records, first, middle, middle, down).tolist()
        [[0.0, 0.0, 0.0]]
    """
    triangle = indices("triangle", triangle, len(mesh.triangles))
    tau = np.zeros((len(triangle), 3))
    for record in records:
        rows = np.flatnonzero((triangle >= record.first) & (triangle < record.first + record.count))
        corners = mesh.triangles[triangle[rows]]
        weights = np.stack([1.0 - u[rows] - v[rows], u[rows], v[rows]], axis=1, dtype=np.float64)
        if mesh.uvs is None:  # then the texture is one texel
            uv = np.zeros((len(corners), 2))
        else:
            uv = np.einsum("nk,nkc->nc", weights, mesh.uvs[corners].astype(np.float64))
        value = bilinear(record.texture, uv) / 255.0
        tau[rows] = value if record.cutoff is None else (value > record.cutoff).astype(np.float64)
        if record.ior is not None:  # the share that Fresnel's law reflects does not pass
            p = mesh.positions[corners].astype(np.float64)
            d = direction[rows].astype(np.float64)
            outward = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
            n = np.einsum("nk,nkc->nc", weights, mesh.normals[corners].astype(np.float64))
            length = np.linalg.norm(n, axis=1)
            n /= np.where(length > 0.0, length, 1.0)[:, None]
            eta = np.where(np.sum(d * outward, axis=1) < 0.0, *record.ior)
            tau[rows] *= 1.0 - fresnel(eta, np.minimum(np.abs(np.sum(n * d, axis=1)), 1.0))[:, None]
    return tau.astype(np.float32)


def fresnel(eta: Float, cosine: Float) -> Float:
    """Reflectance of unpolarised light at a smooth dielectric of relative index `eta`."""
    square = eta**2 - 1.0 + cosine**2
    total = square <= 0.0
    g = np.sqrt(np.where(total, 1.0, square))
    ratio = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0)
    return np.where(total, 1.0, ((g - cosine) / (g + cosine)) ** 2 * (1.0 + ratio**2) / 2.0)


def bilinear(texels: NDArray[np.uint8], uv: Float) -> Float:
    """(n, C): the integers of a texture (H, W, C) at uv (n, 2), repeated, interpolated."""
    height, width = texels.shape[:2]
    s, t = uv[:, 0] * width - 0.5, uv[:, 1] * height - 0.5
    i, j = np.floor(s), np.floor(t)
    a, b = (s - i)[:, None], (t - j)[:, None]
    columns = [np.mod(i + k, width).astype(np.int64) for k in (0, 1)]
    rows = [np.mod(j + k, height).astype(np.int64) for k in (0, 1)]
    upper, lower = (
        (1.0 - a) * texels[row, columns[0]] + a * texels[row, columns[1]] for row in rows
    )
    result: Float = (1.0 - b) * upper + b * lower
    return result
