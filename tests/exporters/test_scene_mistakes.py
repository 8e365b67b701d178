"""What an artist may not have meant is said before the first ray, with what to do."""

import pytest

from rna_sdk.errors import CaptureError

pytestmark = pytest.mark.blender

HIDDEN = """
lost = add(CUBE, SIDES, diffuse((1, 1, 1)))
lost.name = "lost"
lost.hide_render = True
"""
FLOOR = """
floor = add(*square(50.0, z=-1.0), diffuse((1, 1, 1)))
floor.name = "floor"
label = principled()
label.name = "label"
node = label.node_tree.nodes.new("ShaderNodeTexImage")
node.image = bpy.data.images.new("letters", 4, 4)
label.node_tree.links.new(
    node.outputs[0], label.node_tree.nodes["Principled BSDF"].inputs["Base Color"])
box = add(CUBE, SIDES, label)
box.name = "box"
"""


def test_a_floor_a_hidden_object_and_missing_uvs_are_named(open_worker):
    hidden, floor, uvs = open_worker(HIDDEN + FLOOR).opened["notes"]
    assert hidden == "left out, since renders do not show them: 'lost'"
    assert floor.startswith("object 'floor' is 50 times as long as all else together")
    assert "hide it in renders" in floor
    assert uvs.startswith("object 'box' has no UV map, and shows one colour of the image 'letters'")
    assert "unwrap it" in uvs


def test_a_scene_of_which_nothing_is_rendered_is_told_what_is_hidden(
    open_worker,
):
    worker = open_worker(HIDDEN)
    with pytest.raises(CaptureError, match="renders do not show 'lost', turn on its camera icon"):
        worker.export_corners()
