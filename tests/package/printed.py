"""A small good package of one part with base colour: two images, a plain colour, and none."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from rna_sdk.package import BaseColorRecord, Manifest, Mesh, write_package
from rna_sdk.package.manifest.manifest_tiers import TierShadowed
from tests.package.builders import (
    INPUTS,
    make_manifest,
    make_mesh,
    make_part,
    make_tier,
    make_tier_data,
)

LABEL, CLOTH = "textures/label.png", "textures/cloth.webp"


def png(pixels: np.ndarray, form: str = "PNG") -> bytes:
    """The lossless file of (h, w, 3 or 4) uint8."""
    file = io.BytesIO()
    more = {"lossless": True, "exact": True} if form == "WEBP" else {}
    Image.fromarray(pixels).save(file, form, **more)
    return file.getvalue()


def make_images(seed: int = 3) -> dict[str, bytes]:
    """A PNG of 5 rows of 12 pixels whose alpha is 0 here and there, and a WebP of 8 rows of 8."""
    rng = np.random.default_rng(seed)
    label = rng.integers(0, 256, (5, 12, 4)).astype(np.uint8)
    label[:2, :, 3] = 0
    cloth = rng.integers(0, 256, (8, 8, 3)).astype(np.uint8)
    return {LABEL: png(label), CLOTH: png(cloth, "WEBP")}


def records() -> tuple[BaseColorRecord, ...]:
    """Of triangles 0, 1 and 2 of make_mesh; its last has none."""
    turned = (0.0, 2.0, -0.3, -1.5, 0.0, 0.8)
    return (
        BaseColorRecord(triangles=(0, 1), image=LABEL, factor=(0.9, 0.5, 1.0)),
        BaseColorRecord(
            triangles=(1, 1),
            image=CLOTH,
            color_space="linear",
            wrap=("mirror", "clamp"),
            transform=turned,
        ),
        BaseColorRecord(triangles=(2, 1), factor=(0.2, 0.7, 0.4)),
    )


def shadowed_decoder(name: str, precision: str = "float32") -> TierShadowed:
    """The record of a decoder of shadowed light alone."""
    entry = f"decoders/{name}-shadowed.onnx"
    inputs = tuple(block for block in INPUTS if block != "half_vector")
    return TierShadowed(decoder=entry, inputs=inputs, decoder_precision=precision)


def make_printed_manifest(**changes: Any) -> Manifest:
    """Two tiers that use base colour, the second with a decoder for shadowed light, in int8."""
    members = {"uses_base_color": True, "planes": "features/p.safetensors"}
    apart = {"shadowed": shadowed_decoder("hq", "int8"), "decoder_precision": "int8"}
    tiers = [make_tier("small", **members), make_tier("hq", **members, **apart)]
    part = make_part(base_color=records())
    return make_manifest(*tiers, **{"name": "printed", "parts": (part,), **changes})


def make_printed(path: str | Path, mesh: Mesh | None = None, **changes: Any) -> Path:
    """Write the package to `path`; `changes` are fields of the manifest."""
    manifest = make_printed_manifest(**changes)
    data = {tier.name: make_tier_data(tier) for tier in manifest.tiers}
    write_package(path, manifest, [mesh or make_mesh()], data, make_images())
    return Path(path)
