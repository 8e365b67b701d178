"""Holes, thin glass and normal maps of all materials, as textures of a package.

A package's texture is a function of one set of texture coordinates, and repeats. Whether one is
what the nodes say is measured: Cycles shows their colour at points of the surfaces, and the texture
is compared with it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from rna_geometry.rendered_geometry import as_rendered
from rna_materials import normal_maps
from rna_materials.material_uses import Use, Wanted, shown_materials, uses_of
from rna_materials.texture_fit import (
    Fit,
    Texture,
    best_fit,
    hole_error,
    hole_texture,
    is_binary,
    looked_up,
)
from rna_materials.transparency import transmittance_of
from rna_materials.uv_charts import Chart, charts
from rna_materials.uv_render import ColourOfUv

_POINTS = 16384  # a square number
_NOTED, _WRONG = 0.01, 0.1  # mean errors of holes: told, and of no use
_WRONG_NORMAL = 0.03  # mean error of a normal's x and y
_SHARP = 0.025  # error of a sharp outline where Cycles has one as wide as a texel


class _NotOfUv(Exception):
    """Why a colour is no function of one set of UV coordinates."""


@dataclass
class _Surface:
    """One material: the colours of its nodes.

    holes: what is compared with the cutoff; shown: the transmittance that Cycles shows. no_normal:
    why there is no normal map. uses: triangles that show it; on_hair: whether strands do.
    """

    material: bpy.types.Material
    on_hair: bool
    holes: ColourOfUv | None = None
    shown: ColourOfUv | None = None
    cutoff: float | None = None
    ior: tuple[float, float] | None = None
    normal: ColourOfUv | None = None
    no_normal: str | None = None
    uses: list[Use] = field(default_factory=list)

    def colours(self) -> list[ColourOfUv]:
        return [c for c in (self.holes, self.shown, self.normal) if c is not None]


@dataclass
class _Found:
    """Textures of one material, and notes about it.

    captured: whether light that it lets through has no texture. learnt: whether its relief has
    none.
    """

    holes: Fit | None = None
    normals: Fit | None = None
    captured: bool = False
    learnt: bool = False
    notes: list[str] = field(default_factory=list)

    def chart(self) -> Chart | None:
        """That of its textures, unless they are constant."""
        if self.normals is not None:
            return self.normals.chart
        is_constant = self.holes is None or self.holes.texture.shape[:2] == (1, 1)
        return None if is_constant or self.holes is None else self.holes.chart


def export_textures(path: str, side: int) -> dict[str, Any]:
    """Write an .npz of all textures, `holes0`, `holes1`, ... and `normals0`, `normals1`, ...

    Holes are (h, w, 1 or 3), normals (h, w, 2) uint8: x and y are (value - 127) / 127; row 0 at
    the top. side: texels along a side of normal maps, at most; 0 for none.

    Returns `holes`, records of material (its full name), cutoff and ior; `normals`, names of
    materials; `charts`, layer and matrix by material (see `uv_charts.Chart`); `captured`, whether
    light through some has no texture; `learnt`, whether some relief has none; `notes` for the user.
    """
    holes: list[dict[str, Any]] = []
    normals: list[str] = []
    kept, notes, captured, learnt = {}, [], False, side == 0
    textures: dict[str, Any] = {}
    copies = _Copies()
    try:
        surfaces = list(_surfaces(copies, Path(path).parent, side > 0))
        _find_uses(surfaces)
        for surface in surfaces:
            name, found = surface.material.name_full, _textures_of(surface, side)
            captured, learnt = captured or found.captured, learnt or found.learnt
            notes += [f"material {surface.material.name!r} {note}" for note in found.notes]
            if found.holes is not None:
                textures[f"holes{len(holes)}"] = found.holes.texture
                holes.append({"material": name, "cutoff": found.holes.cutoff, "ior": surface.ior})
            if found.normals is not None:
                textures[f"normals{len(normals)}"] = found.normals.texture
                normals.append(name)
            if (chart := found.chart()) is not None:
                kept[name] = {"layer": chart.layer, "matrix": chart.matrix.tolist()}
    finally:
        copies.remove()
    np.savez(path, **textures)
    found_all = {"holes": holes, "normals": normals, "charts": kept}
    return {**found_all, "captured": captured, "learnt": learnt, "notes": notes}


class _Copies:
    """Copies of materials, whose nodes may be changed."""

    def __init__(self) -> None:
        self._groups = set(bpy.data.node_groups)
        self._made: list[bpy.types.Material] = []

    def of(self, material: bpy.types.Material) -> bpy.types.Material:
        copy = material.copy()
        self._made.append(copy)
        return copy

    def remove(self) -> None:
        """Remove them, and the copies of groups in them."""
        for material in self._made:
            bpy.data.materials.remove(material)
        for group in set(bpy.data.node_groups) - self._groups:
            bpy.data.node_groups.remove(group)


def _surfaces(copies: _Copies, folder: Path, with_normals: bool) -> Iterable[_Surface]:
    """The shown materials that have holes or a normal map."""
    on_surfaces, on_hair = as_rendered(shown_materials)
    for material in list(bpy.data.materials):
        if material.name_full not in on_surfaces | on_hair or material.node_tree is None:
            continue
        surface = _Surface(material, material.name_full in on_hair)
        copy = copies.of(material)
        found = transmittance_of(copy)
        if found is not None:
            surface.cutoff, surface.ior = found.cutoff, found.ior
            surface.holes = surface.shown = ColourOfUv(copy, found.colour, folder)
            if found.cutoff is not None:
                copy = copies.of(material)
                shown = transmittance_of(copy, thresholds=False)
                assert shown is not None  # as before
                surface.shown = ColourOfUv(copy, shown.colour, folder)
        if with_normals and material.name_full in on_surfaces:
            copy = copies.of(material)
            source = normal_maps.normal_source(copy)
            if source is not None and (problem := normal_maps.problem_of(source)):
                surface.no_normal = problem
            elif source is not None:
                colour = normal_maps.as_colour(copy, source)
                surface.normal = ColourOfUv(copy, colour, folder)
        if surface.colours() or surface.no_normal:
            yield surface


def _find_uses(surfaces: list[_Surface]) -> None:
    wanted = {}
    for surface in surfaces:
        depends = [colour.depends for colour in surface.colours()]
        wanted[surface.material.name_full] = Wanted(
            {name for each in depends for name in each.layers},
            {name for each in depends for name in each.attributes},
        )
    uses = as_rendered(lambda: uses_of(wanted))
    for surface in surfaces:
        surface.uses = uses[surface.material.name_full]


def _textures_of(surface: _Surface, side: int) -> _Found:
    found = _Found()
    if surface.holes is not None:
        try:
            found.holes = _holes_of(surface, found)
        except _NotOfUv as problem:
            found.captured = True
            found.notes.append(
                f"is transparent by {problem}, which is no function of its UV coordinates: what is "
                "seen through it is part of the captured light"
            )
    reason = surface.no_normal
    if surface.normal is not None and surface.uses:
        try:
            _add_normals(surface, found, side)
        except _NotOfUv as problem:
            reason = f"{problem}, which is no function of its UV coordinates"
    if reason:
        found.learnt = True
        found.notes.append(f"has relief by {reason}: it is learnt, not mapped")
    return found


@dataclass
class _Points:
    """Points of all surfaces of a material, evenly spread: the UV map that a colour is read from.

    uvs: (n, 2) of the points. used: (3t, 2) of all corners.
    """

    layer: str
    uvs: np.ndarray
    used: np.ndarray

    @classmethod
    def of(cls, uses: list[Use], colour: ColourOfUv) -> _Points:
        """Also tells the colour what its quads need. Raises _NotOfUv."""
        if colour.depends.problems:
            raise _NotOfUv(colour.depends.problems[0])
        attributes = {n for use in uses for n in colour.depends.attributes if n in use.layers and n}
        names = sorted(colour.depends.layers | attributes)
        maps = [_joined(uses, name) for name in names] or [_joined(uses, None)]
        for name, other in zip(names[1:], maps[1:], strict=False):
            if not np.allclose(other, maps[0], atol=1e-6):
                shown = [repr(each or "that of renders") for each in (names[0], name)]
                raise _NotOfUv(f"the UV maps {shown[0]} and {shown[1]} at once")
        colour.layers = set(names)
        colour.constants = {}
        for name in colour.depends.attributes.keys() - attributes:
            value = _constant(uses, name, sorted(colour.depends.attributes[name]))
            if value is not None:
                colour.constants[name] = value
        return cls(names[0] if names else "", _sampled(uses, maps[0]), maps[0])


def _joined(uses: list[Use], layer: str | None) -> np.ndarray:
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
        raise _NotOfUv(f"the attribute {name!r}" if name else "the colour attribute")
    return np.array(values[0]) if any(name in use.attributes for use in uses) else None


def _sampled(uses: list[Use], uvs: np.ndarray) -> np.ndarray:
    """(n, 2): UVs of points of the triangles, uniform by area."""
    corners = np.concatenate([use.positions for use in uses]).reshape(-1, 3, 3).astype(np.float64)
    a, b, c = corners.swapaxes(0, 1)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    area = np.where(np.isfinite(area), area, 0.0)
    total = area.sum()
    rng = np.random.default_rng(0)
    weight = area / total if total > 0.0 else np.full(len(area), 1.0 / len(area))
    triangle = rng.choice(len(area), _POINTS, p=weight)
    root, v = np.sqrt(rng.random(_POINTS)), rng.random(_POINTS)
    weights = np.stack([1.0 - root, root * (1.0 - v), root * v], axis=1)
    return np.asarray(np.einsum("nk,nkc->nc", weights, uvs.reshape(-1, 3, 2)[triangle]))


def _holes_of(surface: _Surface, found: _Found) -> Fit | None:
    """The texture of a material's holes, None if it has none; notes go to `found`.

    Raises _NotOfUv.
    """
    holes, shown = surface.holes, surface.shown
    assert holes is not None and shown is not None  # the caller has asked
    if not surface.uses:
        _check_hair(shown)
        return None
    points = _Points.of(surface.uses, holes)
    if shown is not holes:
        _Points.of(surface.uses, shown)
    truth = shown.values(points.uvs)
    tried = list(charts(holes.depends, points.layer, points.used))
    fits = [_fit_holes(surface, surface.cutoff, tried, points, truth)]
    if surface.cutoff is not None and fits[0].error > _NOTED:
        fits.append(_fit_holes(surface, None, tried, points, truth))
    fit = min(fits, key=lambda each: each.error)
    if fit.error > _WRONG:
        raise _NotOfUv("nodes whose values do not repeat")
    least = 0.0 if fit.cutoff is None else 255.0 * fit.cutoff
    if fit.texture.max() <= least:
        return None
    if surface.on_hair:
        found.captured = True
        found.notes.append(
            "lets light through on strands: what is seen through them is part of the captured light"
        )
    if fit.error > _NOTED:
        found.notes.append(
            f"is transparent by a pattern that no repeated texture of {fit.texture.shape[1]} x "
            f"{fit.texture.shape[0]} texels holds: {fit.error:.1%} of its area differ"
        )
    if (fit.texture == fit.texture[:1, :1]).all():
        fit.texture = np.ascontiguousarray(fit.texture[:1, :1])
    return fit


def _check_hair(shown: ColourOfUv) -> None:
    """Raises _NotOfUv for strands that let light through."""
    if shown.depends.problems:
        raise _NotOfUv(shown.depends.problems[0])
    if shown.depends.layers or shown.depends.attributes:
        raise _NotOfUv("an attribute of strands")
    if shown.values(np.zeros((16, 2))).max() > 0.5 / 255.0:
        raise _NotOfUv("its strands")


def _fit_holes(
    surface: _Surface,
    cutoff: float | None,
    tried: list[Chart],
    points: _Points,
    truth: np.ndarray,
) -> Fit:
    """The best texture of a material's holes; with a cutoff, of what is compared with it."""
    shown = surface.shown
    holes = shown if cutoff is None else surface.holes
    assert holes is not None and shown is not None  # the caller has asked

    def make(chart: Chart, size: tuple[int, int]) -> Texture:
        value = holes.texture(chart, size)
        made = hole_texture(value, value if shown is holes else shown.texture(chart, size), cutoff)
        if cutoff is None and surface.ior is None and is_binary(made[0]):
            sharp = made[0], 0.5
            if error(chart, sharp) <= _SHARP:
                return sharp
        return made

    def error(chart: Chart, made: Texture) -> float:
        off: float = hole_error(chart, made, points.uvs, truth)
        return off

    fit = best_fit(holes, tried, make, error)
    assert fit is not None  # there are always charts
    return fit


