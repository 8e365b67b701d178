"""A capture owns its render settings, whatever the file's are."""

import numpy as np
import pytest

from tests.exporters.blender_settings import HARMLESS, OF_THE_ASSET, known
from tests.exporters.cycles import unit
from tests.exporters.in_blender import answer_of
from tests.exporters.scenes import ball

pytestmark = pytest.mark.blender

# Every owned property is given another value; then all properties are listed.
SPOILT = """
from rna_renders import render_settings
scene, layer = bpy.context.scene, bpy.context.view_layer

def other(owner, name, value):
    prop = owner.bl_rna.properties[name]
    if prop.type == "BOOLEAN":
        return not value
    if prop.type == "ENUM":
        return next((i.identifier for i in prop.enum_items if i.identifier != value), value)
    if prop.type == "POINTER":
        return bpy.data.worlds.new("bright")
    return prop.hard_max if value != prop.hard_max else prop.hard_min

spoilt = []
for owner in reversed(render_settings.owners(scene, layer)):
    for name, value in render_settings.OWNED[owner.bl_rna.identifier].items():
        try:
            setattr(owner, name, other(owner, name, value))
        except TypeError:  # an engine or a format that this machine lacks
            continue
        if getattr(owner, name) != value:
            spoilt.append(name)
scene.view_layers.new("second")
layer.aovs.add().name = "Position"
layer.use_pass_cryptomatte_object = layer.use_pass_mist = True
bpy.ops.wm.set_working_color_space(working_space="ACEScg", convert_colors=True)
render_settings.apply()

def same(a, b):
    return abs(a - b) < 1e-6 if isinstance(b, float) else a == b

owners = render_settings.owners(scene, layer)
wrong = [
    f"{owner.bl_rna.identifier}.{name}"
    for owner in owners
    for name, value in render_settings.OWNED[owner.bl_rna.identifier].items()
    if not same(getattr(owner, name), value)
]
item = bpy.data.objects.new("item", bpy.data.meshes.new("mesh"))
material = bpy.data.materials.new("material")
structs = [
    scene, *owners, layer.layer_collection, item, item.cycles, material, material.cycles,
    scene.view_settings, scene.display_settings,
]
general = {p.identifier for p in bpy.types.ID.bl_rna.properties} | {"name"}
answer({
    "spoilt": spoilt,
    "wrong": wrong,
    "layers": len(scene.view_layers),
    "aovs": len(layer.aovs),
    "passes": [p.identifier for p in layer.bl_rna.properties
               if p.identifier.startswith("use_pass_") and getattr(layer, p.identifier)],
    "space": bpy.data.colorspace.working_space,
    "owned": {kind: list(values) for kind, values in render_settings.OWNED.items()},
    "properties": {s.bl_rna.identifier: [p.identifier for p in s.bl_rna.properties
                                         if p.identifier not in general] for s in structs},
})
"""

PLAIN = (
    ball()
    + """
add(*BALL, principled(Base_Color=(0.8, 0.3, 0.1, 1.0)), smooth=True)
"""
)
# What changed a capture, or might.
SET_UP_FOR_A_FILM = (
    PLAIN
    + """
scene, layer = bpy.context.scene, bpy.context.view_layer
render, cycles = scene.render, scene.cycles
render.engine = "CYCLES"
cycles.film_exposure, cycles.film_transparent_glass = 4.0, True
cycles.use_sample_subset, cycles.sample_offset, cycles.sample_subset_length = True, 2, 1
cycles.time_limit, cycles.scrambling_distance = 1e-3, 0.1
cycles.use_camera_cull = cycles.use_distance_cull = True
cycles.distance_cull_margin = 0.01
render.use_simplify, cycles.texture_limit_render = True, "128"
render.use_multiview = render.use_border = render.use_stamp = render.use_freestyle = True
render.border_max_x = 0.5
render.image_settings.file_format = "JPEG"
scene.view_settings.exposure = 3.0
scene.background_set = bpy.data.scenes.new("set")
item = scene.objects[0]
item.cycles.use_camera_cull = item.cycles.use_distance_cull = True
world = bpy.data.worlds.new("bright")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs["Strength"].default_value = 5.0
layer.world_override = world
layer.use, layer.use_solid, layer.samples = False, False, 1
held = bpy.data.collections.new("held")
scene.collection.children.link(held)
held.objects.link(item)
scene.collection.objects.unlink(item)
scene.view_layers.new("second").layer_collection.children["held"].exclude = True
"""
)


def test_every_property_of_a_render_is_set_or_known_to_be_harmless(blender_python):
    actual = answer_of(blender_python, SPOILT)
    assert len(actual["spoilt"]) > 45
    assert actual["wrong"] == []
    assert (actual["layers"], actual["aovs"]) == (1, 0)
    accurate = "use_pass_cryptomatte_accurate"  # how, not whether
    assert {*actual["passes"]} == {"use_pass_combined", "use_pass_position", accurate}
    assert actual["space"] == "Linear Rec.709"
    for kind, properties in actual["properties"].items():
        listed = known(kind) | set(actual["owned"].get(kind, ()))
        passes = {name for name in properties if name.startswith(("use_pass_", "pass_", "denoi"))}
        new = set(properties) - listed - passes
        assert not new, f"decide on {kind}: {', '.join(sorted(new))}"
        assert listed <= set(properties), f"{kind} has no {sorted(listed - set(properties))}"
    for kind, owned in actual["owned"].items():
        twice = set(owned) & {*HARMLESS.get(kind, "").split(), *OF_THE_ASSET.get(kind, "").split()}
        assert not twice, f"{kind}: {twice} is owned, and listed as not"


def test_a_file_set_up_for_a_film_gives_the_radiance_of_a_plain_one(
    open_worker,
):
    rng = np.random.default_rng(3)
    towards = rng.normal(size=(64, 3))
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    rays = np.float32(3.0 * towards), np.float32(-towards)
    workers = [open_worker(scene) for scene in (PLAIN, SET_UP_FOR_A_FILM)]
    plain, film = (worker.render_rays(*rays, unit(0.3, 0.9, 0.3), 4, seed=1) for worker in workers)
    assert [worker.render_card() for worker in workers] == pytest.approx([1.0 / np.pi] * 2)
    assert plain.alpha.min() == 1.0
    assert plain.radiance.max() > 0.1
    assert np.array_equal(film.alpha, plain.alpha)
    assert np.array_equal(film.radiance, plain.radiance)
    assert np.array_equal(film.position, plain.position)
