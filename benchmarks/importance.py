"""How rays should leave a neural asset: the noise of several mixtures of lobes.

    python benchmarks/importance.py toy.rna blonde.rna --out benchmarks/results/importance.json

For points that are seen from all around, the variance of the estimate T / pdf of the light that
they send to the viewer under a white sky, over the square of its mean: 1 means that one ray has an
error as large as the value itself. "uniform" is the paper's way; "chosen" the lobes of
rna_render.bodies, the same for all assets of a kind; "best" the shares with the least variance for
this asset alone, of lobes of all widths at once (the variance is convex in the shares, and a
multiplicative update that keeps their sum finds them).
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
from report import publish

from rna_render.bodies import FIBER_LOBES, SURFACE_LOBES
from rna_render.neural_sampling import LobeMixture
from rna_render.points import Points, Role
from rna_render.render import place_asset
from rna_render.world import World
from rna_sdk.runtime import Asset, load

POINTS, DIRECTIONS, STEPS = 400, 1024, 100

# Widths of each lobe that are tried.
WIDTHS = {
    "uniform": {"uniform": {}},
    "cosine": {"cosine": {}},
    "mirror": {f"mirror {k}": {"mirror_kappa": k} for k in (8.0, 20.0, 60.0, 200.0)},
    "cone": {f"cone {s}": {"cone_scale": s} for s in (0.03, 0.06, 0.1, 0.2)},
    "forward": {f"forward {k}": {"forward_kappa": k} for k in (2.0, 5.0, 15.0, 40.0)},
}


def main() -> None:
    args = _parser().parse_args()
    publish({path.stem: _study(load(path)) for path in args.packages}, args.out)


def _study(asset: Asset) -> dict[str, Any]:
    transport = _Transport(asset)
    fiber = asset.kind == "fiber"
    lobes = [name for name in WIDTHS if fiber or name != "cone"]
    alone = {label: density for lobe in lobes for label, density in transport.densities(lobe)}
    cosine = LobeMixture(uniform=0.5, cosine=0.5)
    chosen = FIBER_LOBES if fiber else SURFACE_LOBES
    return {
        "uniform": transport.variance(alone["uniform"]),
        "half uniform, half cosine": transport.variance(transport.density(cosine)),
        "chosen": transport.variance(transport.density(chosen)),
        "chosen lobes": {f.name: getattr(chosen, f.name) for f in fields(chosen)},
        "best": transport.best_shares(alone),
    }


class _Transport:
    """T of some seen points towards their viewers, for directions all around: (m, d) float64."""

    def __init__(self, asset: Asset) -> None:
        rng = np.random.default_rng(0)
        points, wo = _seen_points(asset, rng)
        m = len(points.x)
        wi = _unit(rng.normal(size=(m * DIRECTIONS, 3)))
        row = np.repeat(np.arange(m), DIRECTIONS)
        values = np.empty(m * DIRECTIONS)
        for part in np.array_split(np.arange(len(row)), max(1, len(row) >> 18)):
            far = np.full(len(part), np.inf, np.float32)
            values[part] = points.transport(row[part], wi[part], far)[0].mean(axis=1)
        tangents = getattr(points, "tangents", np.zeros_like(points.n))
        self._shape = m, DIRECTIONS
        self._at = points.n[row], tangents[row], wo[row], wi
        self._squares = np.square(values).reshape(self._shape)
        self._mean_square = np.mean(np.square(values.reshape(self._shape).mean(axis=1) * 4 * np.pi))

    def density(self, mixture: LobeMixture) -> np.ndarray:
        return mixture.pdf(*self._at).astype(np.float64).reshape(self._shape)

    def densities(self, lobe: str) -> list[tuple[str, np.ndarray]]:
        return [
            (label, self.density(LobeMixture(**{lobe: 1.0}, **width)))
            for label, width in WIDTHS[lobe].items()
        ]

    def variance(self, density: np.ndarray) -> float:
        """Of one ray, over the square of the mean."""
        second = 4 * np.pi * np.mean(self._squares / np.maximum(density, 1e-9))
        return float(second / self._mean_square - 1.0)

    def best_shares(self, lobes: Mapping[str, np.ndarray]) -> dict[str, Any]:
        each = np.stack(list(lobes.values()))
        shares = np.full(len(each), 1.0 / len(each))
        for _ in range(STEPS):
            density = np.maximum(np.tensordot(shares, each, 1), 1e-9)
            shares *= np.sqrt(np.mean(self._squares / density**2 * each, axis=(1, 2)))
            shares /= shares.sum()
        kept = {k: round(float(s), 3) for k, s in zip(lobes, shares, strict=True) if s > 0.005}
        return {"variance": self.variance(np.tensordot(shares, each, 1)), "shares": kept}


def _seen_points(asset: Asset, rng: np.random.Generator) -> tuple[Points, np.ndarray]:
    """What rays from all around at the asset hit, and the directions back."""
    world = World([place_asset(asset, np.eye(4))])
    geometry = asset.curves.points if asset.kind == "fiber" else asset.mesh.positions
    centre = (geometry.min(axis=0) + geometry.max(axis=0)) / 2
    target = geometry[rng.integers(len(geometry), size=4 * POINTS)]
    eye = centre + 10.0 * world.radius * _unit(rng.normal(size=target.shape))
    direction = _unit(target - eye)
    hits = world.scene.intersect(eye.astype(np.float32), direction)
    vertices = world.vertices(Role.SCATTER, hits, direction)
    _, points = vertices.parts[0]
    return points, -direction[vertices.ray]


def _unit(vectors: np.ndarray) -> np.ndarray:
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description="Noise of ways to sample assets; prints JSON.")
    parser.add_argument("packages", type=Path, nargs="+", help=".rna files")
    parser.add_argument("--out", type=Path, help="file for the JSON")
    return parser


if __name__ == "__main__":
    main()
