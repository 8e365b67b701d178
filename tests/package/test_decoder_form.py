"""Decoder forms and the query record; a form that no package has, of a width that varies."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from rna_sdk.package import PackageError, query_width
from rna_sdk.package.decoder.decoder_checks import check_decoder
from rna_sdk.package.decoder.decoder_form import (
    EMISSION,
    FORMS,
    TRANSPORT,
    DecoderForm,
    PartDecoder,
)
from rna_sdk.package.decoder.query_arrays import QUERY_ARRAYS, arrays_of, column_count, in_order
from rna_sdk.runtime.engine.decoder_sessions import Decoder
from tests.package.builders import make_decoder

LOBES = DecoderForm(
    "lobes",
    ("lobe",),
    ("position", "axis", "h", "wo"),
    "lobes",
    columns=7,
    count="number",
    signed=(0, 1, 2),
)
INPUTS = ("features", "normal", "wo")


def declared(number: int) -> PartDecoder:
    width = LOBES.width(SimpleNamespace(number=number))
    columns = query_width(INPUTS, 4)
    return PartDecoder(LOBES, "decoders/lobes.onnx", columns, width, "float32", INPUTS)


def test_a_decoder_of_another_form_is_checked_and_run() -> None:
    own = declared(4)
    assert (own.columns, own.width) == (10, 28)
    model = make_decoder("float32", own.columns, 16, 2, outputs=own.width, output=LOBES.name)
    assert check_decoder(memoryview(model), own) == []
    queries = np.random.default_rng(0).normal(size=(50, 10)).astype(np.float32)
    assert Decoder(model).run(queries).shape == (50, 28)
    with pytest.raises(PackageError, match="DECODER_OUTPUT") as caught:
        check_decoder(memoryview(model), declared(5))
    assert "lobes float32 [N, 35]" in str(caught.value)


def test_signed_columns_of_each_result_may_be_negative() -> None:
    output = np.array([[np.nan, *[-1.0] * 6, *[1.0] * 6, np.inf]])
    negative = [False, True, True, *[False] * 4]
    assert LOBES.allowed(output).tolist() == [[*negative, *[True] * 6, False]]
    assert TRANSPORT.allowed(-output[:, 1:7]).all()
    assert not TRANSPORT.allowed(output[:, 1:7]).any()
    assert LOBES.result_count(None) == 1 and TRANSPORT.result_count(None) == 2
    assert declared(4).form.result_count(SimpleNamespace(number=4)) == 4


def test_a_form_without_a_light_has_no_block_of_one() -> None:
    for kind, axis in (("surface", "normal"), ("fiber", "tangent")):
        assert LOBES.blocks(kind) == EMISSION.blocks(kind)
        assert {"features", "position", axis, "wo"} <= set(LOBES.blocks(kind))
        assert "wi" not in LOBES.blocks(kind) and "wi" in TRANSPORT.blocks(kind)


def test_every_form_is_asked_with_arrays_of_the_record() -> None:
    known = {array.name for array in QUERY_ARRAYS}
    for form in (*FORMS, LOBES):
        assert set(form.arrays) <= known
    assert [column_count(form.arrays) for form in FORMS] == [13, 10]


def test_arrays_that_are_not_there_have_others_in_their_place() -> None:
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
