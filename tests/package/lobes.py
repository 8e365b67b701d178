"""Small packages with lobes (RNA_environment), from random decoders."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from rna_sdk.package import (
    Curves,
    EnvironmentValidation,
    Lobes,
    Mesh,
    Package,
    ProfileLayer,
    Unpacked,
    decoder_to_bytes,
    query_width,
)
from tests.package.builders import FIBER_INPUTS, INPUTS, decoder_of, make_decoder

LOBES = 4
FOREST = EnvironmentValidation(
    environment="forest", psnr=28.5, psnr_with_lights=30.5, flip=0.05, brightness=(0.99, 1.0, 1.01)
)


def make_lobes(
    package: Package, part: int = 0, lobes: int = LOBES, visibility: bool = True
) -> Lobes:
    """Random lobes of a part, on the planes of the first tier."""
    tier, geometry = package.manifest.tiers[0], package.geometry(part)
    inputs = INPUTS if isinstance(geometry, Mesh) else FIBER_INPUTS
    columns = query_width(inputs, tier.parts[part].channels) + 16 * visibility
    sizes = columns, 16, 2, 5
    decoder = make_decoder("float32", *sizes, outputs=9 * lobes, output="environment")
    harmonics = make_harmonics(geometry) if visibility else None
    return Lobes(tier.name, lobes, inputs, decoder, harmonics)


def make_harmonics(geometry: Mesh | Curves) -> np.ndarray:
    """Random numbers, (vertices, 16) int8."""
    vertices = len(geometry.positions if isinstance(geometry, Mesh) else geometry.points)
    return np.random.default_rng(3).integers(-127, 128, (vertices, 16)).astype(np.int8)


def even_decoder(columns: int) -> bytes:
    """A decoder whose lobes have amplitude 1/8 everywhere, visible and shadowed."""
    of_lobe = np.repeat([0.125, 0.125, 8.0], 3)
    bias = np.log1p(np.tile(of_lobe, LOBES)).astype(np.float32)
    layer = ProfileLayer(np.zeros((columns, 9 * LOBES), np.float32), bias, 0.0, None, False)
    return decoder_to_bytes(decoder_of([layer], output="environment"))


def with_lobes(
    source: Path, target: Path, *parts: int, visibility: bool = True, decoder: bytes | None = None
) -> Path:
    """A copy of a package with random lobes of these parts, or of the first; its path.

    decoder: in place of a random one.
    """
    with Package.open(source) as package:
        by_part: list[Lobes | None] = [None] * len(package.manifest.parts)
        for k in parts or (0,):
            made = make_lobes(package, k, visibility=visibility)
            by_part[k] = replace(made, decoder=decoder or made.decoder)
    Unpacked.read(source).with_environment(by_part, [FOREST]).write(target)
    return target
