"""Datasets that numpy makes: a ball of translucent plastic with known transport."""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch

from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_manifest import CapturedPart, CaptureManifest
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.sample_files import write_parts
from rna_export.training.presets import PRESETS, Preset
from tests.render.assets import sphere
from tests.runtime.points import unit_vectors

ALBEDO = np.array([0.8, 0.5, 0.2])
LIGHTS_A_SHARD = 8
RAYS = 256
BALL_PART = CapturedPart(name="asset", kind="surface", bounds=((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0)))


def tiny(preset: str = "small", kind: str = "surface", **training: object) -> Preset:
    """Like the preset, but trained within a second: 16 texels, 2 layers of 16."""
    named = PRESETS[kind][preset]
    shadow = min(named.model.shadow_width, 8)
    small = named.with_model(resolution=16, width=16, hidden_layers=2, shadow_width=shadow)
    return small.with_training(**{"steps": 40, "batch": 512, **training})


@contextmanager
def hurried_packages() -> Iterator[None]:
    """Little tuning of int8 decoders, where no test looks at its result."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("rna_export.export.int8_tuning._STEPS", 8)
        yield


def manifest_of(settings: CaptureSettings, **others: Any) -> CaptureManifest:
    """Manifest of a capture of one ball, except for `others`."""
    ball = {
        "name": "ball",
        "source": "ball.py",
        "source_sha256": "0" * 64,
        "blender": "none",
        "generator": "tests",
        "parts": (BALL_PART,),
        "opaque_cutouts": False,
    }
    return CaptureManifest(settings=settings, **{**ball, **others})


def make_dataset(
    folder: Path, seed: int = 0, shards: int = 3, views: int = 2, domain: str = "sphere"
) -> DatasetPart:
    """The part of a finished dataset without noise; `domain` is only what it says of itself."""
    settings = CaptureSettings(
        lights=shards * LIGHTS_A_SHARD,
        lights_per_shard=LIGHTS_A_SHARD,
        rays=RAYS,
        validation_views=views,
        validation_resolution=24,
        domain=domain,
        seed=seed,
    )
    manifest = manifest_of(settings, source_sha256=f"{seed:064x}")
    dataset = Dataset.create(folder, manifest, {"asset": sphere(3)})
    rng = np.random.default_rng(seed)
    for shard in range(shards):
        wi = np.repeat(unit_vectors(rng, LIGHTS_A_SHARD), RAYS, axis=0)
        write_parts(dataset.train_path(shard), {"asset": samples_of_light(rng, wi)})
    for view in range(views):
        write_view(dataset, view, rng)
    write_parts(dataset.white_path, {"asset": white_samples()})
    return dataset.only


def transport(n: np.ndarray, wo: np.ndarray, wi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Radiance (n, 3) and visibility (n,) on the ball: a diffuse coat that glows through, shiny."""
    cosine = np.sum(n * wi, axis=1, keepdims=True)
    h = wi + wo
    h = h / np.maximum(np.linalg.norm(h, axis=1, keepdims=True), 1e-6)
    shine = np.maximum(np.sum(n * h, axis=1, keepdims=True), 0.0) ** 60
    lit = ALBEDO / np.pi * cosine + 0.5 * shine * cosine + 0.03
    through = 0.03 + 0.02 * ALBEDO * cosine
    visible = cosine[:, 0] > 0.0
    return np.where(visible[:, None], lit, through).astype(np.float32), visible


def samples_of_light(rng: np.random.Generator, wi: np.ndarray) -> dict[str, np.ndarray]:
    """Samples at random points, seen from random directions, one for each wi (n, 3)."""
    return _samples(*_seen(rng, len(wi)), wi)


@cache
def white_samples() -> dict[str, np.ndarray]:
    """Samples of some rays in a white world, with uniform directions."""
    rng = np.random.default_rng(17)
    n, wo = _seen(rng, 128)
    every = [np.tile(wi, (len(n), 1)) for wi in unit_vectors(rng, 2000)]
    white = 4.0 * np.pi * np.mean([transport(n, wo, wi)[0] for wi in every], axis=0)
    pieces = [_samples(n, wo, wi) for wi in every[:64]]
    samples = {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}
    weight = np.full(len(samples["wi"]), 4.0 * np.pi, np.float32)
    return {**samples, "radiance": np.tile(white.astype(np.float32), (64, 1)), "weight": weight}


def _seen(rng: np.random.Generator, count: int) -> tuple[np.ndarray, np.ndarray]:
    n = unit_vectors(rng, count)
    wo = unit_vectors(rng, count)
    return n, np.where(np.sum(n * wo, axis=1, keepdims=True) < 0.0, -wo, wo)


def _samples(n: np.ndarray, wo: np.ndarray, wi: np.ndarray) -> dict[str, np.ndarray]:
    radiance, visible = transport(n, wo, wi)
    wi = wi.astype(np.float32)
    return {
        "position": n,
        "normal": n,
        "wo": wo,
        "wi": wi,
        "radiance": radiance,
        "visible": visible.astype(np.uint8),
    }


def write_view(dataset: Dataset, view: int, rng: np.random.Generator) -> None:
    """Both halves of a validation image, under another light each time."""
    size = dataset.manifest.settings.validation_resolution
    at = (np.arange(size) + 0.5) / size * 2.0 - 1.0
    x, y = (values.reshape(-1) for values in np.meshgrid(at, -at))
    pixel = np.flatnonzero(x**2 + y**2 < 0.95)
    x, y = x[pixel], y[pixel]
    n = np.stack([x, y, np.sqrt(1.0 - x**2 - y**2)], axis=1).astype(np.float32)
    wo = np.tile(np.float32([0, 0, 1]), (len(n), 1))
    wi = np.tile(
        unit_vectors(rng, 1) * np.float32([1, 1, 0.3]) + np.float32([0, 0, 0.7]), (len(n), 1)
    )
    wi /= np.linalg.norm(wi, axis=1, keepdims=True)
    samples = _samples(n, wo, wi)
    for half, sign in ((0, 1.0), (1, -1.0)):
        noise = (sign * 1e-4 * np.ones_like(n)).astype(np.float32)
        arrays = {**samples, "radiance": samples["radiance"] + noise}
        part = {**arrays, "pixel": pixel.astype(np.int32)}
        write_parts(dataset.validation_path(view, half), {"asset": part})


def printed_points(count: int, kind: str) -> dict[str, torch.Tensor]:
    """Queries of either kind at random places, with base colours."""
    rng = np.random.default_rng(0)
    samples = samples_of_light(rng, unit_vectors(rng, count))
    samples["base_color"] = rng.random((count, 3), dtype=np.float32)
    if kind == "fiber":
        samples["tangent"] = samples.pop("normal")
        samples["h"] = rng.uniform(-1, 1, count).astype(np.float32)
    return {name: torch.from_numpy(np.ascontiguousarray(v)) for name, v in samples.items()}
