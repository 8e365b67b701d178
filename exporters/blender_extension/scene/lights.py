"""Blender's lamps as a scene file's lights, in the units of Cycles."""

import math
import re

from ..axes import vector_from_blender
from .camera import axes_of

_LEAST_RADIUS = 1e-6  # below, Cycles has a point


def describe_light(item, matrix, notes):
    """One entry of `lights`; None for a lamp that gives none.

    item: the lamp's object, evaluated. matrix: where this instance of it stands.
    """
    lamp = item.data
    rgb = _colour(item, lamp, notes)
    if max(rgb) <= 0.0:
        return None
    light = _KINDS[lamp.type](_Placed(item, matrix), lamp, rgb, notes)
    if lamp.type != "SUN" and getattr(lamp, "use_custom_distance", False):
        notes.add("a lamp's custom distance is left out", item.name)
    return _grouped(item, light, notes)


class _Placed:
    """An instance of a lamp, with the members of an object that `axes_of` reads."""

    def __init__(self, item, matrix):
        self.name, self.matrix_world = item.name, matrix
        self.visible_camera = item.visible_camera


def _colour(item, lamp, notes):
    """Linear RGB of the lamp's power: watts, or W/m^2 of a sun."""
    rgb = [c * lamp.energy for c in lamp.color]
    rgb = [c * 2.0 ** getattr(lamp, "exposure", 0.0) for c in rgb]
    if getattr(lamp, "use_temperature", False):
        rgb = [c * t for c, t in zip(rgb, lamp.temperature_color, strict=True)]
    if lamp.node_tree is None or not getattr(lamp, "use_nodes", True):
        return rgb
    emission = [node for node in lamp.node_tree.nodes if node.type == "EMISSION"]
    if len(emission) != 1 or any(socket.is_linked for socket in emission[0].inputs):
        notes.add("the lamp's nodes are left out", item.name)
        return rgb
    strength = emission[0].inputs["Strength"].default_value
    tint = emission[0].inputs["Color"].default_value
    return [c * t * strength for c, t in zip(rgb, tint[:3], strict=True)]


def _grouped(item, light, notes):
    """Adds the light group, under a name that the scene file allows."""
    group = re.sub(r"[^A-Za-z0-9_]", "_", item.lightgroup)
    return {**light, "group": group} if group else light


def _sun(placed, lamp, rgb, notes):
    _, forward, _ = axes_of(placed)
    return {
        "type": "directional",
        "direction": vector_from_blender(-forward),
        "irradiance": rgb,
        "angular_diameter_deg": math.degrees(lamp.angle),
    }


def _point(placed, lamp, rgb, notes):
    radius = lamp.shadow_soft_size
    position = vector_from_blender(placed.matrix_world.translation)
    if radius <= _LEAST_RADIUS:
        intensity = [c / (4.0 * math.pi) for c in rgb]
        return {"type": "point", "position": position, "intensity": intensity}
    # A sphere of this power: 4 pi r^2 of surface, each part of it pi times its radiance.
    area = 4.0 * math.pi * radius**2 if _is_normalised(lamp) else 4.0
    return {
        "type": "sphere",
        "position": position,
        "radius": radius,
        "radiance": [c / (math.pi * area) for c in rgb],
        "visible_to_camera": placed.visible_camera,
    }


def _spot(placed, lamp, rgb, notes):
    if lamp.shadow_soft_size > _LEAST_RADIUS:
        notes.add("a spot's radius is left out: its shadows are sharp", placed.name)
    if lamp.use_square:
        notes.add("a spot's square cone is rendered as a round one", placed.name)
    position, forward, _ = axes_of(placed)
    outer = lamp.spot_size / 2.0
    if outer > math.pi / 2.0:
        notes.add("a spot's cone is at most 180 degrees wide", placed.name)
        outer = math.pi / 2.0
    # Blender's blend is a share of the cosine's range.
    inner = math.acos(math.cos(outer) + lamp.spot_blend * (1.0 - math.cos(outer)))
    return {
        "type": "spot",
        "position": vector_from_blender(position),
        "look_at": vector_from_blender(position + forward),
        "intensity": [c / (4.0 * math.pi) for c in rgb],
        "outer_angle_deg": math.degrees(outer),
        "inner_angle_deg": math.degrees(min(inner, outer)),
    }


def _area(placed, lamp, rgb, notes):
    position, forward, up = axes_of(placed)
    scale = placed.matrix_world.to_scale()
    across = lamp.size * abs(scale.x)
    is_long = lamp.shape in ("RECTANGLE", "ELLIPSE")
    along = (lamp.size_y if is_long else lamp.size) * abs(scale.y)
    is_round = lamp.shape in ("DISK", "ELLIPSE")
    area = across * along * (math.pi / 4.0 if is_round else 1.0)
    if getattr(lamp, "spread", math.pi) < math.pi - 1e-3:
        notes.add("an area lamp's spread is left out: it shines to all sides", placed.name)
    if is_round and abs(across - along) > 1e-4 * across:
        notes.add("an elliptic lamp is rendered as a disk of its area", placed.name)
    light = {
        "type": "disk" if is_round else "rectangle",
        "position": vector_from_blender(position),
        "look_at": vector_from_blender(position + forward),
        "radiance": [c / (math.pi * (area if _is_normalised(lamp) else 1.0)) for c in rgb],
        "visible_to_camera": placed.visible_camera,
    }
    if is_round:
        return {**light, "radius": math.sqrt(area / math.pi)}
    return {**light, "up": vector_from_blender(up), "size": [across, along]}


def _is_normalised(lamp):
    """Whether the power stays as it is when the lamp grows."""
    return getattr(lamp, "normalize", True)


_KINDS = {"SUN": _sun, "POINT": _point, "SPOT": _spot, "AREA": _area}
