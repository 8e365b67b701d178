"""How a source is divided into parts: by kinds, or by its top objects."""

import numpy as np
import pytest

from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_sdk.errors import CaptureError

pytestmark = pytest.mark.blender

WIG = """
import numpy as np, rna_hair
from rna_hair.objects import add_curves, chiang_material
def hair(name, x):
    points = np.arange(24, dtype=np.float32).reshape(2, 4, 3) + np.float32([x, 0, 0])
    add_curves(rna_hair.of_equal_length(points, 0.5), name, chiang_material(melanin=0.5))
    return bpy.data.objects[name]
"""
HEAD = """
head = add(CUBE, SIDES)
head.name = "Head of hair!"
"""


def named(worker: BlenderWorker) -> list[tuple[str, str]]:
    return [(part.name, part.kind) for part in worker.parts]


def test_one_kind_is_one_part(open_worker):
    assert named(open_worker(HEAD)) == [("asset", "surface")]
    assert named(open_worker(WIG + "hair('wig', 0)")) == [("asset", "fiber")]


def test_surfaces_and_hair_are_two_parts(open_worker):
    worker = open_worker(WIG + HEAD + "hair('wig', 0)\nhair('beard', 3)\nadd(*square(4))")
    assert named(worker) == [("surface", "surface"), ("hair", "fiber")]
    assert worker.kind == "both"
    assert len(worker.export_curves().offsets) == 5
    assert len(worker.export_corners()["positions"]) == 3 * (12 + 2)


def test_each_top_object_is_a_part(open_worker):
    """Children belong to what they are parented to, helpers without a shape do not count."""
    scene = """
collar = add(*square(4))
collar.name = "head_of_Hair"
nose = add(*square(2))
nose.parent = head
hair('wig', 0).parent = head
group = bpy.data.objects.new("group", None)
bpy.context.scene.collection.objects.link(group)
head.parent = collar.parent = group
hair('tail', 3)
"""
    worker = open_worker(WIG + HEAD + scene, parts="objects")
    assert sorted(named(worker)) == [
        ("Head_of_hair", "surface"),
        ("Head_of_hair_hair", "fiber"),
        ("head_of_Hair_2", "surface"),
        ("tail", "fiber"),
    ]
    of = {part.name: part.owner for part in worker.parts}
    assert len(worker.export_corners(of["Head_of_hair"])["positions"]) == 3 * (12 + 2)
    assert len(worker.export_corners(of["head_of_Hair_2"])["positions"]) == 3 * 2
    assert np.allclose(worker.export_curves(of["tail"]).points[0], [3, 1, 2])


def test_more_parts_than_a_package_holds_are_refused(open_worker):
    many = "for k in range(17):\n    add(*square(1, x=3 * k))\n"
    with pytest.raises(CaptureError, match=r"found 17 parts, expected at most 16: .*--parts kinds"):
        open_worker(many, parts="objects")
    assert named(open_worker(many)) == [("asset", "surface")]