def _add_normals(surface: _Surface, found: _Found, side: int) -> None:
    """Add the normal map of a material, over the chart of its holes if it has any.

    Raises _NotOfUv.
    """
    normal, taken = surface.normal, found.chart()
    assert normal is not None  # the caller has asked
    points = _Points.of(surface.uses, normal)
    truth = 2.0 * normal.values(points.uvs)[:, :2] - 1.0
    if np.abs(truth).max() < normal_maps.FLAT:
        return
    own = list(charts(normal.depends, points.layer, points.used))
    if taken is None:
        fit = _fit_normals(normal, own, points, truth)
    else:
        used = _joined(surface.uses, taken.layer)
        if not np.allclose(used, points.used, atol=1e-6):
            raise _NotOfUv("another UV map than its holes")
        fit = _fit_normals(normal, [taken], points, truth)
        if fit is None:
            fit = _fit_normals(normal, own, points, truth)
            if fit is not None:
                found.holes = _refitted(surface, found.holes, fit.chart)
    if fit is None:
        raise _NotOfUv("nodes whose values do not repeat")
    xy = normal_maps.reduced(fit.texture, side)
    fit.texture = np.round(127.0 + 127.0 * np.clip(xy, -1.0, 1.0)).astype(np.uint8)
    found.normals = fit


