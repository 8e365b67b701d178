"""The normals of a height over texture coordinates: of Bump nodes, and of displacement as bump."""

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import bpy
import numpy as np
from rna_materials.material_uses import Use
from rna_materials.node_sources import Source, lifted, origin, own_value, sources
from rna_materials.uv_charts import Chart
from rna_materials.uv_dependence import IDENTITY, Dependence, dependence
from rna_materials.uv_points import NotOfUv, UvPoints, joined
from rna_materials.uv_render import ColourOfUv, surface_output

_STEP = 0.5  # texels to either side, over which a slope is measured
_SHOWN, _ZERO = 0.25, 0.5  # a height as a colour: emission is not negative
_LARGEST, _LARGEST_PATTERN = 2048, 1024  # texels a side, of images and without them
_UNEVEN = 0.35  # of a slope, by which a map is off in the mean where the size of the UVs varies


class Bump(NamedTuple):
    """height: where it comes from. distance: metres for 1 of it. strength: as a Bump node's.

    scales: whether distances grow with the object. upon: nodes of the normal that it bends; none of
    the surface's own.
    """

    height: Source
    distance: float
    strength: float
    scales: bool = False
    upon: tuple[Source, ...] = ()


def bump_of(material: bpy.types.Material, normal: Source | None) -> Bump | str | None:
    """The relief by a height of a material; None without, else why it is none.

    normal: where its shaders' normal comes from.
    """
    if normal is not None:
        return _bump(normal, "Strength", "Distance") if normal[0].type == "BUMP" else None
    output = surface_output(material)
    if output is None or material.displacement_method != "BUMP":
        return None
    source = origin(output.inputs["Displacement"], ())
    if source is None or source[0].type != "DISPLACEMENT":
        return None
    bump = _bump(source, None, "Scale")
    return bump._replace(scales=source[0].space == "OBJECT") if isinstance(bump, Bump) else bump


def _bump(source: Source, strength: str | None, distance: str) -> Bump | str | None:
    """Bump of a node with a height input; strength, distance: names of its inputs."""
    node, _, inside = source
    height = origin(node.inputs["Height"], inside)
    if height is None:
        return None
    upon = tuple(sources(node.inputs["Normal"], inside))
    if upon and strength is None:
        return f"the node {node.bl_label!r} upon another normal"
    values = [own_value(node.inputs[name], inside) for name in (strength, distance) if name]
    if any(value is None for value in values):
        return f"the node {node.bl_label!r} whose strength or distance varies"
    numbers = [value[0] for value in values if value is not None]
    distance_m = -numbers[-1] if strength and node.invert else numbers[-1]
    return Bump(height, distance_m, max(numbers[0], 0.0) if strength else 1.0, upon=upon)


