"""Package files with a known transport."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from rna_sdk.package import (
    Curves,
    Mesh,
    ProfileLayer,
    Tier,
    TierData,
    TierEmission,
    TransmittanceRecord,
    decoder_to_bytes,
    write_package,
)
from tests.package.builders import (
    FIBER_INPUTS,
    decoder_of,
    make_manifest,
    make_part,
    make_planes,
    make_tier,
    make_tier_part,
)
from tests.render.assets import merged, sphere, square

ALBEDO = (0.8, 0.5, 0.2)
SHADOWED = (0.0, 0.0, 0.3)

COLUMNS = 18  # features 4, normal 3, wo 3, wi 3, half_vector 5
COSINE_COLUMN = 15  # n.wi, the third value of half_vector
FIBER_COLUMNS = 23  # features 4, tangent 3, h 1, wo 3, wi 3, fiber_angles 6, fiber_lobes 3
H_COLUMN = 7
EMISSION_COLUMNS = 7  # features 4, wo 3

_PIECES = 127


def write_lambert_package(
    path: Path, mesh: Mesh, tiers: tuple[str | Tier, ...] = ("small",), **changes: Any
) -> Path:
    """An asset with `visible` = ALBEDO / pi * max(n.wi, 0) and `shadowed` = SHADOWED.

    tiers: names, or records. changes: of the manifest.
    """
    records = [make_tier(tier) if isinstance(tier, str) else tier for tier in tiers]
    decoder = _lambert_decoder()
    data = {tier.name: [TierData(planes=make_planes(), decoder=decoder)] for tier in records}
    write_package(path, make_manifest(*records, **changes), [mesh], data)
    return path


def write_offset_package(path: Path, curves: Curves) -> Path:
    """A fiber asset with `visible` = (1 + h) / 2 in all channels and `shadowed` = SHADOWED."""
    tier = make_tier(inputs=FIBER_INPUTS)
    data = TierData(planes=make_planes(), decoder=_offset_decoder())
    write_package(path, make_manifest(tier, kind="fiber"), [curves], {tier.name: [data]})
    return path


def write_lamp_package(path: Path, glow: tuple[float, float, float], tint: np.ndarray) -> Path:
    """A bulb that emits `glow`, a shade of panes of transmittance `tint`, and a fringe of strands.

    The bulb is a ball of radius 0.2, the shade four sides of a cube of half-side 0.5, the fringe
    strands of radius 0.01 on its edge. Transport: nothing of the bulb; of the shade that of
    `write_lambert_package`; of the fringe that of `write_offset_package`. tint: (3,) uint8.
    """
    glowing = constant_decoder(EMISSION_COLUMNS, glow, "emission")
    dark = constant_decoder(COLUMNS, np.zeros(6))
    emission = TierEmission(
        decoder="decoders/glow.onnx", inputs=("features", "wo"), decoder_precision="float32"
    )
    tier = Tier(
        name="small",
        parts=(
            make_tier_part("bulb", emission=emission),
            make_tier_part("shade"),
            make_tier_part("fringe", inputs=FIBER_INPUTS),
        ),
    )
    texture = "transmittance/tint.safetensors"
    pane = TransmittanceRecord(triangles=(0, 8), texture=texture)
    parts = (
        make_part(name="bulb", geometry="geometry/bulb.glb"),
        make_part(name="shade", geometry="geometry/shade.glb", transmittance=(pane,)),
        make_part(name="fringe", kind="fiber", geometry="geometry/fringe.safetensors"),
    )
    data = [
        TierData(make_planes(), dark, {"emission": glowing}),
        TierData(make_planes(), _lambert_decoder()),
        TierData(make_planes(), _offset_decoder()),
    ]
    geometries = [sphere(3, radius=0.2), _shade(), _fringe()]
    manifest = make_manifest(tier, parts=parts)
    write_package(path, manifest, geometries, {"small": data}, {texture: tint.reshape(1, 1, 3)})
    return path


def _shade() -> Mesh:
    """Four upright sides of a cube of half-side 0.5 that face outward."""
    sides = []
    for quarter in range(4):
        cosine, sine = np.round([np.cos(quarter * np.pi / 2), np.sin(quarter * np.pi / 2)])
        turn = np.array([[cosine, 0, sine], [0, 1, 0], [-sine, 0, cosine]], np.float32)
        side = square(0.5, height=0.5)
        upright = np.float32([[1, 0, 0], [0, 0, -1], [0, 1, 0]]).T @ turn.T
        positions, normals = side.positions @ upright, side.normals @ upright
        sides.append(Mesh(positions, normals, None, side.triangles))
    return merged(*sides)


def _fringe() -> Curves:
    """Strands that stand on the upper edge of the shade's front."""
    x = np.linspace(-0.5, 0.5, 20)
    points = [[(place, 0.5, 0.5), (place, 0.7, 0.5)] for place in x]
    return Curves(
        np.float32(points).reshape(-1, 3),
        np.full(40, 0.01, np.float32),
        np.arange(0, 41, 2, dtype=np.uint32),
    )


def _lambert_decoder() -> bytes:
    ends = np.float64([[0, 0, 0, *SHADOWED], [*np.divide(ALBEDO, np.pi), *SHADOWED]])
    return ramp_decoder(COLUMNS, COSINE_COLUMN, (0.0, 1.0), ends)


def _offset_decoder() -> bytes:
    ends = np.float64([[0, 0, 0, *SHADOWED], [1, 1, 1, *SHADOWED]])
    return ramp_decoder(FIBER_COLUMNS, H_COLUMN, (-1.0, 1.0), ends)


def constant_decoder(
    columns: int, colours: Sequence[float] | np.ndarray, output: str = "transport"
) -> bytes:
    """A decoder that gives these colours, whatever it is asked."""
    weight = np.zeros((columns, len(colours)), np.float32)
    layer = ProfileLayer(weight, np.log1p(np.float32(colours)), 0.0, None, False)
    return decoder_to_bytes(decoder_of([layer], output=output))


def ramp_decoder(columns: int, column: int, span: tuple[float, float], ends: np.ndarray) -> bytes:
    """A decoder linear in one column between the ends of a span, and constant beyond.

    Its hidden layer makes pieces of the logarithm that a decoder takes the exponential of, shorter
    towards the first end; the error is 3e-5 of the result. ends: (2, outputs).
    """
    place = np.linspace(0, 1, _PIECES + 1) ** 2
    logs = np.log1p(ends[0] + place[:, None] * (ends[1] - ends[0]))
    knots = span[0] + place * (span[1] - span[0])
    slopes = np.diff(logs, axis=0) / np.diff(knots)[:, None]
    bends = np.diff(slopes, axis=0, prepend=0, append=0)
    first = np.zeros((columns, _PIECES + 1), np.float32)
    first[column] = 1
    layers = [
        ProfileLayer(first, -knots.astype(np.float32), 0.0, None, True),
        ProfileLayer(bends.astype(np.float32), logs[0].astype(np.float32), 0.0, None, False),
    ]
    return decoder_to_bytes(decoder_of(layers))
