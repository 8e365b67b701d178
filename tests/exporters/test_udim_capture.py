"""Base colours of UDIM tiles: each tile's own file, what crosses them baked."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rna_export.capture.geometry import base_colors
from rna_export.capture.geometry.exported_parts import ExportedParts
from tests.exporters.conftest import OpenWorker
from tests.exporters.test_base_color_capture import SHADERS, sampled

pytestmark = pytest.mark.blender

SIZES = {1001: (64, 64), 1002: (240, 96), 1012: (512, 256)}
NOWHERE, ACROSS = 1005, 0
TILES = 1002, ACROSS, 1012, NOWHERE, 1001, 1002
"""Tiles of squares in a row."""

TILED = """
# One material on squares in a row, each with its corners in a tile, or across two of them.
tiled = bpy.data.images.load({folder!r} + "/print.1001.png")
tiled.source = "TILED"
for number in (1002, 1012):
    tiled.tiles.new(number)
material = bpy.data.materials.new("body paint")
material.use_nodes = True
tree = material.node_tree
of, uv = tree.nodes.new("ShaderNodeTexImage"), tree.nodes.new("ShaderNodeUVMap")
mapping = tree.nodes.new("ShaderNodeMapping")
mapping.inputs["Scale"].default_value = (2.0, 2.0, 1.0)
of.image = tiled
tree.links.new(uv.outputs[0], mapping.inputs["Vector"])
tree.links.new(mapping.outputs[0], of.inputs["Vector"])
shader = tree.nodes.new({shader!r})
tree.links.new(of.outputs["Color"], shader.inputs["Color"])
output = tree.nodes["Material Output"]
tree.links.new(shader.outputs[0], output.inputs["Surface"])
positions, uvs = [], []
for k, tile in enumerate({tiles!r}):
    v, u = divmod(tile - 1001, 10) if tile else (0, 0.6)
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        positions.append((x + 1.2 * k, y, 0))
        uvs += [(0.02 + 0.96 * x + u) / 2, (0.02 + 0.96 * y + v) / 2]