class ReliefOfUv(ColourOfUv):  # type: ignore[misc]
    """(n + 1) / 2 of the normals of a bump, in the tangent frame of UVs, as Cycles bends them.

    upon: the normals that it bends; None for the surface's own. `measure` is called before it is
    rendered.

    Attributes:
        largest: texels a side, at most; each is rendered four times.
    """

    def __init__(
        self, material: bpy.types.Material, bump: Bump, folder: Path, upon: ColourOfUv | None
    ) -> None:
        tree = material.node_tree
        node = tree.nodes.new("ShaderNodeMath")  # takes a colour as a height, as Bump does
        node.operation = "MULTIPLY_ADD"
        tree.links.new(lifted(tree, bump.height), node.inputs[0])
        node.inputs[1].default_value, node.inputs[2].default_value = _SHOWN, _ZERO
        super().__init__(material, node.outputs[0], folder)
        self._bump, self._upon, self._metres = bump, upon, np.ones(2)
        self.largest = _LARGEST if self.depends.images else _LARGEST_PATTERN
        side = Chart("", IDENTITY).size(self.depends, largest=self.largest)
        self._steps = _STEP / np.array(side)
        self.depends: Dependence = dependence((*sources(node.inputs[0]), *bump.upon))

    def measure(self, uses: list[Use], layer: str) -> None:
        """Take the size of the UVs on the surfaces that show it. Raises NotOfUv where it varies."""
        self._metres = _metres_a_uv(uses, layer, by_object=self._bump.scales)
        if self._upon is not None:
            UvPoints.of(uses, self._upon)
        if isinstance(self._upon, ReliefOfUv):
            self._upon.measure(uses, layer)

    def texture(self, chart: Chart, size: tuple[int, int]) -> np.ndarray:
        """As `ColourOfUv`."""

        def heights(shift: np.ndarray) -> np.ndarray:
            matrix = chart.matrix.copy()
            matrix[:, 2] -= matrix[:, :2] @ shift
            return np.asarray(ColourOfUv.texture(self, Chart(chart.layer, matrix), size))

        return self._normals(
            heights, None if self._upon is None else self._upon.texture(chart, size)
        )

    def values(self, uvs: np.ndarray) -> np.ndarray:
        """As `ColourOfUv`."""
        upon = None if self._upon is None else self._upon.values(uvs)
        return self._normals(lambda shift: ColourOfUv.values(self, uvs + shift), upon)

    def _normals(
        self, heights: Callable[[np.ndarray], np.ndarray], upon: np.ndarray | None
    ) -> np.ndarray:
        """heights: colours where all UVs are shifted. upon: (n + 1) / 2 of the normals bent."""
        slopes = []
        for shift, metres in zip(np.diag(self._steps), self._metres, strict=True):
            rise = (heights(shift) - heights(-shift))[..., 0] / _SHOWN
            slopes.append(self._bump.distance * rise / (2.0 * shift.sum() * metres))
        flat = np.array([0.0, 0.0, 1.0]) if upon is None else _unit(2.0 * upon - 1.0)
        x, y, z = np.moveaxis(flat, -1, 0)
        # The gradient of the surface, (su, sv, 0) for z = 1, lies in the plane of the normal.
        gradient = [slopes[0] * z, slopes[1] * z, -slopes[0] * x - slopes[1] * y]
        bent = _unit(z[..., None] * flat - np.stack(gradient, axis=-1))
        share = self._bump.strength
        return 0.5 + 0.5 * _unit(share * bent + (1.0 - share) * flat)


def _metres_a_uv(uses: list[Use], layer: str, by_object: bool) -> np.ndarray:
    """(2,) of a unit of u and of v, medians over the area. Raises NotOfUv where they vary much.

    by_object: whether in units of the object instead.
    """
    scaled = [use.positions if by_object else use.scale * use.positions for use in uses]
    positions = np.concatenate(scaled).astype(np.float64)
    corners, uvs = positions.reshape(-1, 3, 3), joined(uses, layer).reshape(-1, 3, 2)
    sides, ways = corners[:, 1:] - corners[:, :1], uvs[:, 1:] - uvs[:, :1]
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
    regular = (np.abs(np.linalg.det(ways)) > 1e-12) & (area > 0.0)
    if area[regular].sum() <= (1.0 - _UNEVEN) * area.sum():
        raise NotOfUv("a height over UV coordinates without an area")
    lengths = np.linalg.norm(np.linalg.solve(ways[regular], sides[regular]), axis=2)  # (t, 2)
    area = area[regular]
    result = np.array([_median(each, area) for each in lengths.T])
    if np.average(np.abs(lengths / result - 1.0), axis=0, weights=area).max() > _UNEVEN:
        raise NotOfUv("a height over UV coordinates of uneven scale")
    return result


def _median(values: np.ndarray, weights: np.ndarray) -> float:
    order = np.argsort(values)
    total = np.cumsum(weights[order])
    return float(values[order[np.searchsorted(total, 0.5 * total[-1])]])


def _unit(vectors: np.ndarray) -> np.ndarray:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))
