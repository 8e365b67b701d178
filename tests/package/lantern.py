"""A small good package of two parts with emission, holes and glass."""

from pathlib import Path
from typing import Any

import numpy as np

from rna_sdk.package import (
    Manifest,
    Tier,
    TierData,
    TierEmission,
    TierPart,
    TransmittanceRecord,
    write_package,
)
from rna_sdk.package.textures.texture_form import Texture
from tests.package.builders import (
    FIBER_INPUTS,
    make_curves,
    make_manifest,
    make_mesh,
    make_part,
    make_tier_data,
    make_tier_part,
)

LEAF, PANE = "transmittance/leaf.safetensors", "transmittance/pane.safetensors"
MESH, CURVES = "geometry/body.glb", "geometry/tuft.safetensors"
GLOW, GLOW_COLUMNS = "decoders/small-body-glow.onnx", 11
SIZE = {"resolution": 3, "channels": 2}


def make_textures() -> dict[str, Texture]:
    """A cut-out of 3 rows of 4 texels, and a tint of one."""
    leaf = np.uint8([[0, 255, 255, 0], [0, 0, 255, 255], [128, 0, 0, 255]])
    return {LEAF: leaf[:, :, None], PANE: np.uint8([[[200, 150, 100]]])}


def make_lantern_manifest(**changes: Any) -> Manifest:
    """Manifest of a surface, `body`, and fibers, `tuft`, in two tiers; the body emits."""
    holes = (
        TransmittanceRecord(triangles=(0, 2), texture=LEAF, cutoff=0.5),
        TransmittanceRecord(triangles=(3, 1), texture=PANE, ior=(1.5, 1.5)),
    )
    parts = (
        make_part(name="body", geometry=MESH, transmittance=holes),
        make_part(name="tuft", kind="fiber", geometry=CURVES),
    )
    tiers = tuple(Tier(name=name, parts=(_body(name), _tuft(name))) for name in ("small", "hq"))
    return make_manifest(*tiers, **{"name": "lantern", "parts": parts, **changes})


def _body(tier: str) -> TierPart:
    emission = TierEmission(
        decoder=f"decoders/{tier}-body-glow.onnx",
        inputs=("features", "position", "normal", "wo"),
        decoder_precision="float32",
    )
    planes = "features/body.safetensors"
    return make_tier_part(f"{tier}-body", planes=planes, emission=emission, **SIZE)


def _tuft(tier: str) -> TierPart:
    return make_tier_part(f"{tier}-tuft", inputs=FIBER_INPUTS, **SIZE)


def make_lantern_data(manifest: Manifest) -> dict[str, list[TierData]]:
    """Tiers with other decoders and, of the body, the same planes."""
    layers = {"small": 1, "hq": 2}
    return {tier.name: make_tier_data(tier, 4, layers[tier.name]) for tier in manifest.tiers}


def make_lantern(path: str | Path, **changes: Any) -> Path:
    """Write the package to `path`; `changes` are fields of the manifest."""
    manifest = make_lantern_manifest(**changes)
    data = make_lantern_data(manifest)
    write_package(path, manifest, [make_mesh(), make_curves()], data, make_textures())
    return Path(path)
