"""Curves of USD as polylines, by the rules of UsdGeomBasisCurves (OpenUSD, "Basis Curves")."""

import numpy as np

_STEPS = 4  # straight segments a piece of a spline
_BASES = {  # rows of weights of four points, by powers of t from t^0 to t^3
    "bezier": [[1, 0, 0, 0], [-3, 3, 0, 0], [3, -6, 3, 0], [-1, 3, -3, 1]],
    "bspline": np.array([[1, 4, 1, 0], [-3, 0, 3, 0], [3, -6, 3, 0], [-1, 3, -3, 1]]) / 6,
    "catmullRom": np.array([[0, 2, 0, 0], [-1, 0, 1, 0], [2, -5, 4, -1], [-1, 3, -3, 1]]) / 2,
}


class Spline:
    """Interpolates the `n` points of a curve, or values given at them.

    kind: "linear" or "cubic"; basis: of a cubic curve; wrap: "nonperiodic", "periodic", "pinned".
    samples: points of the polyline, 0 where there are too few points for a piece.
    varying: how many values of the interpolation `varying` the curve has.
    """

    def __init__(self, n: int, kind: str, basis: str, wrap: str) -> None:
        self.is_linear = kind == "linear"
        basis = "bezier" if self.is_linear else basis
        self.n = n
        self.is_closed = wrap == "periodic"
        self.is_pinned = wrap == "pinned" and basis != "bezier"
        self.weights = np.asarray(_BASES[basis], np.float64)
        self.stride = 3 if basis == "bezier" else 1
        if self.is_linear:
            self.pieces = n if self.is_closed else n - 1
        elif self.is_closed:
            self.pieces = n // self.stride
        else:
            self.pieces = max((n + 2 * self.is_pinned - 4) // self.stride + 1, 0)
        self.samples = self.pieces * (1 if self.is_linear else _STEPS) + 1 if self.pieces else 0
        self.varying = self.pieces if self.is_closed else self.pieces + 1

    def along(self, values: np.ndarray) -> np.ndarray:
        """Values (points, k) at the samples, (samples, k)."""
        if not self.pieces:
            return values[:0]
        if self.is_linear:
            return np.concatenate([values, values[:1]]) if self.is_closed else values
        if self.is_pinned:
            before, after = 2 * values[:1] - values[1:2], 2 * values[-1:] - values[-2:-1]
            values = np.concatenate([before, values, after])
        piece, t = self._places()
        four = values[(self.stride * piece[:, None] + np.arange(4)) % len(values)]
        powers = t[:, None] ** np.arange(4)
        return np.asarray(np.einsum("sj,sjk->sk", powers @ self.weights, four))

    def between(self, values: np.ndarray) -> np.ndarray:
        """Values (varying,) at the ends of pieces, linear between them: (samples,)."""
        if not self.pieces or self.is_linear:
            return self.along(values[:, None])[:, 0] if self.pieces else values[:0]
        piece, t = self._places()
        return np.asarray((1 - t) * values[piece] + t * values[(piece + 1) % len(values)])

    def _places(self) -> tuple[np.ndarray, np.ndarray]:
        """The piece of each sample, and where in it, 0 to 1."""
        sample = np.arange(self.samples)
        piece = np.minimum(sample // _STEPS, self.pieces - 1)
        return piece, sample / _STEPS - piece
