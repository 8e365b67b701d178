"""The base colours of all materials, as records of a package and images.

Whether an image is what the nodes say is measured by the caller: it gets the colours that Cycles
shows at points of the surfaces.
"""

from collections.abc import Collection
from dataclasses import dataclass, field, replace
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
from rna_materials.udim_tiles import is_tiled, numbers_of, onto_tile
from rna_materials.uv_charts import Chart
from rna_materials.uv_dependence import IDENTITY
from rna_materials.uv_points import NotOfUv, UvPoints, joined
from rna_materials.uv_render import ColourOfUv

_EVERY = 1 << 30  # texels a side, that are none too many


Piece = tuple[str, int]
"""A material's full name and a tile of its UDIM image: 0 without tiles, and beyond them all."""


@dataclass
class Wish:
    """A request for base colours.

    largest: texels a side of what is baked. as_texels: of which no files are wanted. whole: full
    names of materials whose tiles are to be baked as one image. only: full names of the materials
    that are wanted; None: of all that surfaces show.
    """

    largest: int
    as_texels: Collection[Piece] = ()
    whole: Collection[str] = ()
    only: Collection[str] | None = None

    @classmethod
    def of(cls, request: dict[str, Any]) -> "Wish":
        """The wish in a worker's request."""
        as_texels = {(name, tile) for name, tile in request["asTexels"]}
        return cls(request["largest"], as_texels, request["whole"], request["only"])


@dataclass
class _Found:
    """One material's base colour. shown: its source's colours; None of a factor alone."""

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
        is_flat = node.projection == "FLAT"
        return node if is_flat and self.base.source[1].name == "Color" else None


@dataclass
class _Exported:
    """Results of `export_base_colors`."""

    charts: dict[str, Any]
    colors: list[dict[str, Any]] = field(default_factory=list)
    arrays: dict[str, Any] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    obstacles: dict[str, str] = field(default_factory=dict)


def export_base_colors(path: str, charts: dict[str, Any], wish: Wish) -> dict[str, Any]:
    """Write an .npz of `image0`, ...: (n,) uint8 of a file, or (h, w, 3) uint8 in sRGB; and points.

    charts: that textures have taken, by material (see `surface_textures.export_textures`).

    Returns `colors`: records of material (its full name), tile (see `Piece`), factor, and for an
    image its number, colorSpace, wrap and transform, with `uvs0`, ... (p, 2) float32 stored
    coordinates of points and `shown0`, ... (p, 3) float32 linear colours there, before the factor,
    in the .npz. `charts`: as the argument, with those of images, and of tiled ones `tiles` (see
    `udim_tiles.numbers_of`). `others`: by material, what else it has of textures (see
    `other_textures.py`). `obstacles`: by material, why its base colour is no image. `notes`: for
    the user.
    """
    exported = _Exported(dict(charts))
    copies = Copies()
    try:
        for found in _with_uses(list(_found(copies, Path(path).parent, wish.only))):
            try:
                _add(exported, found, wish)
            except NotOfUv as problem:
                exported.notes += _note(found, problem)
                exported.obstacles[found.material.name_full] = str(problem)
    finally:
        copies.remove()
    np.savez(path, **exported.arrays)
    answer = {"colors": exported.colors, "charts": exported.charts, "notes": exported.notes}
    others = {"others": _others(exported.charts), "obstacles": exported.obstacles}
    return {**answer, **others}


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
    node = found.image
    where = " across its UDIM tiles" if node is not None and is_tiled(node) else ""
    return [
        f"material {found.material.name!r} has a base colour{where} by {problem}, which is no "
        "function of its UV coordinates: it is learnt, and as fine as the planes"
    ]


