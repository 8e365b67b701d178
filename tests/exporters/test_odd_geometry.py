"""Geometry that files have and renders leave out: it is left out with a note, not with an error."""

import numpy as np
import pytest

from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.geometry.exported_parts import exported_parts
from rna_export.capture.rays.traced_rays import TracedRays
from rna_export.capture.rays.view_rays import sample_view_rays
from rna_sdk.errors import CaptureError
from rna_sdk.package import Mesh
from tests.exporters.cycles import assert_same_holes, scene_of, unit

pytestmark = pytest.mark.blender

ODD = """
import sys
sys.stdout.buffer.write("K\\u00f6rper.png\\n".encode("latin-1"))  # as Blender prints a file's name
sys.stdout.buffer.flush()
add(CUBE, SIDES)
add(CUBE, SIDES, matrix=Matrix.Diagonal((0, 0, 0, 1)))
add(CUBE, SIDES, matrix=Matrix.Translation((4, 0, 0)) @ Matrix.Diagonal((1, 1, 0, 1)))
broken = bpy.data.meshes.new("without points")
broken.loops.add(3)
broken.polygons.add(1)
broken.polygons[0].loop_start = 0
bpy.context.scene.collection.objects.link(bpy.data.objects.new("broken", broken))
lines = bpy.data.meshes.new("lines")
lines.from_pydata([(0, 0, 0), (0, 0, 1)], [(0, 1)], [])
bpy.context.scene.collection.objects.link(bpy.data.objects.new("lines", lines))
"""

LINES = """
lines = bpy.data.meshes.new("lines")
lines.from_pydata([(0, 0, 0), (0, 0, 1)], [(0, 1)], [])
bpy.context.scene.collection.objects.link(bpy.data.objects.new("lines", lines))
add([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)])
"""


def test_flat_empty_and_broken_objects(open_worker):
    worker = open_worker(ODD)
    assert [note for note in worker.opened["notes"] if "'without points' is invalid" in note]
    exported = exported_parts(worker, CaptureSettings())
    mesh = exported.geometries["asset"]
    assert isinstance(mesh, Mesh) and len(mesh.triangles) == 12 + 4
    flat = mesh.positions[:, 0] > 2.0
    assert np.allclose(np.abs(mesh.normals[flat]), [0, 1, 0], atol=1e-4)
    assert_same_holes(worker, exported)


def test_lines_and_triangles_without_area_are_refused(open_worker):
    worker = open_worker(LINES)
    with pytest.raises(CaptureError, match=r"scene0\.py: no triangles \(only lines"):
        exported_parts(worker, CaptureSettings())


GUIDES = """
item = add(CUBE, SIDES)
tree = bpy.data.node_groups.new("guides", "GeometryNodeTree")
for way in ("INPUT", "OUTPUT"):
    tree.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
start, end, line, join = (
    tree.nodes.new(kind) for kind in ("NodeGroupInput", "NodeGroupOutput",
    "GeometryNodeCurvePrimitiveLine", "GeometryNodeJoinGeometry"))
for source in (start, line):
    tree.links.new(source.outputs[0], join.inputs[0])
tree.links.new(join.outputs[0], end.inputs[0])
item.modifiers.new("guides", "NODES").node_group = tree
"""


def test_curves_of_geometry_nodes_without_a_surface_are_named(open_worker):
    worker = open_worker(GUIDES)
    assert [note for note in worker.opened["notes"] if "without a surface" in note]
    mesh = exported_parts(worker, CaptureSettings()).geometries["asset"]
    assert isinstance(mesh, Mesh) and len(mesh.triangles) == 12


@pytest.mark.parametrize("radius", [7e-5, 7e6])
def test_holes_at_any_scale(open_worker, radius):
    """Rays begin close before a hit and end close behind it, of whatever size the asset is."""
    script = f"""
leaf = principled(Alpha=0.5)
add(*square({radius / 2**0.5}), leaf)
add(*square({radius / 4}, z={radius / 4}))
"""
    worker = open_worker(script)
    exported = exported_parts(worker, CaptureSettings())
    assert_same_holes(worker, exported)
    scene, rng, wi = scene_of(exported), np.random.default_rng(1), unit(0.2, 1.0, 0.4)
    rays = sample_view_rays(scene, wi, 512, "sphere", rng)
    traced = TracedRays.of(scene, worker, rays, wi, 16, 1, rng, opaque_cutouts=False)
    assert traced.valid[traced.points.hit].mean() > 0.97
    leaf = traced.valid & (traced.points.transmittance[:, 0] > 0.0)
    assert traced.rendered.alpha[leaf].mean() == pytest.approx(0.5, abs=0.02)
