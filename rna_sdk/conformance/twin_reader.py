"""The runtime's numpy twin as a reader program, with the decoder's graph as the package has it.

rna-conform -- python -m rna_sdk.conformance.twin_reader
"""

from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray

from rna_sdk.conformance.reader_program import run_reader
from rna_sdk.package import Package, float_planes
from rna_sdk.package.decoder.decoder_form import form_named
from rna_sdk.package.decoder.query_arrays import QUERY_ARRAYS, in_order
from rna_sdk.reference.queries import fiber_queries_reference, queries_reference
from rna_sdk.runtime.engine.decoder_sessions import Graph


def evaluate(
    form: str, package: str, tier: str, part: int, arrays: dict[str, NDArray[np.float32]]
) -> NDArray[np.float32]:
    """(n, width): the decoder's output, 0 for rows that are no queries."""
    with Package.open(package) as opened:
        own = opened.tier(tier).parts[part]
        decoder = next((one for one in own.decoders if one.form.name == form), None)
        width = form_named(form).width(None) if decoder is None else decoder.width
        result = np.zeros((len(arrays["wo"]), width), np.float32)
        if decoder is None:
            return result
        valid = np.ones(len(result), bool)
        for array in (array for array in QUERY_ARRAYS if array.name in arrays):
            rows = arrays[array.name].reshape(len(result), -1)
            valid &= np.isfinite(rows).all(axis=1) & (rows.any(axis=1) | (not array.is_direction))
        at, axis, h, wo, wi = (array[valid] for array in in_order(arrays))
        planes, box = float_planes(opened.planes(tier, part)), opened.manifest.parts[part].bounds
        place = planes, box.corners(), decoder.inputs
        if opened.manifest.parts[part].kind == "surface":
            queries = queries_reference(*place, at, axis, wo, wi)
        else:
            queries = fiber_queries_reference(*place, at, axis, h, wo, wi)
        model = bytes(opened.decoder(tier, part, form))
        result[valid] = Graph(model, optimized=False).run(queries)
        return result


if __name__ == "__main__":
    sys.exit(run_reader(evaluate=evaluate))
