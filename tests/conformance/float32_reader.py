"""A reader in float32 throughout, as a shader would be; each safe formula of 6.3 can be left out.

It reads planes and decoder by the minimal host and computes the rest itself.
"""

from __future__ import annotations

import json
import zipfile
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

F = np.float32
Constants = dict[str, np.ndarray]


@dataclass(frozen=True)
class Formulas:
    """Which of the formulas of "In float32" are used; and wrong ones, to see the kit notice.

    pair_sums_in_16_bits: sums of two products of int8 layers saturate, as by vpmaddubsw.
    """

    half_vector: bool = True
    gap: bool = True
    cosines: bool = True
    cos_phi: bool = True
    sin_phi: bool = True
    pair_sums_in_16_bits: bool = False
    sign_of_sin_phi: float = 1.0
    rows_upside_down: bool = False
    h_clamped: bool = True
    subnormal_texels: bool = True
    rounded_bounds: bool = True


def evaluate(
    minimal: ModuleType,
    formulas: Formulas,
    package: Path,
    tier_name: str,
    number: int,
    queries: np.ndarray,
    output: str = "transport",
) -> np.ndarray:
    """(n, 6) float32 for (n, 16) float32 queries; minimal: the module of the minimal host.

    For emission (n, 3), for (n, 10) queries and three columns behind them that no block reads.
    """
    with zipfile.ZipFile(package) as archive:
        manifest = json.loads(archive.read("manifest.json"))
        tier = next(tier for tier in manifest["tiers"] if tier["name"] == tier_name)
        part, tier_part = manifest["parts"][number], tier["parts"][number]
        decoders = minimal.decoders_of(tier_part, output)
        planes = minimal.read_planes(archive.read(tier_part["planes"])).astype(F)
        graphs = [minimal.read_decoder(archive.read(of["decoder"])) for of in decoders.values()]
    uses_base_color = output == "transport" and tier_part.get("usesBaseColor", False)
    queries, base_color = queries[:, : 16 if uses_base_color else 13], queries[:, 13:]
    if not formulas.subnormal_texels:
        planes[np.abs(planes) < F(2.0**-14)] = 0
    directions = queries[:, 3:6], queries[:, 7:10], queries[:, 10:13]
    rows = np.isfinite(queries).all(axis=1) & np.all([d.any(axis=1) for d in directions], axis=0)
    dtype = F if formulas.rounded_bounds else np.float64
    low, high = (np.array(part["bounds"][corner], dtype) for corner in ("min", "max"))
    p = np.clip((queries[rows, :3] - low) / (high - low), 0, 1).astype(F)
    axis, wo, wi = (unit(d[rows]) for d in directions)
    h = queries[rows, 6]
    blocks = _blocks(formulas, planes, p, np.clip(h, -1, 1) if formulas.h_clamped else h, axis)
    made = blocks(wo, wi)
    colours = []
    for (name, record), (nodes, constants) in zip(decoders.items(), graphs, strict=True):
        inputs = np.hstack([made[block] for block in record["inputs"]])
        assert inputs.dtype == F
        values = {k: v.astype(F) for k, v in constants.items()}
        colour = _run(formulas, nodes, values, inputs)[name]
        if uses_base_color:
            colour, factor = np.hsplit(colour, 2)
            colour = np.maximum(
                colour + np.tile(base_color[rows], colour.shape[1] // 3) * factor, 0
            )
        colours.append(colour)
    result = np.zeros((len(queries), 3 if output == "emission" else 6), F)
    result[rows] = np.hstack(colours)
    return result


def _blocks(formulas: Formulas, planes: np.ndarray, p: np.ndarray, h: np.ndarray, n: np.ndarray):
    f = _triplane(planes[:, ::-1] if formulas.rows_upside_down else planes, p)

    def blocks(wo: np.ndarray, wi: np.ndarray) -> dict[str, np.ndarray]:
        bent = n + F(0.1) * np.pad(f, ((0, 0), (0, 3)))[:, :3]
        q = np.where(length(bent) < F(1e-6), n, unit(bent))
        m = _half_vector(formulas, wo, wi)
        opposite = ~m.any(axis=1, keepdims=True)
        gap = partial(_gap, formulas, m, opposite)
        s_o, s_i, along = dot(n, wo), dot(n, wi), dot(n, wi) + dot(n, wo)
        across = np.where(opposite, F(1), dot(cross(n, m), cross(n, m)))
        c_o, cos_phi, sin_phi = _azimuth(formulas, n, wo, wi)
        cone = np.log2(along * along + F(1e-3)) / F(6)
        return {
            "features": f,
            "position": F(2) * p - F(1),
            "normal": n,
            "tangent": n,
            "h": h[:, None],
            "wo": wo,
            "wi": wi,
            "half_vector": np.hstack([dot(n, m), gap(n), s_i, s_o, dot(wi, m)]),
            "highlight": np.log2(across + F(1e-8)) / F(12),
            "learned_normal": np.hstack([dot(q, m), gap(q)]),
            "fiber_angles": np.hstack([s_i, s_o, along, cone, cos_phi, sin_phi]),
            "fiber_lobes": _lobes(h[:, None], s_o, c_o, cos_phi, sin_phi),
        }

    return blocks


def _triplane(planes: np.ndarray, p: np.ndarray) -> np.ndarray:
    size, total = planes.shape[1], F(0)
    for plane, (u, v) in zip(planes, ((0, 1), (1, 2), (2, 0)), strict=True):
        s, t = (np.clip(p[:, k] * F(size) - F(0.5), 0, size - 1) for k in (u, v))
        i, j = s.astype(int), t.astype(int)
        a, b = (s - i.astype(F))[:, None], (t - j.astype(F))[:, None]
        i1, j1 = np.minimum(i + 1, size - 1), np.minimum(j + 1, size - 1)
        lower = (F(1) - a) * plane[j, i] + a * plane[j, i1]
        upper = (F(1) - a) * plane[j1, i] + a * plane[j1, i1]
        total = total + (F(1) - b) * lower + b * upper
    return total


def _half_vector(formulas: Formulas, wo: np.ndarray, wi: np.ndarray) -> np.ndarray:
    s, e = wi + wo, wi - wo
    if formulas.half_vector:
        nearly = dot(s, s) < dot(e, e)
        s = np.where(nearly, s - e * (dot(s, e) / np.where(nearly, dot(e, e), F(1))), s)
    return np.where(length(s) < F(1e-6), F(0), unit(s))


def _gap(formulas: Formulas, m: np.ndarray, opposite: np.ndarray, n: np.ndarray) -> np.ndarray:
    gap = dot(n - m, n - m) / F(2) if formulas.gap else F(1) - np.minimum(dot(n, m), F(1))
    return np.log2(np.where(opposite, F(1), gap) + F(1e-4)) / F(6)


def _azimuth(formulas: Formulas, t: np.ndarray, wo: np.ndarray, wi: np.ndarray):
    s_o, s_i, turned_o, turned_i = dot(t, wo), dot(t, wi), cross(t, wo), cross(t, wi)
    c_o, c_i = length(turned_o), length(turned_i)
    if not formulas.cosines:
        c_o, c_i = (np.sqrt(np.maximum(F(0), F(1) - s * s)) for s in (s_o, s_i))
    d = c_o * c_i
    along = d < F(1e-6)
    cosine = dot(turned_o, turned_i) if formulas.cos_phi else dot(wo, wi) - s_o * s_i
    around = cross(turned_o, turned_i) if formulas.sin_phi else cross(wo, wi)
    sine = F(formulas.sign_of_sin_phi) * dot(t, around)
    d = np.where(along, F(1), d)
    cos_phi, sin_phi = np.clip(cosine / d, -1, 1), np.clip(sine / d, -1, 1)
    return c_o, np.where(along, F(1), cos_phi), np.where(along, F(0), sin_phi)


def _lobes(
    h: np.ndarray, s_o: np.ndarray, c_o: np.ndarray, cos_phi: np.ndarray, sin_phi: np.ndarray
) -> np.ndarray:
    sin_t = h * c_o / np.sqrt(F(1.55**2) - s_o * s_o)
    turn, segment = _doubled(h), _doubled(sin_t)
    lobes = []
    for _ in range(3):
        lobes.append(cos_phi * turn[0] + sin_phi * turn[1])
        turn = (  # by -2 g_t - pi
            -turn[0] * segment[0] - turn[1] * segment[1],
            turn[0] * segment[1] - turn[1] * segment[0],
        )
    return np.hstack(lobes)


def _doubled(sine: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    cosine = np.sqrt(np.maximum(F(0), (F(1) - sine) * (F(1) + sine)))
    return F(1) - F(2) * sine * sine, F(2) * sine * cosine


def _run(formulas: Formulas, nodes: list[Any], values: Constants, queries: np.ndarray):
    """The graph's values in float32, layer by layer; int8 layers in integers."""
    values["queries"] = queries
    for operator, inputs, output in nodes:
        operands = [values[name] for name in inputs]
        if operator == "DequantizeLinear":  # integers stay so; their scales go with them
            values[output] = operands[0]
            values[output + " scale"] = operands[1]
            continue
        if operator == "Gemm" and inputs[0] + " scale" in values:
            sums = _integer_sums(formulas, *operands)
            scale = values[inputs[0] + " scale"] * values[inputs[1] + " scale"]
            values[output] = sums.astype(F) * scale
            continue
        values[output] = _OPERATORS[operator](*operands)
    return values


def _integer_sums(
    formulas: Formulas, q: np.ndarray, weight: np.ndarray, bias: np.ndarray
) -> np.ndarray:
    q, weight, bias = (values.astype(np.int64) for values in (q, weight, bias))
    if not formulas.pair_sums_in_16_bits:
        return q @ weight + bias
    odd = q.shape[1] % 2
    q, weight = np.pad(q, ((0, 0), (0, odd))), np.pad(weight, ((0, odd), (0, 0)))
    pairs = q[:, 0::2, None] * weight[0::2] + q[:, 1::2, None] * weight[1::2]
    return np.clip(pairs, -(2**15), 2**15 - 1).sum(axis=1) + bias


_OPERATORS = {
    "Clip": np.clip,
    "Gemm": lambda x, weight, bias: x @ weight + bias,
    "MatMul": np.matmul,
    "Relu": lambda x: np.maximum(x, F(0)),
    "Exp": np.exp,
    "Add": np.add,
    "Sub": np.subtract,
    "Mul": np.multiply,
    "QuantizeLinear": lambda x, scale, zero: np.clip(np.rint(x / scale) + zero, 0, 255),
}


def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Term by term, each rounded: numpy's sums could be wider."""
    return (a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1] + a[:, 2] * b[:, 2])[:, None]


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    (ax, ay, az), (bx, by, bz) = a.T, b.T
    return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], axis=1)


def length(v: np.ndarray) -> np.ndarray:
    return np.sqrt(dot(v, v))


def unit(v: np.ndarray) -> np.ndarray:
    """Two steps: squares of the largest and the smallest float32 leave its range."""
    largest = np.abs(v).max(axis=1, keepdims=True)
    v = v / np.where(largest > 0, largest, F(1))
    size = length(v)
    return v / np.where(size > 0, size, F(1))
