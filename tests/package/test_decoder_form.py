"""Decoder forms and the query record; that of lobes has a width that varies."""

import numpy as np
import pytest

from rna_sdk.errors import PackageError
from rna_sdk.package import EnvironmentPart, decoder_from_bytes
from rna_sdk.package.decoder.decoder_checks import check_decoder
from rna_sdk.package.decoder.decoder_form import (
    EMISSION,
    ENVIRONMENT,
    FORMS,
    TRANSPORT,
    PartDecoder,
    allowed,
)
from rna_sdk.package.decoder.query_arrays import QUERY_ARRAYS, arrays_of, column_count, in_order
from rna_sdk.runtime.engine.decoder_sessions import Decoder
from tests.package.builders import make_decoder

INPUTS = ("features", "normal", "wo")


def declared(lobes: int, visibility: str | None = None) -> PartDecoder:
    fields = {"planes": "features/small.safetensors", "decoder": "decoders/lobes.onnx"}
    record = {**fields, "inputs": INPUTS, "resolution": 8, "channels": 4, "lobes": lobes}
    precisions = {"plane_precision": "int8", "decoder_precision": "float32"}
    return EnvironmentPart(**record, **precisions, visibility=visibility).optional_decoder


def test_a_decoder_of_lobes_is_checked_and_run():
    decoder = declared(4)
    assert (decoder.columns, decoder.width) == (10, 36)
    assert declared(4, "visibility.safetensors").columns == 26
    model = make_decoder(
        "float32", decoder.columns, 16, 2, outputs=decoder.width, output="environment"
    )
    assert check_decoder(memoryview(model), decoder) == []
    queries = np.random.default_rng(0).normal(size=(50, 10)).astype(np.float32)
    assert Decoder(decoder_from_bytes(model, "lobes")).run(queries).shape == (50, 36)
    with pytest.raises(PackageError, match="DECODER_PROFILE") as caught:
        check_decoder(memoryview(model), declared(6))
    assert "expected environment of 54 columns" in str(caught.value)


def test_outputs_are_finite_and_not_negative():
    output = np.array([[np.nan, -1.0, -0.0, 1.0, np.inf, -np.inf]])
    assert allowed(output).tolist() == [[False, False, True, True, False, False]]
    assert TRANSPORT.result_count(None) == 2 and ENVIRONMENT.result_count(None) == 3


def test_a_form_without_a_light_has_no_block_of_one():
    for kind, axis in (("surface", "normal"), ("fiber", "tangent")):
        assert {"features", "position", axis, "wo"} <= set(EMISSION.blocks(kind))
        assert "wi" not in EMISSION.blocks(kind) and "wi" in TRANSPORT.blocks(kind)
        assert ENVIRONMENT.blocks(kind) == TRANSPORT.blocks(kind)


def test_every_form_is_asked_with_arrays_of_the_record():
    known = {array.name for array in QUERY_ARRAYS}
    for form in (*FORMS, ENVIRONMENT):
        assert set(form.arrays) <= known
    assert [column_count(form.arrays) for form in FORMS] == [16, 10]


def test_arrays_that_are_not_there_have_others_in_their_place():
    rows = np.arange(20, dtype=np.float32).reshape(2, 10)
    arrays = arrays_of(rows, EMISSION.arrays)
    assert {name: values.shape for name, values in arrays.items()} == {
        **{"position": (2, 3), "axis": (2, 3)},
        **{"h": (2,), "wo": (2, 3)},
    }
    np.testing.assert_array_equal(np.column_stack(list(arrays.values())), rows)
    *_, wo, wi = in_order(arrays)
    assert wi is wo
    del arrays["h"]
    assert in_order(arrays)[2].shape == (0,)
