"""What materials let through and emit: read from their nodes, and captured."""

from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_worker import BlenderWorker, SeeThrough
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import EmissionShard, TrainingShard
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.geometry.exported_parts import exported_parts
from tests.exporters.synthetic import manifest_of

pytestmark = pytest.mark.blender

LEAF = """
import numpy as np
pixels = np.random.default_rng(0).random((4, 8, 4)).astype(np.float32)
image = bpy.data.images.new("leaf", 8, 4, alpha=True)
image.pixels.foreach_set(pixels[::-1].ravel())
image.pack()
leaf = principled()
tree = leaf.node_tree
alpha = tree.nodes["Principled BSDF"].inputs["Alpha"]
picture = tree.nodes.new("ShaderNodeTexImage")
picture.image = image
card = add(*square(1), leaf)
card.data.uv_layers.new(name="UVMap")  # 0 to 1
"""

BLEND = LEAF + 'tree.links.new(picture.outputs["Alpha"], alpha)'

MASK = (
    LEAF
    + """
threshold = tree.nodes.new("ShaderNodeMath")
threshold.operation, threshold.inputs[1].default_value = "GREATER_THAN", 0.25
tree.links.new(picture.outputs["Alpha"], threshold.inputs[0])
tree.links.new(threshold.outputs[0], alpha)
"""
)

GLASS = """
glass = principled()
tree = glass.node_tree
mix, facing = tree.nodes.new("ShaderNodeMixShader"), tree.nodes.new("ShaderNodeFresnel")
clear, shine = tree.nodes.new("ShaderNodeBsdfTransparent"), tree.nodes.new("ShaderNodeBsdfGlossy")
facing.inputs["IOR"].default_value = 1.5
clear.inputs["Color"].default_value = (0.2, 0.4, 0.8, 1.0)
for source, place in ((facing, 0), (clear, 1), (shine, 2)):
    tree.links.new(source.outputs[0], mix.inputs[place])
tree.links.new(mix.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
add(*square(1), glass)
"""

GROUP = """
group = bpy.data.node_groups.new("clear", "ShaderNodeTree")
group.interface.new_socket("shader", in_out="OUTPUT", socket_type="NodeSocketShader")
inner, end = group.nodes.new("ShaderNodeBsdfPrincipled"), group.nodes.new("NodeGroupOutput")
inner.inputs["Alpha"].default_value = 0.25
group.links.new(inner.outputs[0], end.inputs[0])
material = principled()
tree = material.node_tree
node = tree.nodes.new("ShaderNodeGroup")
node.node_tree = group
tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
add(*square(1), material)
"""

BY_SIDE = """
material = principled()
tree = material.node_tree
side = tree.nodes.new("ShaderNodeNewGeometry")
alpha = tree.nodes["Principled BSDF"].inputs["Alpha"]
tree.links.new(side.outputs["Backfacing"], alpha)
add(*square(1), material)
"""

PLATE_OVER_GROUND = """
half = diffuse((0.5, 0.5, 0.5))
tree = half.node_tree
mix, clear = tree.nodes.new("ShaderNodeMixShader"), tree.nodes.new("ShaderNodeBsdfTransparent")
clear.inputs["Color"].default_value = (1.0, 0.5, 1.0, 1.0)
shown = tree.nodes["Material Output"].inputs["Surface"].links[0].from_socket
for socket, place in ((clear.outputs[0], 1), (shown, 2)):
    tree.links.new(socket, mix.inputs[place])
tree.links.new(mix.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
add(*square(3, z=1), half)
add(*square(0.5), diffuse((0.5, 0.5, 0.5)))
"""

LAMP = """
glow = principled(Emission_Color=(1, 0.5, 0.25, 1), Emission_Strength=30.0, Base_Color=(0, 0, 0, 1),
                  Specular_IOR_Level=0.0)
add(*square(0.5), glow)
add(*square(0.5, x=2), diffuse((0.5, 0.5, 0.5)))
"""


def alpha_of_leaf() -> np.ndarray:
    """(4, 8), row 0 at the top."""
    return np.random.default_rng(0).random((4, 8, 4)).astype(np.float32)[..., 3]


def holes(worker: BlenderWorker) -> tuple[dict[str, SeeThrough], list[str]]:
    """By material, and the notes."""
    textures = worker.export_textures(0)
    return textures.see_through, textures.notes


