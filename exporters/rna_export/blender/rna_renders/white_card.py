"""A white card under the capture's sun, whose radiance is known: 1 / pi."""

from typing import Any

import bpy
from rna_renders import ray_render

_AWAY = 3.0  # metres, of the camera
_NAME = "rna card"


def render_card(request: dict[str, Any]) -> None:
    """Render a diffuse card of albedo 1 that faces the sun, with the settings of the scene.

    It is in a scene of its own, which has the settings and the sun, and is removed again.
    """
    ray_render.light({"sun": [0.0, 0.0, 1.0]})
    scene = bpy.context.scene.copy()
    card, camera = _card(), _camera()
    try:
        for collection in list(scene.collection.children):
            scene.collection.children.unlink(collection)
        for item in list(scene.collection.objects):
            if item.name != ray_render.SUN:
                scene.collection.objects.unlink(item)
        for item in (card, camera):
            scene.collection.objects.link(item)
        scene.camera = camera
        scene.render.resolution_x = scene.render.resolution_y = request["side"]
        scene.render.filepath = request["out"]
        scene.cycles.samples = 1
        bpy.ops.render.render(write_still=True, scene=scene.name)
    finally:
        bpy.data.scenes.remove(scene)
        bpy.data.materials.remove(card.data.materials[0])
        bpy.data.meshes.remove(card.data)  # and its object
        bpy.data.cameras.remove(camera.data)


def _card() -> bpy.types.Object:
    mesh = bpy.data.meshes.new(_NAME)
    corners = [(-_AWAY, -_AWAY), (_AWAY, -_AWAY), (_AWAY, _AWAY), (-_AWAY, _AWAY)]
    mesh.from_pydata([(*corner, 0.0) for corner in corners], [], [(0, 1, 2, 3)])
    material = bpy.data.materials.new(_NAME)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    mesh.materials.append(material)
    return bpy.data.objects.new(_NAME, mesh)


def _camera() -> bpy.types.Object:
    camera = bpy.data.objects.new(_NAME, bpy.data.cameras.new(_NAME))
    camera.location = (0.0, 0.0, _AWAY)  # it looks along -z
    return camera