def _fit_normals(
    normal: ColourOfUv, tried: list[Chart], points: _Points, truth: np.ndarray
) -> Fit | None:
    """x and y of the normals, (h, w, 2) float, over the best chart; None if all are wrong."""

    def make(chart: Chart, size: tuple[int, int]) -> Texture:
        return 2.0 * normal.texture(chart, size)[..., :2] - 1.0, None

    def error(chart: Chart, made: Texture) -> float:
        return float(np.abs(looked_up(made[0], chart, points.uvs) - truth).mean())

    fit = best_fit(normal, [chart for chart in tried if chart.is_upright], make, error)
    return None if fit is None or fit.error > _WRONG_NORMAL else fit


def _refitted(surface: _Surface, holes: Fit | None, chart: Chart) -> Fit | None:
    """The holes over the chart of the normal map. Raises _NotOfUv where they do not fit it."""
    assert surface.holes is not None and surface.shown is not None and holes is not None
    points = _Points.of(surface.uses, surface.holes)
    truth = surface.shown.values(points.uvs)
    cutoff = surface.cutoff if holes.cutoff is not None else None
    fit = _fit_holes(surface, cutoff, [chart], points, truth)
    if fit.error > max(_NOTED, holes.error):
        raise _NotOfUv("nodes that repeat otherwise than its holes")
    return fit
