"""The base colours of all materials, as records of a package and images.

Whether an image is what the nodes say is measured by the caller: it gets the colours that Cycles
shows at points of the surfaces.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from rna_geometry.shown_objects import as_rendered
from rna_materials.base_color_images import (
    LARGEST,
    baked,
    file_of,
    is_cut_off,
    texels_of,
    transform_of,
    wrap_of,
)
from rna_materials.base_color_source import BaseColour, base_colour_of
from rna_materials.material_uses import Use, Wanted, shown_materials, uses_of
from rna_materials.node_sources import lifted
from rna_materials.other_textures import texels_of_inputs
from rna_materials.shown_surfaces import Copies
from rna_materials.uv_charts import Chart
from rna_materials.uv_dependence import IDENTITY
from rna_materials.uv_points import NotOfUv, UvPoints, joined
from rna_materials.uv_render import ColourOfUv

_EVERY = 1 << 30  # texels a side, that are none too many


@dataclass
class _Found:
    """One material's base colour. shown: what its source gives; None of a factor alone."""

    material: bpy.types.Material
    base: BaseColour
    shown: ColourOfUv | None = None
    uses: list[Use] = field(default_factory=list)

    @property
    def image(self) -> bpy.types.Node | None:
        """The image node that the colour comes from; None if it comes from elsewhere."""
        node = None if self.base.source is None else self.base.source[0]
        if node is None or node.type != "TEX_IMAGE" or node.image is None:
            return None
        is_plain = node.projection == "FLAT" and node.image.source != "TILED"
        return node if is_plain and self.base.source[1].name == "Color" else None


def export_base_colors(
    path: str,
    charts: dict[str, Any],
    as_texels: Collection[str],
    largest: int,
    only: Collection[str] | None = None,
) -> dict[str, Any]:
    """Write an .npz of `image0`, ...: (n,) uint8 of a file, or (h, w, 3) uint8 in sRGB; and points.

    charts: that textures have taken, by material (see `surface_textures.export_textures`).
    as_texels: materials of which no files are wanted. largest: texels a side of what is baked.
    only: full names of the materials that are wanted; None: of all that surfaces show.

    Returns `colors`: records of material (its full name), factor, and for an image its number,
    colorSpace, wrap and transform, with `uvs0`, ... (p, 2) float32 stored coordinates of points and
    `shown0`, ... (p, 3) float32 linear colours there, before the factor, in the .npz. `charts`: as
    the argument, with those of images. `others`: by material, what else it has of textures (see
    `other_textures.py`). `notes`: for the user.
    """
    charts = dict(charts)
    colors: list[dict[str, Any]] = []
    arrays: dict[str, Any] = {}
    notes: list[str] = []
    copies = Copies()
    try:
        for found in _with_uses(list(_found(copies, Path(path).parent, only))):
            name = found.material.name_full
            color = {"material": name, "factor": _unit(found.base.factor)}
            try:
                if found.image is not None:
                    color |= _image(found, charts, name in as_texels, arrays, len(colors))
                elif found.shown is not None:
                    color |= _baked(found, charts, largest, arrays, len(colors), notes)
                colors.append(color)
            except NotOfUv as problem:
                notes += _note(found, problem)
    finally:
        copies.remove()
    np.savez(path, **arrays)
    return {"colors": colors, "charts": charts, "others": _others(charts), "notes": notes}


def _others(charts: dict[str, Any]) -> dict[str, dict[str, float]]:
    shown, _ = as_rendered(shown_materials)
    named = {m.name_full: m for m in bpy.data.materials if m.name_full in shown}
    return {name: texels_of_inputs(each, charts.get(name)) for name, each in named.items()}


def _found(copies: Copies, folder: Path, only: Collection[str] | None) -> list[_Found]:
    result = []
    on_surfaces, _ = as_rendered(shown_materials)
    if only is not None:
        on_surfaces &= set(only)
    for material in list(bpy.data.materials):
        if material.name_full not in on_surfaces or material.node_tree is None:
            continue
        copy = copies.of(material)
        base = base_colour_of(copy)
        if base is None:
            continue
        found = _Found(material, base)
        if base.source is not None:
            socket = lifted(copy.node_tree, base.source)
            found.shown = ColourOfUv(copy, socket, folder)
        result.append(found)
    return result


