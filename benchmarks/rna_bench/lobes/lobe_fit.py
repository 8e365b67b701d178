"""Training of lobes from a package: its transport under random lights is the target."""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import torch
from torch import Tensor
from tqdm import trange

from rna_bench.lobes.directions import directions_of_lights, log_c, random_directions
from rna_bench.lobes.lobe_model import LightLoss, LobeModel
from rna_bench.lobes.view_points import AssetViews

_ROWS, _NEW = 2048, 512  # points of a step, and those of them that no step has had
_KEPT = 200_000  # points
_LIGHTS, _EACH = 2, 4  # of a point; directions of a light
_KAPPA = (0.3, 10.0)  # of the lights: sharper ones are asked of the decoder of transport
_RATE = 5e-3

Rows = dict[str, np.ndarray]


def make_rows(views: AssetViews, count: int, rng: np.random.Generator) -> Rows:
    """`count` random points under random lights: the members of `ViewPoints.rows`, and

    lights (n, K, 3), axes; directions and transport (n, D, 3); weights (n, K, D), of the directions
    in an estimate of the integral under each light. A direction drawn for one light counts for the
    others, too, by the balance heuristic.
    """
    points = views.points(count, rng)
    kappa = _KAPPA[0] * (_KAPPA[1] / _KAPPA[0]) ** rng.random((count, _LIGHTS))
    about = random_directions(count * _LIGHTS, rng).reshape(count, _LIGHTS, 3)
    d = directions_of_lights(about, kappa, _EACH, rng).reshape(count, -1, 3)
    row = np.repeat(np.arange(count), d.shape[1])
    transport = views.transport(points, row, d.reshape(-1, 3).astype(np.float32))
    cosine = about @ d.transpose(0, 2, 1)
    density = np.exp(log_c(kappa)[:, :, None] + kappa[:, :, None] * cosine)
    rows = points.rows() | {"lights": kappa[:, :, None] * about, "directions": d}
    rows["transport"] = transport.reshape(d.shape)
    rows["weights"] = density / density.sum(axis=1, keepdims=True) / _EACH
    return {name: np.ascontiguousarray(array, np.float32) for name, array in rows.items()}


class _Kept:
    """The last points that were made."""

    def __init__(self, rows: Rows) -> None:
        self._rows = {k: np.empty((_KEPT, *v.shape[1:]), np.float32) for k, v in rows.items()}
        self._count = self._next = 0
        self.add(rows)

    def add(self, rows: Rows) -> None:
        """Keep these, in the place of the oldest."""
        more = len(rows["position"])
        start = self._next if self._next + more <= _KEPT else 0
        for name, array in rows.items():
            self._rows[name][start : start + more] = array
        self._next, self._count = start + more, max(self._count, start + more)

    def some(self, count: int, rng: np.random.Generator) -> dict[str, Tensor]:
        """`count` random points."""
        row = rng.integers(self._count, size=count)
        return {k: torch.from_numpy(v.take(row, axis=0)) for k, v in self._rows.items()}


def fit_lobes(model: LobeModel, views: AssetViews, steps: int, seed: int = 0) -> None:
    """Train for a number of steps. Points are made in a second thread, in a fixed order."""
    rng, draw = np.random.default_rng(seed), np.random.default_rng(seed + 1)
    optimizer = torch.optim.Adam(model.decoder.parameters(), lr=_RATE)
    kept = _Kept(make_rows(views, _ROWS, rng))
    with ThreadPoolExecutor(1) as maker:
        coming = maker.submit(make_rows, views, _NEW, rng)
        for step in trange(steps, desc="lobes", unit="step"):
            kept.add(coming.result())
            coming = maker.submit(make_rows, views, _NEW, rng)
            share = 0.5 * (1.0 + math.cos(math.pi * step / steps)) + 1e-3
            for group in optimizer.param_groups:
                group["lr"] = _RATE * share * min(1.0, (step + 1) / 100)
            rows = kept.some(_ROWS, draw)
            optimizer.zero_grad()
            loss = LightLoss.apply(*model(rows), rows)  # type: ignore[no-untyped-call]
            loss.backward()
            optimizer.step()
