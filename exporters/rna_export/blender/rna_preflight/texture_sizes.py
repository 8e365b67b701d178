"""How large the details of texture nodes are in the world, as their coordinates place them."""

import math
from dataclasses import dataclass

import bpy
import numpy as np
from rna_geometry import shown_objects
from rna_geometry.attributes import read, uv_map
from rna_geometry.shown_objects import SURFACES
from rna_materials.node_sources import origin
from rna_materials.object_materials import materials_of
from rna_preflight import image_detail
from rna_preflight.shader_values import Shader, constant

_WAVE = 20.0 / (2.0 * math.pi)  # waves a unit, of Blender's Wave Texture at scale 1
_OCTAVE = 2.0  # of a noise with detail: its second octave still shows


@dataclass
class Extent:
    """Metres a unit of texture coordinates, of the smallest object that has a material."""

    generated: float = math.inf
    object: float = math.inf
    uv: float = math.inf

    def smaller(self, other: "Extent") -> None:
        """Take the smaller ones."""
        self.generated = min(self.generated, other.generated)
        self.object = min(self.object, other.object)
        self.uv = min(self.uv, other.uv)


def extents() -> dict[str, Extent]:
    """Extents of each shown material by its full name; within `as_rendered`."""
    result: dict[str, Extent] = {}
    seen: dict[int, Extent] = {}
    for instance in shown_objects.seen():
        item = instance.object
        if item.type not in SURFACES:
            continue
        key = hash((item.data.as_pointer(), *np.array(instance.matrix_world).ravel().round(4)))
        if key not in seen:
            seen[key] = _extent(item, np.array(instance.matrix_world))
        for material in materials_of(item):
            if material is not None:
                result.setdefault(material.name_full, Extent()).smaller(seen[key])
    return result


def _extent(item: bpy.types.Object, matrix: np.ndarray) -> Extent:
    scale = float(np.cbrt(abs(np.linalg.det(matrix[:3, :3]))))
    corners = np.array(item.bound_box)
    longest = scale * float(np.ptp(corners, axis=0).max())
    mesh = item.to_mesh()
    try:
        return Extent(longest or math.inf, scale or math.inf, scale * _metres_a_uv(mesh))
    finally:
        item.to_mesh_clear()


def _metres_a_uv(mesh: bpy.types.Mesh) -> float:
    """Root of the ratio of areas; infinite without a UV map."""
    uvs = None if mesh is None else uv_map(mesh, "")
    if uvs is None:
        return math.inf
    mesh.calc_loop_triangles()
    triangles = len(mesh.loop_triangles)
    loops = read(mesh.loop_triangles, "loops", 3 * triangles, np.int32).reshape(-1, 3)
    a, b = (uvs[loops[:, k]] - uvs[loops[:, 0]] for k in (1, 2))
    in_uv = 0.5 * float(np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum())
    area = float(read(mesh.loop_triangles, "area", triangles).sum())
    return math.sqrt(area / in_uv) if in_uv > 0.0 else math.inf


def detail(texture: Shader, extent: Extent, of_slopes: bool) -> float | None:
    """Metres from one detail of a texture to the next; None where the node does not tell.

    of_slopes: whether it is the slopes of the texture that show, as those of relief do.
    """
    node = texture[0]
    period = _period(texture, of_slopes)
    if period is None or math.isinf(period):
        return None
    scale, unit = _placed(texture, extent)
    if unit is None or not math.isfinite(unit) or scale == 0.0:
        return None
    return 0.0 if node.type == "TEX_WHITE_NOISE" else period * unit / scale


def _period(texture: Shader, of_slopes: bool) -> float | None:
    """Period of a texture in its own coordinates; 0 for white noise."""
    node = texture[0]
    if node.type == "TEX_WHITE_NOISE":
        return 0.0
    if node.type == "TEX_IMAGE":
        return None if node.image is None else image_detail.period(node.image, of_slopes)
    if node.type == "TEX_GRADIENT" or "Scale" not in node.inputs:
        return None
    value = constant(texture, "Scale")
    scale = 0.0 if value is None else float(abs(value[0]))
    if scale == 0.0:
        return None
    if node.type == "TEX_WAVE":
        return 1.0 / (_WAVE * scale)
    if node.type == "TEX_NOISE":
        rough = constant(texture, "Detail")
        return 1.0 / (scale * (_OCTAVE if rough is None or rough[0] >= 1.0 else 1.0))
    return 1.0 / scale


def _placed(texture: Shader, extent: Extent) -> tuple[float, float | None]:
    """How often coordinates repeat in a unit at most, and that unit in metres."""
    node, inside = texture
    usual = extent.uv if node.type == "TEX_IMAGE" else extent.generated
    scale, socket = 1.0, node.inputs.get("Vector")
    for _ in range(64):  # nodes of a chain
        source = None if socket is None else origin(socket, inside)
        if source is None:
            return scale, usual
        node, output, inside = source
        if node.type == "TEX_COORD":
            kinds = {"UV": extent.uv, "Object": extent.object, "Generated": extent.generated}
            return scale, kinds.get(output.name)
        if node.type == "NEW_GEOMETRY":
            return scale, 1.0 if output.name == "Position" else None
        if node.type in ("UVMAP", "ATTRIBUTE"):
            return scale, extent.uv
        scale *= _factor((node, inside))
        vectors = [s for s in node.inputs if s.type == "VECTOR" and origin(s, inside) is not None]
        socket = vectors[0] if vectors else None
        if socket is None:
            return scale, None
    return scale, None


def _factor(step: Shader) -> float:
    """The largest factor by which a node stretches coordinates."""
    node = step[0]
    value: tuple[float, ...] | None = None
    if node.type == "MAPPING":
        value = constant(step, "Scale")
    elif node.type == "VECT_MATH" and node.operation == "SCALE":
        value = constant(step, "Scale")
    elif node.type == "VECT_MATH" and node.operation == "MULTIPLY":
        value = _constant_of_two(step)
    return max(map(abs, value)) if value else 1.0


def _constant_of_two(step: Shader) -> tuple[float, ...] | None:
    """The constant of a product's two inputs."""
    node, inside = step
    for socket in node.inputs[:2]:
        if origin(socket, inside) is None and not socket.is_linked:
            return tuple(socket.default_value)
    return None
