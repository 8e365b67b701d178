"""Packages with lobes for whole environments (RNA_environment), from random decoders."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from onnx import numpy_helper

from rna_sdk.package import query_width
from rna_sdk.package.packing import Unpacked
from tests.package.builders import make_decoder_model

NAME = "RNA_environment"
DECODER = f"extensions/{NAME}/decoder.onnx"
VISIBILITY = f"extensions/{NAME}/visibility.safetensors"
LOBES = 4


def with_lobes(
    source: Path, target: Path, record: dict[str, Any] | None = None, **entries: bytes
) -> Path:
    """A copy of a package of one surface that has lobes.

    record: members of the part's record to change; those that are None are left out. entries:
    `decoder` and `visibility`, in place of good ones.
    """
    own = Unpacked.read(source)
    part = own.manifest.tiers[0].parts[0]
    made = {
        "planes": part.planes,
        "decoder": DECODER,
        "inputs": list(part.inputs),
        "resolution": part.resolution,
        "channels": part.channels,
        "planePrecision": part.plane_precision,
        "decoderPrecision": "float32",
        "lobes": LOBES,
        "visibility": VISIBILITY,
        **(record or {}),
    }
    made = {name: value for name, value in made.items() if value is not None}
    columns = query_width(part.inputs, part.channels) + (16 if "visibility" in made else 0)
    files = {DECODER: decoder(columns)}
    if "visibility" in made:
        files[VISIBILITY] = harmonics(12)
    for name, data in entries.items():
        files[{"decoder": DECODER, "visibility": VISIBILITY}[name]] = data
    manifest = own.manifest.model_copy(
        update={
            "extensions_used": (*own.manifest.extensions_used, NAME),
            "extensions": {**own.manifest.extensions, NAME: {"parts": [made]}},
        }
    )
    replace(own, manifest=manifest, entries={**own.entries, **files}).write(target)
    return target


def decoder(columns: int, lobes: int = LOBES) -> bytes:
    """A random decoder of this many lobes."""
    model = make_decoder_model(columns, outputs=9 * lobes, output="environment")
    return bytes(model.SerializeToString())


def even_decoder(columns: int, amplitude: float, lobes: int = LOBES) -> bytes:
    """A decoder whose lobes have this amplitude, visible and shadowed, wherever it is asked."""
    model = make_decoder_model(columns, outputs=9 * lobes, output="environment")
    of_lobe = np.repeat([amplitude, amplitude, 8.0], 3)
    values = {"w0": 0.0, "b0": 0.0, "w1": 0.0, "b1": np.log1p(np.tile(of_lobe, lobes))}
    for tensor in model.graph.initializer:
        if tensor.name in values:
            old = numpy_helper.to_array(tensor)
            whole = np.broadcast_to(np.float32(values[tensor.name]), old.shape)
            tensor.CopyFrom(numpy_helper.from_array(np.ascontiguousarray(whole), tensor.name))
    return bytes(model.SerializeToString())


def harmonics(points: int, columns: int = 16) -> bytes:
    """A tensor file of random harmonics."""
    values = np.random.default_rng(0).integers(-127, 128, (points, columns)).astype(np.int8)
    tensor = {"dtype": "I8", "shape": [points, columns], "data_offsets": [0, values.size]}
    header = json.dumps({"harmonics": tensor}, separators=(",", ":")).encode()
    header += b" " * (-(8 + len(header)) % 64)
    return struct.pack("<Q", len(header)) + header + values.tobytes()
