"""Blender's world as a scene file's environment."""

import math
import re

from .images import save_environment


def describe_world(scene, folder, notes):
    """The entries of `lights` for the world: none or one.

    folder: where images go that rna-run cannot read as they are.
    """
    world = scene.world
    if world is None:
        return []
    light = {"type": "environment", **_light_of(world, folder, notes)}
    if max(light["radiance"]) <= 0.0 and scene.render.film_transparent:
        return []
    if getattr(world, "lightgroup", ""):
        light["group"] = re.sub(r"[^A-Za-z0-9_]", "_", world.lightgroup)
    return [{**light, "visible_to_camera": not scene.render.film_transparent}]


def _light_of(world, folder, notes):
    tree = world.node_tree if getattr(world, "use_nodes", True) else None
    if tree is None:
        return {"radiance": list(world.color)}
    output = tree.get_output_node("CYCLES") or tree.get_output_node("ALL")
    surface = output.inputs["Surface"] if output is not None else None
    if surface is None or not surface.is_linked:
        return {"radiance": [0.0, 0.0, 0.0]}
    if output.inputs["Volume"].is_linked:
        notes.add("the world's volume is left out")
    node = surface.links[0].from_node
    if node.type != "BACKGROUND" or node.inputs["Strength"].is_linked:
        notes.add(f"the world's node {node.name!r} is rendered as black")
        return {"radiance": [0.0, 0.0, 0.0]}
    strength = node.inputs["Strength"].default_value
    colour = node.inputs["Color"]
    if not colour.is_linked:
        return {"radiance": [c * strength for c in colour.default_value[:3]]}
    return _image_light(colour.links[0].from_node, strength, folder, notes)


def _image_light(node, strength, folder, notes):
    usable = node.type == "TEX_ENVIRONMENT" and node.projection == "EQUIRECTANGULAR"
    if not usable or node.image is None:
        notes.add(f"the world's node {node.name!r} is rendered as black")
        return {"radiance": [0.0, 0.0, 0.0]}
    # The middle of Blender's image lies towards +x, of a scene file's image towards Blender's +y.
    turn = _turn(node.inputs["Vector"], notes) - math.pi / 2.0
    return {
        "radiance": [strength] * 3,
        "path": save_environment(node.image, folder, notes),
        "rotation_deg": math.degrees(turn),
    }


def _turn(socket, notes):
    """Rotation of the image about Blender's +z, the inverse of the mapping node's rotation."""
    if not socket.is_linked:
        return 0.0
    node = socket.links[0].from_node
    if node.type == "MAPPING":
        turn = node.inputs["Rotation"].default_value
        plain = not any(node.inputs[n].is_linked for n in ("Location", "Rotation", "Scale"))
        same = all(abs(s - 1.0) < 1e-6 for s in node.inputs["Scale"].default_value)
        moved = max(abs(v) for v in (*node.inputs["Location"].default_value, turn[0], turn[1]))
        if not plain or not same or moved > 1e-6 or node.vector_type not in ("POINT", "VECTOR"):
            notes.add("the world's mapping is rendered as a turn about the vertical alone")
        return -turn[2]
    if node.type != "TEX_COORD":
        notes.add(f"the world's node {node.name!r} is left out")
    return 0.0
