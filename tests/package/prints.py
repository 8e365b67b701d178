"""A small good package of one part with base colour, and with a decoder for shadowed light."""

import io
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from rna_sdk.package import BaseColorRecord, Manifest, Tier, TierShadowed, write_package
from rna_sdk.package.manifest.extensions import Variants
from rna_sdk.package.packing import Unpacked
from tests.package.builders import (
    INPUTS,
    make_manifest,
    make_mesh,
    make_part,
    make_tier,
    make_tier_data,
)

LABEL, STAMP = "textures/label.png", "textures/stamp.jpg"
RED = "extensions/RNA_variants/red.png"
SHADOWED = "decoders/hq-shadowed.onnx"


def image_bytes(pixels: np.ndarray, kind: str = "PNG", **options: Any) -> bytes:
    """The file of an image, (H, W, 3) or (H, W) uint8."""
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, kind, **options)
    return file.getvalue()


def make_images() -> dict[str, bytes]:
    """A label of 3 rows of 4 texels, and a stamp of one."""
    label = np.random.default_rng(7).integers(0, 256, (3, 4, 3)).astype(np.uint8)
    return {LABEL: image_bytes(label), STAMP: image_bytes(np.uint8([[[40, 160, 90]]]), "JPEG")}


def make_print_manifest(**changes: Any) -> Manifest:
    """In the two of `tiers`.

    `changes` are fields of the manifest.
    """
    records = (
        BaseColorRecord(
            triangles=(0, 2),
            image=LABEL,
            factor=(0.5, 1.0, 0.25),
            wrap=("mirror", "clamp"),
            transform=(2.0, 0.1, 0.3, -0.2, 1.5, 0.0),
        ),
        BaseColorRecord(triangles=(2, 1), image=STAMP, color_space="linear"),
        BaseColorRecord(triangles=(3, 1), factor=(0.2, 0.3, 0.4)),
    )
    part = make_part(base_color=records)
    made = {"name": "print", "parts": (part,), "tiers": tiers(), **changes}
    return make_manifest(*made.pop("tiers"), **made)


def tiers(uses_base_color: bool | None = True, precision: str = "float32") -> tuple[Tier, Tier]:
    """On one file of planes; `hq` has one decoder for visible and one for shadowed light."""
    shadowed = TierShadowed(
        decoder=SHADOWED, inputs=INPUTS[:4], decoder_precision=precision, agreement=None
    )
    same: dict[str, Any] = {
        **{"planes": "features/p.safetensors", "resolution": 3, "channels": 2},
        **{"uses_base_color": uses_base_color, "decoder_precision": precision},
    }
    return make_tier("small", **same), make_tier("hq", shadowed=shadowed, **same)


def make_print(path: str | Path, images: Mapping[str, bytes] | None = None, **changes: Any) -> Path:
    """Write the package to `path`; images: files by entry; `changes` are fields of the manifest."""
    manifest = make_print_manifest(**changes)
    data = {tier.name: make_tier_data(tier) for tier in manifest.tiers}
    write_package(path, manifest, [make_mesh()], data, images or make_images())
    return Path(path)


def make_variants(path: str | Path, **changes: Any) -> Path:
    """The package with two variants: `deep red` changes the first and the last record of three."""
    red = {"image": RED, "factor": [1.0, 0.5, 0.5], "wrap": ["repeat", "clamp"]}
    records = [red, None, {"factor": [0.75, 0.125, 0.0]}]
    variants = [{"name": "as it is", "parts": [None]}, {"name": "deep red", "parts": [records]}]
    made, file = Unpacked.read(make_print(path, **changes)), image_bytes(RED_PIXELS)
    made.with_extension(Variants.model_validate({"variants": variants}), {RED: file}).write(path)
    return Path(path)


RED_PIXELS = np.random.default_rng(8).integers(0, 256, (2, 5, 3)).astype(np.uint8)
