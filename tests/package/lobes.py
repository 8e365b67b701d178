"""Small packages with random lobes (RNA_environment)."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from rna_sdk.package import Curves, Lobes, Mesh, Package, Unpacked, query_width
from rna_sdk.package.packing import EnvironmentValidation
from tests.package.builders import FIBER_INPUTS, INPUTS, make_decoder

FOREST = EnvironmentValidation(
    environment="forest",
    psnr=28.5,
    psnr_with_lights=30.5,
    flip=0.05,
    brightness=(0.99, 1.0, 1.01),
)


def make_lobes(
    package: Package, part: int = 0, lobes: int = 4, visibility: bool = True, seed: int = 5
) -> Lobes:
    """Random lobes of a part, on the planes of the first tier."""
    tier, geometry = package.manifest.tiers[0], package.geometry(part)
    inputs = INPUTS if isinstance(geometry, Mesh) else FIBER_INPUTS
    columns = query_width(inputs, tier.parts[part].channels) + 16 * visibility
    decoder = make_decoder(
        *("float32", columns, 16, 2, seed), outputs=9 * lobes, output="environment"
    )
    harmonics = make_harmonics(geometry) if visibility else None
    return Lobes(tier.name, lobes, inputs, decoder, harmonics)


def make_harmonics(geometry: Mesh | Curves) -> np.ndarray:
    """Random numbers, (vertices, 16) int8."""
    vertices = len(geometry.positions if isinstance(geometry, Mesh) else geometry.points)
    return np.random.default_rng(3).integers(-127, 128, (vertices, 16)).astype(np.int8)


def add_lobes(path: Path, out: Path, *parts: int, visibility: bool = True) -> Path:
    """Write the package at `path` with random lobes of these parts to `out`."""
    with Package.open(path) as package:
        count = len(package.manifest.parts)
        own = [
            make_lobes(package, k, visibility=visibility) if k in parts else None
            for k in range(count)
        ]
    Unpacked.read(path).with_environment(own, [FOREST]).write(out)
    return out
