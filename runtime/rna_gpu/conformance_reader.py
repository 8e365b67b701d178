"""The GPU as a reader program: `rna-conform -- python -m rna_gpu.conformance_reader`.

It has all levels that a GPU answers; packages are checked by the SDK on the CPU.
"""

import sys
from functools import cache

import numpy as np
from numpy.typing import NDArray

from rna_gpu.asset import GpuPart
from rna_gpu.device import Device, open_device
from rna_gpu.loading import load
from rna_gpu.scene.probe import Probe
from rna_sdk.conformance.reader_program import run_reader

Rows = NDArray[np.float32]


def evaluate(form: str, package: str, tier: str, part: int, arrays: dict[str, Rows]) -> Rows:
    """(n, width)."""
    asset = load(package, tier, _device())
    result = (asset if isinstance(asset, GpuPart) else asset.parts[part]).decode(form, arrays)
    return result.reshape(len(result), 3 * result.shape[1])


def visibility(package: str, records: bytes) -> Rows:
    """(n, 3): the visibility, RGB, of n hits."""
    return _probe(package).visibility(np.frombuffer(records, "<u4").reshape(-1, 8))


def normals(package: str, records: bytes) -> Rows:
    """Shading normals of queries at n hits on meshes, (n, 3)."""
    return _probe(package).normals(np.frombuffer(records, "<u4").reshape(-1, 8))


def base_color(package: str, records: bytes) -> Rows:
    """Base colours at n hits on meshes, (n, 3)."""
    words = np.frombuffer(records, "<u4").reshape(-1, 8)
    return _probe(package).base_colors(words, words.view("<f4")[:, 3])


@cache
def _device() -> Device:
    return open_device()


def _probe(package: str) -> Probe:
    return Probe(package, _device())


if __name__ == "__main__":
    sys.exit(
        run_reader(
            evaluate=evaluate,
            nearby=evaluate,
            visibility=visibility,
            normals=normals,
            base_color=base_color,
        )
    )
