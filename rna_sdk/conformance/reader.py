"""The SDK as a reader program: `rna-conform -- python -m rna_sdk.conformance.reader`.

It has no rays, and so no visibility; `rna_render.conformance_reader` has.
"""

from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray

from rna_sdk.conformance.reader_program import run_reader
from rna_sdk.package.issues import is_valid
from rna_sdk.package.validator import validate


def evaluate(
    package: str, tier: str, part: int, queries: NDArray[np.float32]
) -> NDArray[np.float32]:
    """(n, 6) by the runtime for (n, 13) queries."""
    from rna_sdk.runtime import SurfaceAsset, load

    position, axis, h, wo, wi = np.split(queries, (3, 6, 7, 10), axis=1)
    own = load(package, tier).parts[part]
    if isinstance(own, SurfaceAsset):
        return np.hstack(own.evaluate(position, axis, wo, wi))
    return np.hstack(own.evaluate(position, axis, h[:, 0], wo, wi))


def emission(
    package: str, tier: str, part: int, queries: NDArray[np.float32]
) -> NDArray[np.float32]:
    """(n, 3) by the runtime for (n, 10) queries."""
    from rna_sdk.runtime import SurfaceAsset, load

    position, axis, h, wo = np.split(queries, (3, 6, 7), axis=1)
    own = load(package, tier).parts[part]
    if isinstance(own, SurfaceAsset):
        return own.emission(position, axis, wo)
    return own.emission(position, axis, h[:, 0], wo)


def check(package: str) -> tuple[bool, list[str]]:
    """Whether the package is valid, and the codes of its issues."""
    issues = validate(package)
    return is_valid(issues), [issue.code for issue in issues]


if __name__ == "__main__":
    sys.exit(run_reader(evaluate=evaluate, emission=emission, validate=check))