def _add(exported: _Exported, found: _Found, wish: Wish) -> None:
    """The records of a material: one, or of a tiled image one for each tile. Raises NotOfUv."""
    name, shown = found.material.name_full, found.shown
    factor = _unit(found.base.factor)
    if shown is None:
        exported.colors.append({"material": name, "tile": 0, "factor": factor})
        return
    points = UvPoints.of(found.uses, shown)
    chart = _chart(found, points, exported.charts.get(name))
    pieces, node = {0: points}, found.image
    if node is not None and is_tiled(node) and name not in wish.whole:
        there = [tile.number for tile in node.image.tiles]
        chart.tiles = {"matrix": _mapping(shown).tolist(), "numbers": there}
        numbers = numbers_of(points.used, chart.tiles)
        order = np.unique(numbers)[::-1]  # what is baked comes last: it may fail
        pieces = {int(n): points.on(numbers == n) for n in order}
    colours = shown.values(np.concatenate([piece.uvs for piece in pieces.values()]))
    truths = np.split(colours, len(pieces))
    for (tile, piece), truth in zip(pieces.items(), truths, strict=True):
        if node is None or (is_tiled(node) and not tile):
            image, members = _baked(found, piece, chart, wish.largest, exported.notes)
        else:
            image, members = _image(found, tile, piece, chart, (name, tile) in wish.as_texels)
        number = len(exported.colors)
        exported.arrays[f"image{number}"] = image
        exported.arrays[f"uvs{number}"] = chart.stored(piece.uvs.astype(np.float32))
        exported.arrays[f"shown{number}"] = truth
        record = {"material": name, "tile": tile, "factor": factor, "image": number}
        exported.colors.append({**record, **members})
        exported.charts[name] = chart.record()


def _mapping(shown: ColourOfUv) -> np.ndarray:
    """(2, 3) from UVs to coordinates of the image that a colour comes from."""
    images = shown.depends.images
    return np.asarray(images[0].mapping if images else IDENTITY)


def _image(
    found: _Found, tile: int, points: UvPoints, chart: Chart, as_texels: bool
) -> tuple[np.ndarray, dict[str, Any]]:
    """An image, its file or texels, and the members of a record that it has."""
    node, shown = found.image, found.shown
    assert node is not None and shown is not None  # the caller has checked
    mapping = onto_tile(_mapping(shown), tile) if tile else _mapping(shown)
    file = None if as_texels or is_cut_off(node, mapping, points.used) else file_of(node, tile)
    if file is None:
        image, mapping = texels_of(node, tile, shown, points.layer, mapping, points.used)
        space = "srgb"
    else:
        image, space = np.frombuffer(file[0], np.uint8), file[1]
    transform = transform_of(mapping, chart)
    return image, {"colorSpace": space, "wrap": wrap_of(node), "transform": transform}


def _baked(
    found: _Found, points: UvPoints, chart: Chart, largest: int, notes: list[str]
) -> tuple[np.ndarray, dict[str, Any]]:
    """As `_image`, for colours that are no single image. Raises NotOfUv.

    notes: gets one where the images have more texels than that.
    """
    shown = found.shown
    assert shown is not None  # the caller has checked
    image, over = baked(shown, points, largest)
    width, height = over.size(shown.depends, largest=_EVERY)
    if shown.depends.images and max(width, height) > largest:
        notes.append(
            f"material {found.material.name!r} has a base colour of {width} x {height} texels, "
            f"baked with {image.shape[1]} x {image.shape[0]}; --texture-size takes more, up to "
            f"{LARGEST}"
        )
    transform = transform_of(over.matrix, chart)
    return image, {"colorSpace": "srgb", "wrap": "repeat", "transform": transform}


def _chart(found: _Found, points: UvPoints, taken: dict[str, Any] | None) -> Chart:
    """The chart of a material: the chart of its other textures if any. Raises NotOfUv."""
    if taken is None:
        return Chart(points.layer, IDENTITY)
    chart = replace(Chart.of(taken), tiles=None)
    used = joined(found.uses, chart.layer)
    if chart.layer != points.layer and not np.allclose(used, points.used, atol=1e-6):
        raise NotOfUv("another UV map than its holes and normal map")
    return chart


def _unit(factor: np.ndarray) -> list[float]:
    """A factor from 0 to 1, of the same hue: the transport that it multiplies is learnt."""
    factor = np.maximum(factor, 0.0)
    values: list[float] = (factor / max(1.0, factor.max())).tolist()
    return values
