"""Holes, thin glass and normal maps of all materials, as textures of a package.

A package's texture is a function of one set of texture coordinates, and repeats. Whether one is
what the nodes say is measured: Cycles shows their colour at points of the surfaces, and the texture
is compared with it.
"""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from rna_materials import normal_maps
from rna_materials.relief import ReliefOfUv
from rna_materials.shown_surfaces import Copies, Surface, find_uses, shown_surfaces
from rna_materials.texture_fit import (
    Fit,
    Texture,
    best_fit,
    hole_error,
    hole_texture,
    is_binary,
    looked_up,
)
from rna_materials.uv_charts import LARGEST, Chart, charts
from rna_materials.uv_points import NotOfUv, UvPoints, joined
from rna_materials.uv_render import ColourOfUv

_NOTED, _WRONG = 0.01, 0.1  # mean errors of holes: noted, and of no use
_WRONG_NORMAL = 0.03  # mean error of a normal's x and y, or as
_OF_RELIEF = 0.25  # a share of their mean
_BLUR = 0.01  # more error of a map of fewer texels, that is noted
_KEPT = 0.5  # of the relief's spread, at least, in a map of fewer texels
_SHARP = 0.025  # error of a sharp outline where Cycles has one as wide as a texel


@dataclass
class _Textures:
    """Textures of one material, and notes about it.

    captured: whether light that it lets through has no texture. learnt: whether its relief has
    none. obstacle: what it is by then, or what flattens it.
    """

    holes: Fit | None = None
    normals: Fit | None = None
    captured: bool = False
    learnt: bool = False
    obstacle: str | None = None
    notes: list[str] = field(default_factory=list)

    def chart(self) -> Chart | None:
        """The chart of its textures, unless they are constant."""
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
    light through some has no texture; `learnt`, whether some relief has none; `obstacles`, by
    material, what that relief is by; `notes` for the user.
    """
    holes: list[dict[str, Any]] = []
    normals: list[str] = []
    stored, notes, captured, learnt = {}, [], False, side == 0
    textures: dict[str, Any] = {}
    obstacles = {} if side else {each.name_full: _limit(0) for each in bpy.data.materials}
    copies = Copies()
    try:
        surfaces = list(shown_surfaces(copies, Path(path).parent, side > 0))
        find_uses(surfaces)
        for surface in surfaces:
            name, surface_textures = surface.material.name_full, _textures_of(surface, side)
            captured, learnt = (
                captured or surface_textures.captured,
                learnt or surface_textures.learnt,
            )
            notes += [
                f"material {surface.material.name!r} {note}" for note in surface_textures.notes
            ]
            if surface_textures.holes is not None:
                textures[f"holes{len(holes)}"] = surface_textures.holes.texture
                holes.append(
                    {"material": name, "cutoff": surface_textures.holes.cutoff, "ior": surface.ior}
                )
            if surface_textures.normals is not None:
                textures[f"normals{len(normals)}"] = surface_textures.normals.texture
                normals.append(name)
            if surface_textures.obstacle is not None:
                obstacles[name] = surface_textures.obstacle
            if (chart := surface_textures.chart()) is not None:
                stored[name] = chart.record()
    finally:
        copies.remove()
    np.savez(path, **textures)
    all_textures = {"holes": holes, "normals": normals, "charts": stored}
    others = {"captured": captured, "learnt": learnt, "obstacles": obstacles, "notes": notes}
    return {**all_textures, **others}


def _limit(side: int) -> str:
    return f"the limit of {side} texels (--normal-texels)"


def _textures_of(surface: Surface, side: int) -> _Textures:
    textures = _Textures()
    if surface.holes is not None:
        try:
            textures.holes = _holes_of(surface, textures)
        except NotOfUv as problem:
            textures.captured = True
            textures.notes.append(
                f"is transparent by {problem}, which is no function of its UV coordinates: "
                "light from behind it is part of the captured light"
            )
    textures.obstacle = surface.no_normal
    if surface.normal is not None and surface.uses:
        try:
            _add_normals(surface, textures, side)
        except NotOfUv as problem:
            textures.obstacle = str(problem)
    if textures.obstacle is not None and textures.normals is None:
        textures.learnt = True
        textures.notes.append(f"has relief by {textures.obstacle}: it is learnt, not mapped")
    return textures


def _holes_of(surface: Surface, textures: _Textures) -> Fit | None:
    """The texture of a material's holes, None if it has none; notes go to `textures`.

    Raises NotOfUv.
    """
    holes, shown = surface.holes, surface.shown
    assert holes is not None and shown is not None  # the caller has checked
    if not surface.uses:
        _check_hair(shown)
        return None
    points = UvPoints.of(surface.uses, holes)
    if shown is not holes:
        UvPoints.of(surface.uses, shown)
    truth = shown.values(points.uvs)
    tried = list(charts(holes.depends, points.layer, points.used))
    fits = [_fit_holes(surface, surface.cutoff, tried, points, truth)]
    if surface.cutoff is not None and fits[0].error > _NOTED:
        fits.append(_fit_holes(surface, None, tried, points, truth))
    fit = min(fits, key=lambda each: each.error)
    if fit.error > _WRONG:
        raise NotOfUv("nodes whose values do not repeat")
    least = 0.0 if fit.cutoff is None else 255.0 * fit.cutoff
    if fit.texture.max() <= least:
        return None
    if surface.on_hair:
        textures.captured = True
        textures.notes.append(
            "lets light through on strands: light from behind them is part of the captured light"
        )
    if fit.error > _NOTED:
        textures.notes.append(
            f"is transparent by a pattern that no repeated texture of {fit.texture.shape[1]} x "
            f"{fit.texture.shape[0]} texels holds: {fit.error:.1%} of its area differ"
        )
    if (fit.texture == fit.texture[:1, :1]).all():
        fit.texture = np.ascontiguousarray(fit.texture[:1, :1])
    return fit


def _check_hair(shown: ColourOfUv) -> None:
    """Raises NotOfUv for strands that let light through."""
    if shown.depends.problems:
        raise NotOfUv(shown.depends.problems[0])
    if shown.depends.layers or shown.depends.attributes:
        raise NotOfUv("an attribute of strands")
    if shown.values(np.zeros((16, 2))).max() > 0.5 / 255.0:
        raise NotOfUv("its strands")


def _fit_holes(
    surface: Surface, cutoff: float | None, tried: list[Chart], points: UvPoints, truth: np.ndarray
) -> Fit:
    """The best texture of a material's holes; with a cutoff, of the value it is compared with."""
    shown = surface.shown
    holes = shown if cutoff is None else surface.holes
    assert holes is not None and shown is not None  # the caller has checked

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


