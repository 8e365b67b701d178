"""A colour of a material's nodes as a function of texture coordinates, by rendering it.

The nodes, wired to an emission shader, are rendered on quads, one sample at each quad's or texel's
centre.
"""

from collections.abc import Iterator
from pathlib import Path

import bpy
import numpy as np
from rna_materials.node_sources import Source, sources
from rna_materials.uv_charts import Chart
from rna_materials.uv_dependence import dependence

_SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
_POINT = 1e-4  # half a side of a point's quad, in UV; tangents need one


def surface_output(material: bpy.types.Material) -> bpy.types.Node | None:
    """The output node that Cycles uses, if it has a surface; None otherwise."""
    tree = material.node_tree
    if tree is None:
        return None
    output = tree.get_output_node("CYCLES") or tree.get_output_node("ALL")
    return output if output is not None and output.inputs["Surface"].is_linked else None


def surface_sources(material: bpy.types.Material) -> Iterator[Source]:
    """`sources` of the surface; none of a material without."""
    output = surface_output(material)
    if output is not None:
        yield from sources(output.inputs["Surface"])


class ColourOfUv:
    """A colour socket of a material that may be changed: it then shows this colour alone.

    Attributes:
        depends: what the colour depends on.
        layers, constants: UV maps of the quads, and attributes that are the same all over, (4,).
    """

    def __init__(
        self, material: bpy.types.Material, colour: bpy.types.NodeSocket, folder: Path
    ) -> None:
        tree, output = material.node_tree, surface_output(material)
        assert output is not None  # the colour is of its surface
        glow = tree.nodes.new("ShaderNodeEmission")
        tree.links.new(colour, glow.inputs["Color"])
        tree.links.new(glow.outputs[0], output.inputs["Surface"])
        for name in ("Volume", "Displacement"):
            for link in list(output.inputs[name].links):
                tree.links.remove(link)
        self.depends = dependence(sources(glow.inputs["Color"]))
        self.layers: set[str] = set()
        self.constants: dict[str, np.ndarray] = {}
        self._material, self._path = material, folder / "texture.exr"

    def texture(self, chart: Chart, size: tuple[int, int]) -> np.ndarray:
        """(h, w, 3) float32 at the texel centres of the chart's square, row 0 at the top."""
        width = size[0] / size[1]
        places = (_SQUARE - 0.5) * [width, 1.0]
        return self._rendered(places, chart.uvs(_SQUARE), size)[::-1]

    def values(self, uvs: np.ndarray) -> np.ndarray:
        """(n, 3) float32 at UV coordinates (n, 2)."""
        side = int(np.ceil(np.sqrt(len(uvs))))
        rows, columns = np.divmod(np.arange(len(uvs)), side)
        cell = np.stack([columns, rows], axis=1)[:, None] + _SQUARE
        corners = uvs[:, None] + _POINT * (2.0 * _SQUARE - 1.0)
        image = self._rendered(
            (cell / side - 0.5).reshape(-1, 2), corners.reshape(-1, 2), (side,) * 2
        )
        return image.reshape(-1, 3)[: len(uvs)]

    def _rendered(self, places: np.ndarray, uvs: np.ndarray, size: tuple[int, int]) -> np.ndarray:
        """(h, w, 3), row 0 at the bottom, of quads with corners (4q, 2) in an image's plane."""
        scene = bpy.data.scenes.new("rna texture")
        added = [self._quads(scene, places, uvs), _set_up(scene, size, self._path)]
        try:
            bpy.ops.render.render(write_still=True, scene=scene.name)
            image = bpy.data.images.load(str(self._path))
            pixels = np.empty(4 * size[0] * size[1], np.float32)
            image.pixels.foreach_get(pixels)
            bpy.data.images.remove(image)
        finally:
            self._path.unlink(missing_ok=True)
            for item in added:
                data = item.data
                collection = (
                    bpy.data.meshes if isinstance(data, bpy.types.Mesh) else bpy.data.cameras
                )
                bpy.data.objects.remove(item)
                collection.remove(data)
            bpy.data.scenes.remove(scene)
        return pixels.reshape(size[1], size[0], 4)[..., :3]

    def _quads(
        self, scene: bpy.types.Scene, places: np.ndarray, uvs: np.ndarray
    ) -> bpy.types.Object:
        mesh = bpy.data.meshes.new("rna texture")
        vertices = np.column_stack([places, np.zeros(len(places))])
        mesh.vertices.add(len(places))
        mesh.vertices.foreach_set("co", vertices.astype(np.float32).ravel())
        mesh.loops.add(len(places))
        mesh.loops.foreach_set("vertex_index", np.arange(len(places), dtype=np.int32))
        mesh.polygons.add(len(places) // 4)
        mesh.polygons.foreach_set("loop_start", np.arange(0, len(places), 4, dtype=np.int32))
        mesh.update(calc_edges=True)
        for name in sorted(self.layers):
            layer = mesh.uv_layers.new(name=name or "UVMap")
            layer.uv.foreach_set("vector", uvs.astype(np.float32).ravel())
            layer.active_render = layer.active_render or not name
        for name, value in self.constants.items():
            colour = mesh.color_attributes.new(name or "rna colour", "FLOAT_COLOR", "CORNER")
            colour.data.foreach_set("color", np.tile(value, len(places)).astype(np.float32))
            if not name:
                mesh.attributes.default_color_name = colour.name
        mesh.materials.append(self._material)
        item = bpy.data.objects.new("rna texture", mesh)
        scene.collection.objects.link(item)
        return item


def _set_up(scene: bpy.types.Scene, size: tuple[int, int], path: Path) -> bpy.types.Object:
    camera = bpy.data.cameras.new("rna texture")
    camera.type, camera.ortho_scale = "ORTHO", max(1.0, size[0] / size[1])
    placed = bpy.data.objects.new("rna texture", camera)
    placed.location = (0.0, 0.0, 1.0)
    scene.collection.objects.link(placed)
    scene.camera = placed
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = size
    render.resolution_percentage = 100
    render.filepath = str(path)
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = 1, False, False
    cycles.pixel_filter_type, cycles.filter_width = "GAUSSIAN", 0.01  # a box ignores its width
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    return placed
