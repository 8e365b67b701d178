"""Points of a material's surfaces in the UV map that a colour is read from."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from rna_materials.material_uses import Use
from rna_materials.uv_render import ColourOfUv

_POINTS = 16384


class NotOfUv(Exception):
    """Why a colour is no function of one set of UV coordinates."""


@dataclass
class UvPoints:
    """Points of all surfaces of a material, evenly spread: the UV map that a colour is read from.

    uvs: (n, 2) of the points. used: (3t, 2) of all corners. positions: (3t, 3) of them.
    """

    layer: str
    uvs: np.ndarray
    used: np.ndarray
    positions: np.ndarray

    @classmethod
    def of(cls, uses: list[Use], colour: ColourOfUv) -> UvPoints:
        """Also passes the colour the data that its quads need. Raises NotOfUv."""
        if colour.depends.problems:
            raise NotOfUv(colour.depends.problems[0])
        attributes = {n for use in uses for n in colour.depends.attributes if n in use.layers and n}
        names = sorted(colour.depends.layers | attributes)
        maps = [joined(uses, name) for name in names] or [joined(uses, None)]
        for name, other in zip(names[1:], maps[1:], strict=False):
            if not np.allclose(other, maps[0], atol=1e-6):
                shown = [repr(each or "the map of renders") for each in (names[0], name)]
                raise NotOfUv(f"the UV maps {shown[0]} and {shown[1]} at once")
        colour.layers = set(names)
        colour.constants = {}
        for name in colour.depends.attributes.keys() - attributes:
            value = _constant(uses, name, sorted(colour.depends.attributes[name]))
            if value is not None:
                colour.constants[name] = value
        positions = np.concatenate([use.positions for use in uses])
        return cls._sampled(names[0] if names else "", maps[0], positions)

    def on(self, triangles: np.ndarray) -> UvPoints:
        """Points of some of the triangles, (t,) bool."""
        rows = np.repeat(triangles, 3)
        return self._sampled(self.layer, self.used[rows], self.positions[rows])

    @classmethod
    def _sampled(cls, layer: str, used: np.ndarray, positions: np.ndarray) -> UvPoints:
        corners = positions.reshape(-1, 3, 3).astype(np.float64)
        a, b, c = corners.swapaxes(0, 1)
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        area = np.where(np.isfinite(area), area, 0.0)
        total = area.sum()
        rng = np.random.default_rng(0)
        weight = area / total if total > 0.0 else np.full(len(area), 1.0 / len(area))
        triangle = rng.choice(len(area), _POINTS, p=weight)
        root, v = np.sqrt(rng.random(_POINTS)), rng.random(_POINTS)
        weights = np.stack([1.0 - root, root * (1.0 - v), root * v], axis=1)
        uvs = np.einsum("nk,nkc->nc", weights, used.reshape(-1, 3, 2)[triangle])
        return cls(layer, uvs, used, positions)


def joined(uses: list[Use], layer: str | None) -> np.ndarray:
    """(3t, 2): a UV map of all uses; 0 where a mesh lacks it, as Cycles has it."""
    zeros = np.zeros((1, 2), np.float32)
    return np.concatenate(
        [
            use.layers[layer] if layer in use.layers else np.repeat(zeros, len(use.positions), 0)
            for use in uses
        ]
    )


def _constant(uses: list[Use], name: str, components: list[int]) -> np.ndarray | None:
    """(4,) the value of an attribute that is the same all over; None if no mesh has it."""
    missing = np.zeros((1, 4), np.float32)
    values = np.concatenate([use.attributes.get(name, missing) for use in uses])
    if not (values[:, components] == values[0, components]).all():
        raise NotOfUv(f"the attribute {name!r}" if name else "the colour attribute")
    return np.array(values[0]) if any(name in use.attributes for use in uses) else None
