"""Every kind of source with hair loads, and its hair is what Cycles will render."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import OpenEXR
import pytest

from rna_export.blender.rna_hair import Strands, write_hair
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.rays.asset_scene import AssetScene
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves
from tests.exporters.test_hair_files import tfx_bytes

pytestmark = pytest.mark.blender

Save = Callable[..., Path]

# Two strands, of 2 and 3 points.
HAIR = """
def node(material):
    return next(n for n in material.node_tree.nodes if n.type == "BSDF_HAIR_PRINCIPLED")

def hair_material():
    material = bpy.data.materials.new("hair")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfHairPrincipled")
    shader.model = "CHIANG"
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    return material

material = hair_material()
data = bpy.data.hair_curves.new("wig")
data.add_curves([2, 3])
data.position_data.foreach_set("vector", [0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 1, -1, 2])
radius = data.attributes.new("radius", "FLOAT", "POINT")
radius.data.foreach_set("value", [0.1, 0.05, 0.1, 0.08, 0.05])
data.materials.append(material)
wig = bpy.data.objects.new("wig", data)
wig.location = (0, 0, 1)
bpy.context.scene.collection.objects.link(wig)
"""

# 20 hairs on a ball that is not rendered itself; the viewport would show less of them.
PARTICLES = """
item = add(*BALL, principled())
item.name = "emitter"
item.location, item.scale = (1, 2, 3), (2, 2, 2)
item.show_instancer_for_render = False
item.modifiers.new("fur", "PARTICLE_SYSTEM")
fur = item.particle_systems[0].settings
fur.type, fur.count, fur.hair_length = "HAIR", 20, 0.5
fur.child_type, fur.rendered_child_count, fur.child_percent = CHILDREN, 7, 2
fur.render_step, fur.display_step, fur.display_percentage = 4, 2, 50
fur.root_radius, fur.tip_radius, fur.radius_scale, fur.shape = 0.8, 0.2, 0.05, 0.3
fur.use_close_tip = False
"""


@pytest.fixture
def save(tmp_path, save_blend):
    """The .blend file of a scene given as the text of a script."""
    return partial(save_blend, tmp_path / "saved.blend")


def groom() -> Strands:
    points = np.float32([[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 2], [1, 2, 3]])
    return Strands(points, np.float32([0.2, 0.1, 0.2, 0.15, 0.1]), np.array([0, 2, 5]))


def lengths(curves: Curves) -> list[int]:
    return np.diff(curves.offsets.astype(np.int64)).tolist()


def test_hair_file(open_worker, tmp_path):
    write_hair(tmp_path / "a.hair", groom())
    worker = open_worker(tmp_path / "a.hair", "--unit", "2")
    curves = worker.export_curves()
    assert worker.kind == "fiber" and worker.opened["notes"] == []
    assert np.allclose(curves.points, 2 * groom().points, atol=1e-6)
    assert np.allclose(curves.radii, 2 * groom().radii)
    assert lengths(curves) == [2, 3]


def test_arguments_set_radius_and_number_of_strands(open_worker, tmp_path):
    write_hair(tmp_path / "a.hair", groom())
    options = "--radius 0.3 --tip 0.5 --points 4 --strands 10 --melanin 0.1".split()
    curves = open_worker(tmp_path / "a.hair", *options).export_curves()
    assert lengths(curves) == [4] * 10
    assert np.allclose(curves.radii.reshape(10, 4)[:, [0, 3]], [0.3, 0.15])


def test_tfx_file(open_worker, tmp_path):
    (tmp_path / "a.tfx").write_bytes(tfx_bytes())
    curves = open_worker(tmp_path / "a.tfx").export_curves()
    expected = 0.01 * np.arange(18).reshape(6, 3) * [1, 1, -1]
    assert np.allclose(curves.points, expected, atol=1e-7)
    root = 0.01 * 15 * np.sqrt(3) / 2 / 2000
    assert np.allclose(curves.radii[[0, 2, 3, 5]], [root, 0.3 * root, root, 0.3 * root])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ("--melanin 2", "--melanin: found 2, expected 0 to 1"),
        ("--radius 0", "--radius: found 0"),
        ("--colour 1", "expected 3 arguments"),
    ],
)
def test_bad_arguments_are_named(options, message, open_worker, tmp_path):
    (tmp_path / "a.tfx").write_bytes(tfx_bytes())
    with pytest.raises(CaptureError, match=message):
        open_worker(tmp_path / "a.tfx", *options.split())


def test_a_script_that_refuses_its_arguments_is_quoted(open_worker):
    script = "import argparse\nargparse.ArgumentParser().parse_args()"
    with pytest.raises(CaptureError, match="unrecognized arguments: --what"):
        open_worker(script, "--what")


def test_blend_with_hair_curves(save, open_worker):
    worker = open_worker(save(HAIR))
    curves = worker.export_curves()
    assert worker.kind == "fiber"
    assert np.allclose(curves.points, [[0, 1, 0], [0, 2, 0], [1, 1, 0], [1, 2, 0], [1, 3, 1]])
    assert np.allclose(curves.radii, [0.1, 0.05, 0.1, 0.08, 0.05])
    assert lengths(curves) == [2, 3]


def test_huang_becomes_chiang_with_a_note(save, open_worker):
    body = HAIR + "node(material).model = 'HUANG'\n"
    notes = open_worker(save(body)).opened["notes"]
    assert len(notes) == 1 and "HUANG" in notes[0] and "'hair'" in notes[0]
    assert open_worker(HAIR).opened["notes"] == []


@pytest.mark.parametrize(
    ("children", "strands"), [("NONE", 20), ("SIMPLE", 140), ("INTERPOLATED", 140)]
)
def test_particle_hair_is_as_renders_show_it(children, strands, save, open_worker):
    worker = open_worker(save(f"CHILDREN = {children!r}\n{PARTICLES}"))
    curves = worker.export_curves()
    assert worker.kind == "fiber"
    assert lengths(curves) == [17] * strands  # 2 to the power of the render steps, and 1
    radii = curves.radii.reshape(strands, 17)
    assert np.allclose(radii[:, 0], 0.04)  # half the width; the object is scaled by 2
    assert np.all(np.diff(radii, axis=1) < 0.0) and np.allclose(radii[:, -1], 0.01)


RENDER = """
scene = bpy.context.scene
scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = "CYCLES", 1, False
scene.cycles_curves.shape = "THICK_LINEAR"
scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BOX", 0.01
scene.render.film_transparent = True
scene.render.resolution_x = scene.render.resolution_y = 160
scene.render.image_settings.file_format = "OPEN_EXR"
camera = bpy.data.cameras.new("camera")
camera.type, camera.ortho_scale = "ORTHO", 8.0
view = bpy.data.objects.new("view", camera)
view.location, view.rotation_euler = (1, -8, 3), (1.5707963, 0, 0)
scene.collection.objects.link(view)
scene.camera = view
scene.render.filepath = PICTURE
bpy.ops.render.render(write_still=True)
"""


INSTANCE = """
group = bpy.data.collections.new("group")
group.objects.link(item)
bpy.context.scene.collection.objects.unlink(item)
empty = bpy.data.objects.new("empty", None)
empty.instance_type, empty.instance_collection = "COLLECTION", group
bpy.context.scene.collection.objects.link(empty)
"""


@pytest.mark.parametrize("instance", ["", INSTANCE], ids=["itself", "instance"])
def test_converted_hair_covers_what_particle_hair_covered(instance, save, open_worker, tmp_path):
    picture = tmp_path / "particles.exr"
    body = f"CHILDREN = 'SIMPLE'\nPICTURE = {str(picture)!r}\n{PARTICLES}{instance}"
    worker = open_worker(save(body + "fur.use_close_tip = True\n" + RENDER, renders=True))
    with OpenEXR.File(str(picture)) as file:
        alpha = file.channels()["RGBA"].pixels[..., 3]
    step = 8.0 / 160
    across = (np.arange(160) + 0.5) * step - 4.0
    x, up = np.meshgrid(1.0 + across, 3.0 - across)
    origins = np.stack([x, up, np.full_like(x, 8.0)], axis=-1).reshape(-1, 3).astype(np.float32)
    directions = np.broadcast_to(np.float32([0, 0, -1]), origins.shape).copy()
    hit = AssetScene([worker.export_curves()]).shade_points(origins, directions).hit
    assert hit.sum() > 300
    assert np.sum(hit != (alpha.reshape(-1) > 0.5)) < 0.01 * hit.sum()


def test_particle_hair_is_the_same_each_time_and_follows_its_emitter(save, open_worker):
    moves = "item.keyframe_insert('location', frame=1)\n"
    moves += "item.location.z += 1\nitem.keyframe_insert('location', frame=9)\n"
    path = save(f"CHILDREN = 'INTERPOLATED'\n{PARTICLES}{moves}")
    worker = open_worker(path, rest_frame=9)
    one, two = (open_.export_curves().points for open_ in (worker, open_worker(path, rest_frame=9)))
    assert np.array_equal(one, two)
    worker.show_frame(1)
    np.testing.assert_allclose(worker.export_curves().points, one - (0, 1, 0), atol=1e-6)


def test_an_emitter_that_is_rendered_counts_as_a_surface(save, open_worker):
    body = f"CHILDREN = 'NONE'\n{PARTICLES}item.show_instancer_for_render = True\n"
    worker = open_worker(save(body))
    assert [(part.name, part.kind) for part in worker.parts] == [
        ("surface", "surface"),
        ("hair", "fiber"),
    ]


MIXED = HAIR + 'add(CUBE, SIDES).name = "head"\n'


@pytest.mark.parametrize(("hidden", "kind"), [("head", "fiber"), ("wig", "surface")])
def test_one_of_the_two_can_be_hidden(hidden, kind, open_worker):
    worker = open_worker(f"{MIXED}bpy.data.objects[{hidden!r}].hide_render = True\n")
    assert worker.kind == kind


def test_a_script_may_use_rna_hair(open_worker):
    worker: BlenderWorker = open_worker("""
import numpy as np, rna_hair
from rna_hair.objects import add_curves, chiang_material
points = np.arange(24, dtype=np.float32).reshape(2, 4, 3)
strands = rna_hair.of_equal_length(points, 0.5)
add_curves(strands, "h", chiang_material(colour=(0.8, 0.7, 0.6)))
""")
    curves = worker.export_curves()
    assert np.array_equal(curves.points, np.arange(24).reshape(8, 3))
    assert np.all(curves.radii == 0.5)