def _add_normals(surface: Surface, textures: _Textures, side: int) -> None:
    """Add the normal map of a material, over the chart of its holes if it has any.

    Raises NotOfUv.
    """
    normal, taken = surface.normal, textures.chart()
    assert normal is not None  # the caller has checked
    points = UvPoints.of(surface.uses, normal)
    if isinstance(normal, ReliefOfUv):
        normal.measure(surface.uses, points.layer)
    truth = 2.0 * normal.values(points.uvs)[:, :2] - 1.0
    if np.abs(truth).max() < normal_maps.FLAT:
        return
    normal_charts = list(charts(normal.depends, points.layer, points.used))
    if taken is None:
        fit = _fit_normals(normal, normal_charts, points, truth)
    else:
        used = joined(surface.uses, taken.layer)
        if not np.allclose(used, points.used, atol=1e-6):
            raise NotOfUv("another UV map than its holes")
        fit = _fit_normals(normal, [taken], points, truth)
        if fit is None:
            fit = _fit_normals(normal, normal_charts, points, truth)
            if fit is not None:
                textures.holes = _refitted(surface, textures.holes, fit.chart)
    if fit is None:
        raise NotOfUv("nodes whose values do not repeat, or are too fine")
    height, width = fit.texture.shape[:2]
    xy = normal_maps.reduced(fit.texture, side)
    off = float(np.abs(looked_up(xy, fit.chart, points.uvs) - truth).mean())
    if off > fit.error + _BLUR:
        textures.notes.append(
            f"has a normal map of {width} x {height} texels, stored as {xy.shape[1]} x "
            f"{xy.shape[0]}: finer relief blurs (--normal-texels)"
        )
    if xy.std() < _KEPT * fit.texture.std():
        textures.obstacle = _limit(side)
    fit.texture = np.round(127.0 + 127.0 * np.clip(xy, -1.0, 1.0)).astype(np.uint8)
    textures.normals = fit


def _fit_normals(
    normal: ColourOfUv, tried: list[Chart], points: UvPoints, truth: np.ndarray
) -> Fit | None:
    """x and y of the normals, (h, w, 2) float, over the best chart; None if all are wrong."""

    def make(chart: Chart, size: tuple[int, int]) -> Texture:
        return 2.0 * normal.texture(chart, size)[..., :2] - 1.0, None

    def error(chart: Chart, made: Texture) -> float:
        return float(np.abs(looked_up(made[0], chart, points.uvs) - truth).mean())

    largest = normal.largest if isinstance(normal, ReliefOfUv) else LARGEST
    fit = best_fit(normal, [chart for chart in tried if chart.is_upright], make, error, largest)
    wrong = max(_WRONG_NORMAL, _OF_RELIEF * float(np.abs(truth).mean()))
    return None if fit is None or fit.error > wrong else fit


def _refitted(surface: Surface, holes: Fit | None, chart: Chart) -> Fit | None:
    """The holes over the chart of the normal map. Raises NotOfUv where they do not fit it."""
    assert surface.holes is not None and surface.shown is not None and holes is not None
    points = UvPoints.of(surface.uses, surface.holes)
    truth = surface.shown.values(points.uvs)
    cutoff = surface.cutoff if holes.cutoff is not None else None
    fit = _fit_holes(surface, cutoff, [chart], points, truth)
    if fit.error > max(_NOTED, holes.error):
        raise NotOfUv("nodes that repeat otherwise than its holes")
    return fit
