"""Effect of prefiltered planes on assets that are small in the image: error and flicker.

    rna-bench prefiltered-planes examples/quickstart/toy.rna helmet.rna --out levels.json

Each package is seen from the front, so small that its bounding sphere is `height` pixels high, at
one sample a pixel, jittered, in 16 frames, and once at 128 samples a pixel: the reference. The
levels are means of 2 x 2 texels of the planes, level by level, with the same decoder (the format
has none: they helped neither asset, see benchmarks/results/levels.json). `error` is
the relative mean squared error of a frame against the reference (bias and noise), `flicker` the
share of it that changes from frame to frame; `bias` is the error of the mean of all frames. The
light is the sum of four suns.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.one_part import load_one_part
from rna_bench.options import add_out
from rna_bench.results import publish
from rna_export.capture.dataset.validation_view import picked
from rna_export.capture.rays.asset_scene import AssetScene
from rna_sdk.errors import QueryError
from rna_sdk.package import Package, TierData, float_planes, write_package
from rna_sdk.runtime import SurfaceAsset

HEIGHTS = (64, 32, 16)
_FRAMES = 16
_REFERENCE_FRAMES = 128
_LIGHTS = 4
_LEVELS = 4


def run(args: argparse.Namespace) -> None:
    publish({"packages": [measured(path, args.tier) for path in args.packages]}, args)


def measured(path: Path, tier: str | None) -> dict[str, Any]:
    """Figures of one package, by height and level."""
    with tempfile.TemporaryDirectory() as folder:
        levels = [_surface(level) for level in level_packages(path, tier, Path(folder))]
    with Package.open(path) as package:
        geometry = package.geometry()
    scene = AssetScene([geometry])
    rows = []
    for height in HEIGHTS:
        reference = _mean_of(levels[0], scene, height, _REFERENCE_FRAMES, 1)
        seen = [_figures(asset, scene, height, reference) for asset in levels]
        texels = [asset.tier.parts[0].resolution for asset in levels]
        rows.append({"height": height, "levels": dict(zip(map(str, texels), seen, strict=True))})
    return {"package": path.name, "heights": rows}


def _surface(path: Path) -> SurfaceAsset:
    asset = load_one_part(path)
    if not isinstance(asset, SurfaceAsset):
        raise QueryError(f"{path}: found a package of kind {asset.kind}, expected a surface")
    return asset


def level_packages(path: Path, tier: str | None, folder: Path) -> list[Path]:
    """The package of one tier, with planes of its own resolution, half of it, ..."""
    paths = []
    with Package.open(path) as package:
        manifest = package.manifest
        record = package.tier(tier or manifest.tiers[0].name)
        planes = float_planes(package.planes(record.name))
        for level in range(_LEVELS):
            resolution = planes.shape[1]
            part = record.parts[0].model_copy(
                update={"resolution": resolution, "plane_precision": "float32"}
            )
            changed = manifest.model_copy(
                update={"tiers": (record.model_copy(update={"parts": (part,)}),)}
            )
            data = TierData(planes, bytes(package.decoder(record.name)))
            paths.append(folder / f"{level}.rna")
            write_package(paths[-1], changed, [package.geometry()], {record.name: [data]})
            planes = halved(planes)
    return paths


def halved(planes: np.ndarray) -> np.ndarray:
    """Means of 2 x 2 texels, (3, R / 2, R / 2, C)."""
    k, r, _, c = planes.shape
    return planes.reshape(k, r // 2, 2, r // 2, 2, c).mean(axis=(2, 4), dtype=np.float32)


def _figures(
    asset: SurfaceAsset, scene: Any, height: int, reference: np.ndarray
) -> dict[str, float]:
    frames = np.stack([_frame(asset, scene, height, 2, k) for k in range(_FRAMES)])
    covered = reference.sum(axis=-1) > 0
    scale = np.mean(reference[covered] ** 2)
    error = np.mean((frames - reference)[:, covered] ** 2) / scale
    mean = frames.mean(axis=0)
    flicker = np.mean((frames - mean)[:, covered] ** 2) * _FRAMES / (_FRAMES - 1) / scale
    bias = np.mean((mean - reference)[covered] ** 2) / scale - flicker / _FRAMES
    return {"error": float(error), "flicker": float(flicker), "bias": float(bias)}


def _mean_of(asset: SurfaceAsset, scene: Any, height: int, frames: int, seed: int) -> np.ndarray:
    total = np.zeros((height, height, 3))
    for number in range(frames):
        total += _frame(asset, scene, height, seed, number)
    return total / frames


def _frame(asset: SurfaceAsset, scene: Any, height: int, seed: int, number: int) -> np.ndarray:
    """(height, height, 3) radiance at one sample a pixel, black beside the asset."""
    rng = np.random.default_rng((seed, number))
    row, column = np.divmod(np.arange(height * height), height)
    jitter = rng.random((2, height * height))
    right, up, to_eye = np.eye(3)
    across = 2 * scene.radius * (np.stack([column, -row]) + jitter * [[1], [-1]])
    x, y = across / height + scene.radius * np.array([[-1], [1]])
    origins = scene.centre + x[:, None] * right + y[:, None] * up + 2 * scene.radius * to_eye
    directions = np.tile(-to_eye, (len(origins), 1))
    points = scene.shade_points(origins.astype(np.float32), directions.astype(np.float32))
    (on,) = points.on
    x, n = on.points.x, on.points.n
    wo = np.tile(to_eye, (len(x), 1)).astype(np.float32)
    image = np.zeros((height * height, 3), np.float32)
    for wi in _lights():
        every_wi = np.tile(wi, (len(origins), 1)).astype(np.float32)
        visible = scene.visible(points, every_wi)[on.rows]
        image[on.rows] += picked(visible, *asset.evaluate(x, n, wo, every_wi[: len(x)]))
    return image.reshape(height, height, 3)


def _lights() -> np.ndarray:
    """Unit directions, spread over the half that the eye sees."""
    k = np.arange(_LIGHTS) + 0.5
    z, angle = k / _LIGHTS, 2.399963 * k
    flat = np.sqrt(1 - z**2)
    return np.stack([flat * np.cos(angle), flat * np.sin(angle), z], axis=1)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("packages", nargs="+", type=Path, help="of one surface each")
    parser.add_argument("--tier", help="of each package (default: the first)")
    add_out(parser)
