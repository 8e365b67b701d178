"""Decoders as ONNX's own reference implementation runs them."""

import numpy as np
import onnx
from onnx.reference import ReferenceEvaluator

from rna_sdk.package import ProfileDecoder, decoder_to_bytes

_OPSET = 19  # the implementation has no older QuantizeLinear, whose meaning is the same


def onnx_result(decoder: ProfileDecoder, queries: np.ndarray) -> np.ndarray:
    """(n, outputs) float32 for queries (n, K) float32."""
    model = onnx.load_from_string(decoder_to_bytes(decoder))
    model.opset_import[0].version = _OPSET
    (result,) = ReferenceEvaluator(model).run(None, {"queries": queries})
    return np.asarray(result)
