"""What callers get whatever a decoder gives."""

from __future__ import annotations

import numpy as np

from rna_sdk.runtime.kernels.output_kernel import result_kernel


def test_any_decoder_output_becomes_finite_and_non_negative() -> None:
    largest = np.finfo(np.float32).max
    transport = np.float32(
        [
            [1, 2, 3, 4, 5, 6],
            [np.nan, np.inf, -np.inf, -1, -0.0, 1e-45],
            [7, 7, 7, 7, 7, 7],
            [9, 9, 9, 9, 9, 9],  # a row of padding
        ]
    )
    visible, shadowed = np.empty((2, 3, 3), np.float32)
    for column, colours in ((0, visible), (3, shadowed)):
        result_kernel(3)(transport, column, np.array([True, True, False]), colours)
    np.testing.assert_array_equal(visible, np.float32([[1, 2, 3], [0, largest, 0], [0, 0, 0]]))
    np.testing.assert_array_equal(shadowed, np.float32([[4, 5, 6], [0, 0, 1e-45], [0, 0, 0]]))


def test_signed_columns_keep_negative_values() -> None:
    largest = np.finfo(np.float32).max
    output = np.float32(
        [
            [9, -1, -1, 2],
            [9, -np.inf, np.nan, -np.inf],
            [9, np.nan, np.inf, np.inf],
            [9, -7, 7, 7],
        ]
    )
    found = np.empty((4, 3), np.float32)
    result_kernel(3, (0, 2))(output, 1, np.array([True, True, True, False]), found)
    expected = [[-1, 0, 2], [-largest, 0, -largest], [0, largest, largest], [0, 0, 0]]
    np.testing.assert_array_equal(found, np.float32(expected))
