"""A decoder: the layers of the one chain that the format allows (spec/RNA.md, 6.2)."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder.decoder_form import TRANSPORT

Rows = NDArray[np.floating[Any]]


@dataclass(frozen=True, eq=False)
class ProfileLayer:
    """A fully connected layer: in float32 `y = x weight + bias`.

    In int8 `y = (q weight + bias) unit` with q = clip(round(x / step), 0, 255), rounding halves to
    even.

    Attributes:
        weight: (inputs, outputs) float32 or int8.
        bias: (outputs,) float32 or int32.
        step: quantisation step of the inputs in int8, else 0.
        scale: (outputs,) float32 in int8, what a step of the weights means; else None.
        relu: whether a ReLU follows.
    """

    weight: NDArray[Any]
    bias: NDArray[Any]
    step: float
    scale: NDArray[np.float32] | None
    relu: bool

    @property
    def unit(self) -> NDArray[np.float32] | None:
        """(outputs,) float32 in int8, else None."""
        return None if self.scale is None else np.float32(self.step) * self.scale

    def run(self, x: Rows) -> Rows:
        """(n, outputs) for (n, inputs), in the dtype of x; sums of integers are exact."""
        y: Rows
        if self.unit is None:
            y = _product(x, self.weight) + self.bias
        else:
            q = np.clip(np.rint(x / x.dtype.type(self.step)), 0, 255).astype(np.float64)
            sums = _product(q, self.weight.astype(np.float64)) + self.bias
            y = sums.astype(x.dtype) * self.unit
        return np.maximum(y, 0) if self.relu else y


@dataclass(frozen=True, eq=False)
class ProfileDecoder:
    """result = (exp(clip(layers(queries), 0, top)) - 1) times unit or matrix.

    Attributes:
        low, high: limits that queries are clipped to.
        gain, offset: (K,) float32, applied to clipped queries in int8: x gain + offset; else None.
        layers: from K inputs to the outputs of the last layer.
        top: upper limit of the logarithm.
        unit: factor of the result; 1 if there is a matrix.
        matrix: (n, outputs) float32, or None.
        output: name of the result, by the decoder's form.
    """

    low: float
    high: float
    gain: NDArray[np.float32] | None
    offset: NDArray[np.float32] | None
    layers: tuple[ProfileLayer, ...]
    top: float
    unit: float
    matrix: NDArray[np.float32] | None
    output: str = TRANSPORT.name

    @property
    def is_int8(self) -> bool:
        """Whether the layers are in int8."""
        return self.layers[0].scale is not None

    @property
    def columns(self) -> int:
        """K, the number of columns of the queries."""
        return len(self.layers[0].weight)

    @property
    def outputs(self) -> int:
        """Number of columns of the result."""
        return len(self.layers[-1].bias) if self.matrix is None else len(self.matrix.T)

    @property
    def width(self) -> int:
        """Number of outputs of the widest layer."""
        return max(len(layer.bias) for layer in self.layers)

    @property
    def values(self) -> int:
        """Outputs of all layers together, the result included: values of a query."""
        return sum(len(layer.bias) for layer in self.layers) + self.outputs

    @property
    def multiply_adds(self) -> int:
        """Multiply-adds of a query, in all layers and the matrix."""
        products = [layer.weight for layer in self.layers]
        return sum(weight.size for weight in products) + (
            0 if self.matrix is None else self.matrix.size
        )

    def run(self, queries: Rows) -> Rows:
        """(n, outputs) for (n, K) float32 or float64, in that dtype: the formula, in numpy.

        Examples:
            >>> with Package.open("toy.rna") as package:
            ...     decoder = decoder_from_bytes(package.decoder("small"), "small")
            >>> decoder.run(np.zeros((2, decoder.columns), np.float32)).shape
            (2, 6)
        """
        x = np.clip(queries, self.low, self.high)
        if self.gain is not None and self.offset is not None:
            x = x * self.gain + self.offset
        for layer in self.layers:
            x = layer.run(x)
        x = np.exp(np.clip(x, 0, self.top)) - 1
        if self.matrix is None:
            return x * queries.dtype.type(self.unit)
        return _product(x, self.matrix)


def _product(x: Rows, weight: NDArray[Any]) -> Rows:
    """x weight without BLAS, whose threads' locks a process forked beside them never gets."""
    result: Rows = np.einsum("nk,ko->no", x, weight)
    return result