mesh = bpy.data.meshes.new("body")
mesh.from_pydata(positions, [], [range(4 * k, 4 * k + 4) for k in range(len(positions) // 4)])
mesh.uv_layers.new(name="UVMap").uv.foreach_set("vector", uvs)
mesh.materials.append(material)
bpy.context.scene.collection.objects.link(bpy.data.objects.new("body", mesh))
red = diffuse((0.8, 0.1, 0.2))
add([(0, 0, 0.5), (1, 0, 0.5), (0, 1, 0.5)], [(0, 1, 2)], red)
"""

PACKED = "\ntiled.pack()"
PUNCHED = """
holes = bpy.data.images.load({folder!r} + "/holes.png")
holes.colorspace_settings.name = "Non-Color"
where = tree.nodes.new("ShaderNodeTexImage")
where.image = holes
tree.links.new(uv.outputs[0], where.inputs["Vector"])
mix, clear = tree.nodes.new("ShaderNodeMixShader"), tree.nodes.new("ShaderNodeBsdfTransparent")
tree.links.new(where.outputs["Color"], mix.inputs[0])
tree.links.new(clear.outputs[0], mix.inputs[1])
tree.links.new(shader.outputs[0], mix.inputs[2])
tree.links.new(mix.outputs[0], output.inputs["Surface"])
"""


def write_tiles(folder: Path) -> None:
    """Bars and ramps, of another hue in each tile; and a mask."""
    for number, (width, height) in SIZES.items():
        x, y = np.meshgrid(np.arange(width), np.arange(height))
        bars = 255 * (x // 8 % 2) * (y < height // 2)
        pixels = np.stack([bars, y * 255 // height, x * 255 // width], axis=-1)
        pixels = np.roll(pixels, number, axis=-1).astype(np.uint8)
        Image.fromarray(pixels).save(folder / f"print.{number}.png")
    mask = np.full((16, 16), 255, np.uint8)
    mask[4:8, 4:8] = 0
    Image.fromarray(mask).save(folder / "holes.png")


def captured(
    open_worker: OpenWorker, folder: Path, changes: str = "", tiles: tuple[int, ...] = TILES
) -> tuple[ExportedParts, dict[int, tuple[np.ndarray, np.ndarray]]]:
    """Exported parts; by square, the base colours of samples and Cycles' colours."""
    write_tiles(folder)
    source = {"folder": str(folder), "tiles": tiles}
    diffuse = (TILED + changes).format(**source, shader=SHADERS[0])
    glowing = TILED.format(**source, shader=SHADERS[1])
    exported, at, shown, on_red = sampled(open_worker, folder, diffuse, glowing)
    square = np.where(on_red, -1, np.floor(at["position"][:, 0] / 1.2))
    colours = {k: (at["base_color"][square == k], shown[square == k]) for k in range(len(tiles))}
    return exported, colours


def images_of(exported: ExportedParts) -> list[str]:
    return [r.image for r in exported.colors["asset"] if r.image is not None]


def test_each_tile_keeps_its_file_and_what_crosses_them_is_baked(open_worker, tmp_path):
    exported, colours = captured(open_worker, tmp_path)
    assert exported.notes == []
    names = {n: f"base_color/body-paint-{n}.png" for n in SIZES}
    assert images_of(exported) == ["base_color/body-paint.png", *names.values()]
    for number, name in names.items():
        path = tmp_path / f"print.{number}.png"
        assert exported.textures[name] == path.read_bytes(), number
    for k, tile in enumerate(TILES):
        base, shown = colours[k]
        assert len(base) > 100
        is_file = tile in SIZES
        assert np.abs(base - shown).mean() < (0.005 if is_file else 0.01), tile
        assert tile == NOWHERE or np.ptp(shown, axis=0).max() > 0.5, tile


def test_a_tile_has_the_triangles_that_lie_in_it(open_worker, tmp_path):
    """1002 has two squares that lie apart in the mesh; tiles without triangles are left out."""
    exported, _ = captured(open_worker, tmp_path, tiles=(1002, 1001, 1002))
    mesh = exported.geometries["asset"]
    squares = {
        r.image: np.unique(
            mesh.positions[mesh.triangles[slice(r.triangles[0], sum(r.triangles))]][:, :, 0] // 1.2
        ).tolist()
        for r in exported.colors["asset"]
        if r.image is not None
    }
    assert squares == {
        "base_color/body-paint-1001.png": [1.0],
        "base_color/body-paint-1002.png": [0.0, 2.0],
    }


def test_packed_tiles_and_those_of_a_punched_material(open_worker, tmp_path):
    exported, colours = captured(open_worker, tmp_path, PACKED + PUNCHED, (1012, 1001, 1002))
    assert sorted(images_of(exported)) == [f"base_color/body-paint-{n}.png" for n in SIZES]
    for number in SIZES:
        path = tmp_path / f"print.{number}.png"
        assert exported.textures[f"base_color/body-paint-{number}.png"] == path.read_bytes()
    for base, shown in colours.values():
        assert len(base) > 100 and np.abs(base - shown).mean() < 0.005
    (punched,) = exported.records["asset"]
    imaged = [r.triangles for r in exported.colors["asset"] if r.image is not None]
    assert (
        punched.triangles == (imaged[0][0], sum(count for _, count in imaged)) == (imaged[0][0], 6)
    )


def test_more_tiles_than_a_part_has_records_are_baked(open_worker, tmp_path, monkeypatch):
    monkeypatch.setattr(base_colors, "_MOST", 2)
    exported, colours = captured(open_worker, tmp_path, tiles=(1002, 1001, 1012))
    assert exported.notes == [
        "material 'body paint' has 3 UDIM tiles, and a part 2 images: they are baked as one"
    ]
    assert images_of(exported) == ["base_color/body-paint.png"]
    for base, shown in colours.values():
        assert np.abs(base - shown).mean() < 0.01
