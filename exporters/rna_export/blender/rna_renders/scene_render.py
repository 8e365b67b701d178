"""Renders the asset in a scene with other objects and lights.

The scene comes as JSON in Blender's axes, metres and linear colours; lights as docs/scene.md
describes them. Units of Blender's lamps stand here and nowhere else.
"""

import math
from collections.abc import Sequence
from typing import Any

import bpy
import mathutils
from rna_renders import ray_render

_BOUNCES = ("max_bounces", "diffuse_bounces", "glossy_bounces", "transmission_bounces")


class _State:
    """The objects that were added to the Blender file, and the scene it currently shows."""

    def __init__(self) -> None:
        scene = bpy.context.scene
        bpy.data.objects.remove(bpy.data.objects[ray_render.SUN], do_unlink=True)
        bpy.context.view_layer.update()
        scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0.0
        # Not what collection instances alone show: it goes where they go.
        shown = bpy.context.view_layer.objects
        self.asset = [item for item in shown if item.type != "CAMERA"]
        self.hidden = [item.hide_render for item in self.asset]
        self.handle = bpy.data.objects.new("rna asset", None)
        scene.collection.objects.link(self.handle)
        for item in self.asset:
            if item.parent is None:
                # Without an inverse the handle's matrix goes before the object's own.
                item.parent = self.handle
        self.instanced = bpy.data.collections.new("rna instanced")
        for item in self.asset:
            self.instanced.objects.link(item)
        self.collection = bpy.data.collections.new("rna scene")
        scene.collection.children.link(self.collection)
        self.bounces = {name: getattr(scene.cycles, name) for name in _BOUNCES}
        self.shown: dict[str, Any] | None = None


_state: _State | None = None


def render_scene(request: dict[str, Any]) -> None:
    """Write a multilayer EXR of `scene`, seen as by `ray_render.render_view`, denoised or not."""
    global _state
    if _state is None:
        _state = _State()
    if request["scene"] != _state.shown:
        _build(_state, request["scene"])
    cycles = bpy.context.scene.cycles
    cycles.denoiser, cycles.use_denoising = "OPENIMAGEDENOISE", request["denoise"]
    ray_render.emit(False)
    ray_render.render_pinhole(request)


def _build(state: _State, described: dict[str, Any]) -> None:
    state.shown = None
    _clear(state.collection)
    _show_assets(state, described["assets"])
    for mesh in described["meshes"]:
        _add_mesh(state.collection, mesh)
    environments = [light for light in described["lights"] if light["type"] == "environment"]
    for light in described["lights"]:
        if light["type"] != "environment":
            _add_lamp(state.collection, light)
    _set_world(environments)
    bounces = described["bounces"]
    for name, of_source in state.bounces.items():
        setattr(bpy.context.scene.cycles, name, of_source if bounces is None else bounces)
    state.shown = described


def _clear(collection: bpy.types.Collection) -> None:
    for item in list(collection.objects):
        data = item.data
        bpy.data.objects.remove(item, do_unlink=True)
        if data is None:  # an instance
            continue
        (bpy.data.meshes if isinstance(data, bpy.types.Mesh) else bpy.data.lights).remove(data)


def _show_assets(state: _State, matrices: list[list[list[float]]]) -> None:
    """Place instances of the asset by 4 x 4 matrices; hide it if there are none."""
    for item, hidden in zip(state.asset, state.hidden, strict=True):
        item.hide_render = hidden or not matrices
    if not matrices:
        return
    first, *others = (mathutils.Matrix(matrix) for matrix in matrices)
    state.handle.matrix_world = first
    for matrix in others:
        instance = bpy.data.objects.new("rna instance", None)
        instance.instance_type = "COLLECTION"
        instance.instance_collection = state.instanced
        # The collection is where the handle has put it.
        instance.matrix_world = matrix @ first.inverted()
        state.collection.objects.link(instance)


def _add_mesh(collection: bpy.types.Collection, described: dict[str, Any]) -> None:
    mesh = bpy.data.meshes.new("rna mesh")
    mesh.from_pydata(described["positions"], [], described["triangles"])
    material = bpy.data.materials.new("rna diffuse")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (*described["color"], 1.0)
    shader.inputs["Roughness"].default_value = 0.0  # Lambert's
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    mesh.materials.append(material)
    collection.objects.link(bpy.data.objects.new("rna mesh", mesh))


def _add_lamp(collection: bpy.types.Collection, described: dict[str, Any]) -> None:
    lamp = bpy.data.lights.new("rna lamp", _LAMPS[described["type"]])
    item = bpy.data.objects.new("rna lamp", lamp)
    _SETTERS[described["type"]](lamp, item, described)
    item.visible_camera = described.get("visible_to_camera", False)
    collection.objects.link(item)


def _set_strength(lamp: bpy.types.Light, rgb: list[float], watts: float) -> None:
    """`watts` of energy for each unit of what `rgb` measures."""
    greatest = max(rgb)
    lamp.color = [value / greatest for value in rgb] if greatest else (0.0, 0.0, 0.0)
    lamp.energy = greatest * watts