def test_alpha_of_an_image_is_read_texel_by_texel(open_worker):
    actual, notes = holes(open_worker(BLEND))
    leaf = actual["principled"]
    assert (leaf.cutoff, leaf.ior, notes) == (None, None, [])
    assert leaf.texture.shape == (4, 8, 1)
    assert np.abs(leaf.texture[..., 0] / 255.0 - (1.0 - alpha_of_leaf())).max() < 0.003


def test_a_threshold_is_a_cutoff_of_what_it_compares(open_worker):
    actual, _ = holes(open_worker(MASK))
    leaf = actual["principled"]
    assert leaf.cutoff == pytest.approx(0.75)
    assert np.abs(leaf.texture[..., 0] / 255.0 - (1.0 - alpha_of_leaf())).max() < 0.003


def test_a_fresnel_mix_is_thin_glass(open_worker):
    actual, _ = holes(open_worker(GLASS))
    glass = actual["principled"]
    assert glass.texture.tolist() == [[[51, 102, 204]]]
    assert glass.ior == pytest.approx((1.5, 1 / 1.5))


def test_nodes_in_groups_are_read(open_worker):
    actual, _ = holes(open_worker(GROUP))
    assert actual["principled"].texture.tolist() == [[[191]]]


@pytest.mark.parametrize("scene", ["add(*square(1), principled())", LAMP])
def test_opaque_materials_have_none(open_worker, scene):
    assert holes(open_worker(scene)) == ({}, [])


def test_what_is_no_function_of_uv_is_named(open_worker):
    actual, notes = holes(open_worker(BY_SIDE))
    assert actual == {}
    assert len(notes) == 1 and "'principled'" in notes[0] and "'Geometry'" in notes[0]


def test_a_plate_is_captured_as_if_it_were_opaque_and_weakens_light(open_worker, tmp_path):
    dataset = captured(open_worker(PLATE_OVER_GROUND), tmp_path / "rays")
    at = dataset.only.training_samples()
    up, visible = at["wi"][:, 1], at["visible"]
    plate = at["position"][:, 1] > 0.5
    expected = 0.5 / np.pi * up
    lit = plate & (at["wo"][:, 1] * up > 0.0)
    assert np.allclose(visible[lit], 1.0)
    # Light that the ground sends up is in it, too.
    assert np.median(at["radiance"][lit] / expected[lit][:, None]) == pytest.approx(1.0, abs=0.1)
    below = ~plate & (at["wo"][:, 1] > 0.2) & (up > 0.4)
    assert np.median(visible[below], axis=0) == pytest.approx([0.5, 0.25, 0.5], abs=0.005)
    ground = at["radiance"][below] / expected[below][:, None]
    assert np.median(ground, axis=0) == pytest.approx([0.5, 0.25, 0.5], rel=0.25)


def test_emission_is_captured_in_watts(open_worker, tmp_path):
    dataset = captured(open_worker(LAMP), tmp_path / "rays")
    EmissionShard(0).run(dataset, scene_of(dataset), open_worker(LAMP))
    at = dataset.only.emission_samples()
    glow = (at["position"][:, 0] < 1.0) & (np.abs(at["wo"][:, 1]) > 0.1)
    assert set(at) == {"position", "normal", "wo", "radiance"}
    assert np.median(at["radiance"][glow], axis=0) == pytest.approx([30.0, 15.0, 7.5], rel=1e-3)
    assert not at["radiance"][at["position"][:, 0] > 1.0].all(axis=1).all()
    transport = dataset.only.training_samples()
    assert transport["radiance"][transport["position"][:, 0] < 1.0].max() < 1.0


def captured(worker: BlenderWorker, folder: Path) -> Dataset:
    """One shard of a few lights."""
    exported = exported_parts(worker, CaptureSettings())
    lights = {"lights": 6, "lights_per_shard": 6, "rays": 1024, "samples": 16}
    manifest = manifest_of(
        CaptureSettings(**lights, domain="hemisphere"),
        parts=exported.captured(),
        emitters=tuple(worker.opened["emitters"]),
        opaque_cutouts=exported.has_opaque_cutouts,
    )
    dataset = Dataset.create(folder, manifest, exported.geometries, exported.textures)
    TrainingShard(0).run(dataset, scene_of(dataset), worker)
    return dataset
