"""Renders individual rays with stock Cycles, under one sun or by the asset's emission."""

from pathlib import Path
from typing import Any

import bpy
import mathutils
from rna_geometry import shown_objects
from rna_geometry.shown_objects import as_rendered
from rna_materials.emission import Emission
from rna_renders import white_world
from rna_sources import bundled

_LOBES = ("diffuse", "glossy", "transmission")
_NEAR = 1e-6  # the least that Blender allows; the ray camera takes it back
_FAR = 1e12

SUN = "rna sun"

_CLIP_START, _SPREAD = 0.25, 1e-3
"""Clip start of the ray camera, of the asset's longest side, and the angle between its pixels, rad.

Together they make rays at least as wide as pixels of a usual picture: see `ray_camera.osl`.
"""

_lighting: dict[str, Any] = {}
"""emission: of the materials. clamps: of radiance under the sun. near: the rays' clip start, m.

black, white: worlds.
"""


def configure(
    threads: int, clamp_direct: float, clamp_indirect: float, separate_direct: bool
) -> list[str]:
    """Cycles as a teacher, once `render_settings` are ours: no clamping but the named one.

    `separate_direct` adds the passes that tell direct light from scattered light. Returns the names
    of the materials that emit light, which is switched on only for renders without the sun.
    """
    scene, layer = bpy.context.scene, bpy.context.view_layer
    scene.render.threads = threads
    for lobe in _LOBES:
        setattr(layer, f"use_pass_{lobe}_direct", separate_direct)
        setattr(layer, f"use_pass_{lobe}_color", separate_direct)
    sun = bpy.data.lights.new(SUN, "SUN")
    sun.energy, sun.angle = 1.0, 0.0
    lamp = bpy.data.objects.new(SUN, sun)
    lamp.rotation_mode = "QUATERNION"
    scene.collection.objects.link(lamp)
    emission = Emission()
    near = max(_CLIP_START * as_rendered(shown_objects.longest_side), _NEAR)
    _lighting.update(
        emission=emission,
        clamps=(clamp_direct, clamp_indirect),
        near=near,
        black=scene.world,
        white=white_world.new(),
    )
    return list(emission.materials)


def render_rays(request: dict[str, Any]) -> None:
    """Trace the rays of two images; writes a multilayer EXR with `Combined` and `Position`.

    With `normals`, it has `Normal` too. A ray ends `reach` from its origin, if that is given.
    """
    camera = _camera("rays", "CUSTOM")
    if not camera.custom_bytecode:
        _compile_ray_camera(camera)
    camera.cycles_custom["origins"] = request["origins"]
    camera.cycles_custom["directions"] = request["directions"]
    _sample(centres=True)
    bpy.context.view_layer.use_pass_normal = request["normals"]
    near = camera.clip_start = _lighting["near"]
    values = {"near": near, "spread": _SPREAD, "columns": request["width"]}
    for name, value in {**values, "rows": request["height"]}.items():
        camera.cycles_custom[name] = float(value)
    camera.clip_end = _FAR if request["reach"] is None else near + request["reach"]
    camera.update_tag()
    light(request["light"])
    _render(request)


def render_view(request: dict[str, Any]) -> None:
    """Render an ordinary pinhole image, lit from `wi`, and by the asset itself if it `emits`.

    `points`: whether pixels are points. `normals`: whether the file has `Normal`.
    """
    light(request["light"])
    emit(request["emits"])
    bpy.context.view_layer.use_pass_normal = request["normals"]
    render_pinhole(request, request["points"])


def render_pinhole(request: dict[str, Any], centres: bool = False) -> None:
    """Render an image of the scene as it is: `matrix` is camera to world, Blender's axes."""
    camera = _camera("view", "PERSP")
    camera.sensor_fit = "VERTICAL"
    camera.angle = request["fovY"]
    bpy.context.scene.camera.matrix_world = mathutils.Matrix(request["matrix"])
    _sample(centres)
    _render(request)


def _sample(centres: bool) -> None:
    """Spread the samples of a pixel over all of it, or take them at its centre."""
    cycles = bpy.context.scene.cycles
    # Cycles ignores the width of a box.
    cycles.pixel_filter_type, cycles.filter_width = ("GAUSSIAN", 0.01) if centres else ("BOX", 1.0)


def emit(on: bool) -> None:
    """Let the materials emit light, or not."""
    _lighting["emission"].switch(on)


def light(asked: dict[str, list[Any]]) -> None:
    """The sun in a direction, a white world, or, of neither, the asset's own light alone.

    Paths of the sun alone are clamped. asked: `sun`: towards it. `white`: cones that the world's
    light comes from, as [x, y, z, least cosine]; none for all directions.
    """
    cycles, sun = bpy.context.scene.cycles, bpy.data.objects[SUN]
    emit(not asked)
    sun.hide_render = "sun" not in asked
    world = _lighting["white"] if "white" in asked else _lighting["black"]
    if bpy.context.scene.world != world:
        bpy.context.scene.world = world
    clamps = _lighting["clamps"] if "sun" in asked else (0.0, 0.0)
    cycles.sample_clamp_direct, cycles.sample_clamp_indirect = clamps
    if "sun" in asked:
        sun.rotation_quaternion = mathutils.Vector(asked["sun"]).to_track_quat("Z", "Y")
    if "white" in asked:
        white_world.shine_from(_lighting["white"], asked["white"])


def _render(request: dict[str, Any]) -> None:
    scene = bpy.context.scene
    scene.cycles.samples = request["samples"]
    scene.cycles.seed = request["seed"] & 0x7FFFFFFF
    scene.render.resolution_x, scene.render.resolution_y = request["width"], request["height"]
    scene.render.filepath = request["out"]
    bpy.ops.render.render(write_still=True)


def _camera(name: str, kind: str) -> bpy.types.Camera:
    scene = bpy.context.scene
    name = f"rna {name}"
    if name not in bpy.data.objects:
        data = bpy.data.cameras.new(name)
        data.type = kind
        data.clip_start, data.clip_end = _NEAR, _FAR
        scene.collection.objects.link(bpy.data.objects.new(name, data))
    scene.camera = bpy.data.objects[name]
    return scene.camera.data


def _compile_ray_camera(camera: bpy.types.Camera) -> None:
    bundled.add_to_path()
    from cycles import osl

    text = bpy.data.texts.new("ray_camera.osl")
    text.write((Path(__file__).parent / "ray_camera.osl").read_text())
    camera.custom_mode, camera.custom_shader = "INTERNAL", text
    problems = []
    osl.update_custom_camera_shader(camera, lambda kind, message: problems.append((kind, message)))
    errors = [message for kind, message in problems if "ERROR" in kind]
    if errors or not camera.custom_bytecode:
        raise RuntimeError(f"the ray camera did not compile: {errors}")
