"""The asset is captured alone: no light but ours, no emission; and cut-outs are known."""

import numpy as np
import pytest

from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import TrainingShard
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_manifest import CapturedPart
from rna_export.capture.geometry.mesh_cleanup import welded
from tests.exporters.cycles import trace, unit
from tests.exporters.synthetic import manifest_of

pytestmark = pytest.mark.blender
BELOW = unit(0, -1, 0)

FOREIGN_LIGHT = """
add(*square(1), diffuse((1, 1, 1)))
for kind in ("POINT", "SUN", "AREA"):
    lamp = bpy.data.objects.new(kind, bpy.data.lights.new(kind, kind))
    lamp.location = (0, 0, 2)
    bpy.context.scene.collection.objects.link(lamp)
bpy.context.scene.collection.objects.link(bpy.data.objects.new("c", bpy.data.cameras.new("c")))
world = bpy.data.worlds.new("bright")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs["Strength"].default_value = 5.0
bpy.context.scene.world = world
"""

PRINCIPLED_GLOW = """
black, white = (0, 0, 0, 1), (1, 1, 1, 1)
add(*square(1), principled(Emission_Color=white, Emission_Strength=3.0, Base_Color=black))
"""

EMISSION_NODE = """
material = principled()
tree = material.node_tree
glow = tree.nodes.new("ShaderNodeEmission")
tree.links.new(glow.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
add(*square(1), material)
"""

EMISSION_IN_A_GROUP = """
group = bpy.data.node_groups.new("glow", "ShaderNodeTree")
group.interface.new_socket("shader", in_out="OUTPUT", socket_type="NodeSocketShader")
glow, end = group.nodes.new("ShaderNodeEmission"), group.nodes.new("NodeGroupOutput")
group.links.new(glow.outputs[0], end.inputs[0])
material = principled()
tree = material.node_tree
node = tree.nodes.new("ShaderNodeGroup")
node.node_tree = group
tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
add(*square(1), material)
"""


def seen_from_above(worker) -> np.ndarray:
    """Radiance of the upper side, lit from below only: black for opaque objects."""
    traced = trace(worker, BELOW, 512)
    assert traced.front.sum() > 100
    return traced.radiance[traced.front]


def test_only_our_sun_shines(open_worker):
    worker = open_worker(FOREIGN_LIGHT)
    assert not seen_from_above(worker).any()
    assert worker.opened["notes"] == []


@pytest.mark.parametrize(
    "scene",
    [PRINCIPLED_GLOW, EMISSION_NODE, EMISSION_IN_A_GROUP],
    ids=["principled", "node", "group"],
)
def test_emission_is_told_and_is_no_part_of_the_transport(open_worker, scene):
    worker = open_worker(scene)
    assert not seen_from_above(worker).any()
    assert worker.opened["emitters"] == ["principled"]


def test_a_hit_on_an_unread_cutout_is_a_sample(open_worker, tmp_path):
    """Where the transparency is not known, what shines through is the radiance of the hit."""
    worker = open_worker(
        "add(*square(1, z=1), principled(Alpha=0.0))\nadd(*square(1), diffuse((1, 1, 1)))"
    )
    dataset = one_light_dataset(tmp_path / "rays", worker)
    scene = scene_of(dataset)
    TrainingShard(0).run(dataset, scene, worker)
    samples = dataset.only.training_samples()
    assert len(samples["wo"]) == dataset.manifest.settings.rays
    on_the_cutout = (samples["position"][:, 1] > 0.99) & (samples["wo"][:, 1] > 0.95)
    assert samples["radiance"][on_the_cutout].mean() > 0.05


def one_light_dataset(folder, worker) -> Dataset:
    mesh = welded(worker.export_corners())[0]
    low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
    bounds = tuple(low.tolist()), tuple(high.tolist())
    part = CapturedPart(name="asset", kind="surface", bounds=bounds)
    settings = CaptureSettings(samples=4, rays=512, lights=1, domain="hemisphere")
    manifest = manifest_of(settings, parts=(part,), opaque_cutouts=True)
    return Dataset.create(folder, manifest, {"asset": mesh})
