"""Converts the hair of a loaded scene for capture: curves, Chiang's model, round segments."""

import bpy
import numpy as np
from rna_sources import shown_frame

_THINNEST = 0.01  # of the root: a closed tip ends in this, for a package has no radius 0


def prepare_hair(
    materials_with_nodes: list[tuple[bpy.types.Material, list[bpy.types.Node]]],
) -> list[str]:
    """Convert particle hair, and set the model of hair shaders.

    `materials_with_nodes`: pairs of a material and all its nodes. Returns notes for the user.
    """
    notes = []
    for material, nodes in materials_with_nodes:
        for node in nodes:
            if node.type == "BSDF_HAIR_PRINCIPLED" and node.model != "CHIANG":
                notes.append(
                    f"material {material.name!r} uses the hair model {node.model}; it was captured "
                    "with CHIANG, whose strands are round"
                )
                node.model = "CHIANG"
    bpy.context.view_layer.update()
    for emitter in _shown_emitters():
        _convert(emitter)
    return notes


def _shown_emitters() -> list[bpy.types.Object]:
    """Objects with particle hair, in the view layer or shown by instances of their collections."""
    emitters = {}
    for instance in bpy.context.evaluated_depsgraph_get().object_instances:
        item = instance.object.original
        if any(_is_hair(system) for system in item.particle_systems):
            if instance.is_instance and instance.parent.instance_type != "COLLECTION":
                raise ValueError(
                    f"object {item.name!r} has particle hair and is instanced by "
                    f"{instance.parent.name!r}: make these instances real (Ctrl-A) first"
                )
            emitters[item.name_full] = item
    return list(emitters.values())


def _is_hair(system: bpy.types.ParticleSystem) -> bool:
    settings = system.settings
    return bool(settings.type == "HAIR" and settings.render_type == "PATH")


def _convert(emitter: bpy.types.Object) -> None:
    """Replace the particle hair of an object by curves objects, as renders show it.

    They are in the collections that the object is in: its instances have the hair too.
    """
    shown_frame.keep()
    scene, homes = bpy.context.scene.collection, emitter.users_collection
    is_elsewhere = emitter.name_full not in bpy.context.view_layer.objects
    if is_elsewhere:
        scene.objects.link(emitter)
    particles = [m for m in emitter.modifiers if m.type == "PARTICLE_SYSTEM"]
    modifiers = {m.particle_system.name: m for m in particles}
    systems = [s for s in emitter.particle_systems if _is_hair(s)]
    names = [s.name for s in systems]
    shown = [modifiers[name].show_render and not emitter.hide_render for name in names]
    for system in systems:
        _show_as_rendered(system.settings)
    hidden_emitter = not emitter.show_instancer_for_render
    for name, visible in zip(names, shown, strict=True):
        if visible:
            curves = _add_curves_of(emitter, name)
            for home in curves.users_collection:
                home.objects.unlink(curves)
            for home in homes:
                home.objects.link(curves)
    if is_elsewhere:
        scene.objects.unlink(emitter)
    for name in names:
        emitter.modifiers.remove(modifiers[name])
    # An object without particles is no emitter: the switch that hid it means nothing now.
    if hidden_emitter and not emitter.particle_systems:
        emitter.hide_render = emitter.hide_viewport = True


def _show_as_rendered(settings: bpy.types.ParticleSettings) -> None:
    """Makes the viewport's hair, which is all that Python can read, the rendered one."""
    settings.display_method = "RENDER"
    settings.display_percentage = 100
    settings.display_step = settings.render_step
    settings.child_percent = settings.rendered_child_count


def _add_curves_of(emitter: bpy.types.Object, name: str) -> bpy.types.Object:
    settings = emitter.particle_systems[name].settings
    emitter.particle_systems.active_index = emitter.particle_systems.find(name)
    bpy.context.view_layer.update()
    before = set(bpy.data.objects)
    with bpy.context.temp_override(object=emitter, active_object=emitter):
        bpy.ops.curves.convert_from_particle_system()
    made = set(bpy.data.objects) - before
    if len(made) != 1:
        raise ValueError(f"could not convert the particle hair {name!r} of {emitter.name!r}")
    item = made.pop()
    curves = item.data
    _set_radii(curves, settings)
    slot = settings.material - 1
    materials = [s.material for s in emitter.material_slots]
    curves.materials.clear()
    if materials:
        curves.materials.append(materials[min(slot, len(materials) - 1)])
    return item


def _set_radii(curves: bpy.types.Curves, settings: bpy.types.ParticleSettings) -> None:
    """Sets the radii that Cycles uses for particle hair (`shaperadius` in its add-on's source)."""
    root = 0.5 * settings.root_radius * settings.radius_scale
    tip = 0.5 * settings.tip_radius * settings.radius_scale
    offsets = np.empty(len(curves.curves) + 1, np.int32)
    curves.curve_offset_data.foreach_get("value", offsets)
    points = np.empty(3 * len(curves.points), np.float32)
    curves.position_data.foreach_get("vector", points)
    along = _part_of_length(points.reshape(-1, 3), offsets)
    rest, shape = 1.0 - along, settings.shape
    rest = rest ** (1.0 + shape) if shape < 0.0 else rest ** (1.0 / max(1.0 - shape, 1e-6))
    radii = rest * (root - tip) + tip
    if settings.use_close_tip:
        radii[offsets[1:] - 1] = 0.0
    radii = np.maximum(radii, _THINNEST * max(root, tip)).astype(np.float32)
    attribute = curves.attributes.get("radius") or curves.attributes.new("radius", "FLOAT", "POINT")
    attribute.data.foreach_set("value", radii)


def _part_of_length(points: np.ndarray, offsets: np.ndarray) -> np.ndarray:
    """(p,) 0 at each strand's root, 1 at its tip, by length."""
    steps = np.linalg.norm(np.diff(points, axis=0, prepend=points[:1]), axis=1)
    steps[offsets[:-1]] = 0.0
    length = np.cumsum(steps, dtype=np.float64)
    start = np.repeat(length[offsets[:-1]], np.diff(offsets))
    whole = np.repeat(length[offsets[1:] - 1], np.diff(offsets)) - start
    return np.asarray((length - start) / np.maximum(whole, 1e-20))