def _with_uses(every: list[_Found]) -> list[_Found]:
    wanted = {
        found.material.name_full: Wanted(
            set(found.shown.depends.layers), set(found.shown.depends.attributes)
        )
        for found in every
        if found.shown is not None
    }
    uses = as_rendered(lambda: uses_of(wanted))
    for found in every:
        found.uses = uses.get(found.material.name_full, [])
    return every


def _note(found: _Found, problem: NotOfUv) -> list[str]:
    """That a base colour is learnt; none of attributes, which are seldom finer than planes."""
    assert found.shown is not None  # or there is no problem
    if found.shown.depends.attributes:
        return []
    return [
        f"material {found.material.name!r} has a base colour by {problem}, which is no function of "
        "its UV coordinates: it is learnt, and as fine as the planes"
    ]


def _image(
    found: _Found,
    charts: dict[str, Any],
    as_texels: bool,
    arrays: dict[str, np.ndarray],
    number: int,
) -> dict[str, Any]:
    """The members of a record that an image has. Raises NotOfUv."""
    name, node, shown = found.material.name_full, found.image, found.shown
    assert node is not None and shown is not None  # the caller has checked
    points = UvPoints.of(found.uses, shown)
    chart = _chart(found, points, charts.get(name))
    mapping = shown.depends.images[0].mapping if shown.depends.images else IDENTITY
    file = None if as_texels or is_cut_off(node, mapping, points.used) else file_of(node)
    if file is None:
        image, mapping = texels_of(node, shown, points.layer, mapping, points.used)
        space = "srgb"
    else:
        image, space = np.frombuffer(file[0], np.uint8), file[1]
    charts[name] = {"layer": chart.layer, "matrix": chart.matrix.tolist()}
    arrays[f"image{number}"] = image
    arrays[f"uvs{number}"] = chart.stored(points.uvs.astype(np.float32))
    arrays[f"shown{number}"] = shown.values(points.uvs)
    transform = transform_of(mapping, chart)
    return {"image": number, "colorSpace": space, "wrap": wrap_of(node), "transform": transform}


def _baked(
    found: _Found,
    charts: dict[str, Any],
    largest: int,
    arrays: dict[str, np.ndarray],
    number: int,
    notes: list[str],
) -> dict[str, Any]:
    """The members of a record of what is no image, as a texture. Raises NotOfUv.

    notes: gets one where the images have more texels than that.
    """
    name, shown = found.material.name_full, found.shown
    assert shown is not None  # the caller has checked
    points = UvPoints.of(found.uses, shown)
    taken = _chart(found, points, charts[name]) if name in charts else None
    image, chart = baked(shown, points, taken, largest)
    width, height = chart.size(shown.depends, largest=_EVERY)
    if shown.depends.images and max(width, height) > largest:
        notes.append(
            f"material {found.material.name!r} has a base colour of {width} x {height} texels, "
            f"baked with {image.shape[1]} x {image.shape[0]}; --texture-size takes more, up to "
            f"{LARGEST}"
        )
    charts[name] = {"layer": chart.layer, "matrix": chart.matrix.tolist()}
    arrays[f"image{number}"] = image
    arrays[f"uvs{number}"] = chart.stored(points.uvs.astype(np.float32))
    arrays[f"shown{number}"] = shown.values(points.uvs)
    transform = transform_of(chart.matrix, chart)
    return {"image": number, "colorSpace": "srgb", "wrap": "repeat", "transform": transform}


def _chart(found: _Found, points: UvPoints, taken: dict[str, Any] | None) -> Chart:
    """The chart of a material: that of its other textures if it has any. Raises NotOfUv."""
    if taken is None:
        return Chart(points.layer, IDENTITY)
    chart = Chart(taken["layer"], np.array(taken["matrix"]))
    used = joined(found.uses, chart.layer)
    if chart.layer != points.layer and not np.allclose(used, points.used, atol=1e-6):
        raise NotOfUv("another UV map than its holes and normal map")
    return chart


def _unit(factor: np.ndarray) -> list[float]:
    """A factor from 0 to 1, of the same hue: the transport that it multiplies is learnt."""
    factor = np.maximum(factor, 0.0)
    values: list[float] = (factor / max(1.0, factor.max())).tolist()
    return values
