"""What callers get whatever a decoder gives."""

import numpy as np

from rna_sdk.runtime.kernels.output_kernel import write_results


def test_any_decoder_output_becomes_finite_and_non_negative():
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
        write_results(transport, column, np.array([True, True, False]), colours)
    np.testing.assert_array_equal(visible, np.float32([[1, 2, 3], [0, largest, 0], [0, 0, 0]]))
    np.testing.assert_array_equal(shadowed, np.float32([[4, 5, 6], [0, 0, 1e-45], [0, 0, 0]]))