def _set_sun(lamp: bpy.types.Light, item: bpy.types.Object, described: dict[str, Any]) -> None:
    _set_strength(lamp, described["irradiance"], 1.0)
    lamp.angle = math.radians(described["angular_diameter_deg"])
    item.matrix_world = _facing(-mathutils.Vector(described["direction"]))


def _set_point(lamp: bpy.types.Light, item: bpy.types.Object, described: dict[str, Any]) -> None:
    _set_strength(lamp, described["intensity"], 4.0 * math.pi)
    lamp.shadow_soft_size = 0.0
    item.matrix_world = mathutils.Matrix.Translation(described["position"])


def _set_spot(lamp: bpy.types.Light, item: bpy.types.Object, described: dict[str, Any]) -> None:
    _set_point(lamp, item, described)
    inner, outer = (math.cos(math.radians(described[f"{s}_angle_deg"])) for s in ("inner", "outer"))
    lamp.spot_size = 2.0 * math.radians(described["outer_angle_deg"])
    lamp.spot_blend = (inner - outer) / (1.0 - outer)
    _aim(item, described, (0.0, 0.0, 1.0))


def _set_rectangle(
    lamp: bpy.types.Light, item: bpy.types.Object, described: dict[str, Any]
) -> None:
    lamp.shape = "RECTANGLE"
    lamp.size, lamp.size_y = described["size"]
    _set_strength(lamp, described["radiance"], math.pi * lamp.size * lamp.size_y)
    _aim(item, described, described["up"])


def _set_disk(lamp: bpy.types.Light, item: bpy.types.Object, described: dict[str, Any]) -> None:
    lamp.shape = "DISK"
    lamp.size = 2.0 * described["radius"]
    _set_strength(lamp, described["radiance"], math.pi**2 * described["radius"] ** 2)
    _aim(item, described, (0.0, 0.0, 1.0))


_SETTERS = {
    "directional": _set_sun,
    "point": _set_point,
    "spot": _set_spot,
    "rectangle": _set_rectangle,
    "disk": _set_disk,
}
_LAMPS = {
    "directional": "SUN",
    "point": "POINT",
    "spot": "SPOT",
    "rectangle": "AREA",
    "disk": "AREA",
}


def _aim(item: bpy.types.Object, described: dict[str, Any], up: Sequence[float]) -> None:
    position = mathutils.Vector(described["position"])
    turn = _facing(mathutils.Vector(described["look_at"]) - position, up)
    item.matrix_world = mathutils.Matrix.Translation(position) @ turn


def _facing(forward: mathutils.Vector, up: Sequence[float] = (0.0, 0.0, 1.0)) -> mathutils.Matrix:
    """A lamp shines along its -z; its y goes towards `up`."""
    backward = -forward.normalized()
    right = mathutils.Vector(up).cross(backward)
    if right.length < 1e-6:
        right = backward.orthogonal()
    right.normalize()
    return mathutils.Matrix([right, backward.cross(right), backward]).transposed().to_4x4()


def _set_world(environments: list[dict[str, Any]]) -> None:
    """One environment at most; black without."""
    if len(environments) > 1:
        raise ValueError("Blender has one world: found several environments, expected one")
    scene = bpy.context.scene
    old = scene.world
    scene.world = world = bpy.data.worlds.new("rna world")
    bpy.data.worlds.remove(old)
    world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    scene.render.film_transparent = True
    if not environments:
        return
    described = environments[0]
    scene.render.film_transparent = not described["visible_to_camera"]
    background = tree.nodes.new("ShaderNodeBackground")
    background.inputs["Color"].default_value = (*described["radiance"], 1.0)
    if described["path"] is not None:
        tree.links.new(_scaled_image(tree, described), background.inputs["Color"])
    output = tree.nodes.new("ShaderNodeOutputWorld")
    tree.links.new(background.outputs[0], output.inputs["Surface"])


def _scaled_image(tree: bpy.types.NodeTree, described: dict[str, Any]) -> bpy.types.NodeSocket:
    """The image's radiance times the described one, as a socket.

    Blender has the middle of an image towards +x, and goes clockwise, seen from above, to its
    right. In our scenes the middle is towards -z, which is Blender's +y: a quarter turn
    counter-clockwise. The mapping turns the direction that is looked up, so it turns back.
    """
    coordinate = tree.nodes.new("ShaderNodeTexCoord")
    mapping = tree.nodes.new("ShaderNodeMapping")
    mapping.vector_type = "POINT"
    turn = math.radians(90.0 + described["rotation_deg"])
    mapping.inputs["Rotation"].default_value = (0.0, 0.0, -turn)
    texture = tree.nodes.new("ShaderNodeTexEnvironment")
    image = bpy.data.images.load(described["path"], check_existing=True)
    image.colorspace_settings.name = "Linear Rec.709"
    image.use_half_precision = False  # a sun is brighter than that
    texture.image = image
    tree.links.new(coordinate.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs["Vector"], texture.inputs["Vector"])
    scale = tree.nodes.new("ShaderNodeVectorMath")
    scale.operation = "MULTIPLY"
    scale.inputs[1].default_value = described["radiance"]
    tree.links.new(texture.outputs["Color"], scale.inputs[0])
    return scale.outputs["Vector"]
