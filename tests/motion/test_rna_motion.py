"""`rna-motion`: motion files of glTF, and of what Blender evaluates."""

import base64
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.geometry.followed_source import captured_poses
from rna_export.capture.geometry.mesh_cleanup import welded
from rna_export.motion.rna_motion import main
from rna_render import open_asset_motion
from rna_render.motion.gltf_motion import GltfMotion
from rna_sdk.errors import CaptureError
from rna_sdk.files.file_kinds import kind_of
from rna_sdk.motion import open_motion
from rna_sdk.package import Curves, Mesh, Package, Provenance, SourceVertices, Tier, write_package
from rna_sdk.package.gltf.carrier_writer import with_package
from rna_sdk.package.manifest.manifest_model import REST_FRAME
from rna_sdk.package.packing import Unpacked
from rna_sdk.runtime import load
from tests.conftest import REPOSITORY
from tests.motion.gltf_files import bending_arm, moving_node, quaternion
from tests.package.builders import (
    FIBER_INPUTS,
    make_manifest,
    make_part,
    make_part_data,
    make_tier_part,
)
from tests.package.carriers import written

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"

ARM = """
import bpy
bpy.ops.mesh.primitive_cylinder_add(radius=0.1, depth=1.0, vertices=12)
item = bpy.context.object
bpy.ops.object.mode_set(mode="EDIT")
bpy.ops.mesh.subdivide(number_cuts=4)
bpy.ops.object.mode_set(mode="OBJECT")
key = item.location
item.keyframe_insert("location", frame=1)
item.rotation_euler = 0.0, 0.0, 0.0
item.keyframe_insert("rotation_euler", frame=1)
item.location.z += 0.4
item.rotation_euler.x = 1.0
item.keyframe_insert("location", frame=5)
item.keyframe_insert("rotation_euler", frame=5)
scene = bpy.context.scene
scene.frame_start, scene.frame_end = 1, 5
scene.render.fps = 12
twin = bpy.data.objects.new("twin", item.data)  # of one mesh, and stands still
twin.location.x = 2.0
scene.collection.objects.link(twin)
scene.frame_set(1)
"""
HAIR = """
curves = bpy.data.hair_curves.new("hair")
curves.add_curves([3, 3])
points = [(0, 0, 0.5), (0, 0, 0.7), (0, 0.1, 0.8), (0.05, 0, 0.5), (0.05, 0, 0.7), (0.05, 0.1, 0.9)]
curves.attributes["position"].data.foreach_set("vector", [v for p in points for v in p])
hair = bpy.data.objects.new("hair", curves)
hair.parent = item
scene.collection.objects.link(hair)
scene.frame_set(1)
"""


REST = 5
"""The frame of ARM that its package is of; it opens with frame 1."""


def package(path: Path, mesh: Mesh, hair: Curves) -> Path:
    """A package of these two parts."""
    tier = Tier(
        name="small", parts=(make_tier_part("skin"), make_tier_part("hair", inputs=FIBER_INPUTS))
    )
    parts = make_part(name="skin"), make_part(name="hair", kind="fiber")
    origin = Provenance(source="arm.py", tool="tests", capture={REST_FRAME: REST})
    manifest = make_manifest(tier, parts=parts, provenance=origin)
    data = [make_part_data(part, seed=k) for k, part in enumerate(tier.parts)]
    write_package(path, manifest, [mesh, hair], {tier.name: data})
    return path


def test_a_motion_file_of_a_gltf(tmp_path, capsys):
    mesh = load(TOY).mesh
    bend, out = bending_arm(tmp_path / "bend.gltf", mesh, 30), tmp_path / "bend.rnam"
    assert main([str(bend), str(TOY), "--out", str(out), "--rate", "4"]) == 0
    output = capsys.readouterr().out
    size = out.stat().st_size
    assert f"wrote {out}: 5 frames at 4 a second, {size / 1e6:.1f} MB" in output
    motion = open_motion(out, [mesh])
    direct = open_asset_motion(bend, [mesh], "toy.rna", rate=4.0)
    for frame in (0, 3):
        np.testing.assert_array_equal(motion.positions(frame)[0], direct.positions(frame)[0])
    some = tmp_path / "some.rnam"
    arguments = [str(bend), str(TOY), "--out", str(some), "--rate", "4", "--frames", "2-3"]
    assert main(arguments) == 0
    assert open_motion(some, [mesh]).frames == 2


def test_sources_of_no_motion_are_one_line(tmp_path, capsys):
    mesh, out = load(TOY).mesh, tmp_path / "a.rnam"
    large = replace(mesh, positions=100 * mesh.positions)
    track = ("translation", [0, 1], [[0, 0, 0], [1, 0, 0]])
    source = moving_node(tmp_path / "large.gltf", large, [track])
    assert main([str(source), str(TOY), "--out", str(out)]) == 1
    error = capsys.readouterr().err
    assert "large.gltf has not the rest shape of toy.rna" in error
    assert "100 times as large" in error and error.count("\n") == 1
    fits = moving_node(tmp_path / "fits.gltf", mesh, [track])
    assert main([str(fits), str(TOY), "--out", str(out), "--frames", "0-99"]) == 1
    assert "has frames 0 to 24, and no frame 25" in capsys.readouterr().err
    assert not out.exists()


@pytest.mark.blender
def test_an_animated_gltf_is_captured_at_its_first_keys(tmp_path, blender_python):
    """Where the next clip of the character may begin, and not 1/24 s into this one."""
    turns = [quaternion((0, 1, 0), angle) for angle in (30, 80)]
    path = moving_node(tmp_path / "walk.gltf", load(TOY).mesh, [("rotation", [0, 0.5], turns)])
    with BlenderWorker(blender_python, Source(path), tmp_path / "worker", 1) as worker:
        assert worker.opened["frame"] == 0
        mesh, _ = welded(worker.export_corners())
    motion = GltfMotion(path)
    open_asset_motion(path, [mesh], "walk.rna", rest_frame=0)
    assert np.ptp(motion.positions(0) - motion.positions(1), axis=0).max() > 0.01


@pytest.mark.blender
def test_a_motion_file_of_what_blender_evaluates(tmp_path, blender_python, capsys):
    """The whole moves as one, so each vertex has a closed form; strands are the source's own.

    The package is that of another frame than the one that the source opens with.
    """
    source, out = tmp_path / "arm.py", tmp_path / "arm.rnam"
    source.write_text(ARM + HAIR)
    at_rest = Source(source, rest_frame=REST)
    with BlenderWorker(blender_python, at_rest, tmp_path / "worker", 1) as worker:
        assert worker.opened["frame"] == REST
        corners, hair = worker.export_corners(), worker.export_curves()
        mesh, first = welded(corners)
        parts = {"skin": mesh, "hair": hair}
        with pytest.raises(CaptureError, match="frame 9 is as the rest frame, 5: nothing moves"):
            dict(captured_poses(worker, parts, {}, [9]))
        pose = dict(captured_poses(worker, parts, {}, [1]))[1]
        worker.restart()
        np.testing.assert_allclose(worker.export_curves().points, pose["hair"], atol=1e-6)
    asset = package(tmp_path / "arm.rna", mesh, hair)
    numbers = SourceVertices(corners["vertex"][first].astype(np.uint32), int(corners["vertices"]))
    assert len(mesh.positions) > numbers.count == len(np.unique(numbers.numbers))
    Unpacked.read(asset).with_source([numbers, None]).write(asset)
    assert main([str(source), str(asset), "--out", str(out)]) == 0
    assert "arm.rna follows arm.py by the numbers of its vertices\n" in capsys.readouterr().out
    motion = open_motion(out, [mesh, hair])
    assert (motion.frames, motion.rate) == (5, 12)
    c, s = np.cos(1.0), np.sin(1.0)
    turn = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    assert (mesh.positions[:, 0] > 1.0).mean() == pytest.approx(0.5, abs=0.01)  # the twin
    for rest, actual in zip((mesh.positions, hair.points), motion.positions(0), strict=True):
        still = rest[:, :1] > 1.0
        expected = np.where(still, rest, (rest - (0, 0.4, 0)) @ turn)
        np.testing.assert_allclose(actual, expected, atol=2e-5)
    np.testing.assert_allclose(motion.positions(0)[1], pose["hair"], atol=1e-6)
    for rest, actual in zip((mesh.positions, hair.points), motion.positions(4), strict=True):
        np.testing.assert_allclose(actual, rest, atol=1e-6)
    capsys.readouterr()
    assert main([str(source), str(asset), "--out", str(out), "--rest-frame", "1"]) == 1
    assert "arm.rna: was captured at frame 5, found --rest-frame 1" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "reason"),
    [("loop.blend", "Too many levels of symbolic links"), ("model.rna", "a package, not a model")],
)
def test_what_is_no_model_is_refused_before_blender_starts(
    name,
    reason,
    tmp_path,
    monkeypatch,
    capsys,
):
    (tmp_path / "loop.blend").symlink_to("loop.blend")
    (tmp_path / "model.rna").write_bytes(b"a package")
    monkeypatch.setattr(blender_env, "find_or_set_up", lambda: pytest.fail("Blender starts"))
    assert main([str(tmp_path / name), str(TOY), "--out", str(tmp_path / "out.rnam")]) == 1
    error = capsys.readouterr().err
    assert error.startswith(f"error: {tmp_path / name}: ") and reason in error
    assert error.count("\n") == 1


def test_a_carrier_is_moved_by_its_own_skin(tmp_path):
    """One .glb: the fallback's skin and clip, and the package that follows them."""
    mesh = load(TOY).mesh
    text = json.loads(bending_arm(tmp_path / "bend.gltf", mesh, 30).read_text())
    blob = base64.b64decode(text["buffers"][0].pop("uri").partition(",")[2])
    rigged = written(text, blob, tmp_path / "rigged.glb")
    carrier, out = tmp_path / "toy.glb", tmp_path / "toy.rnam"
    with Package.open(TOY) as opened:
        carrier.write_bytes(with_package(rigged, opened))
    assert kind_of(carrier) == "package"
    assert main([str(carrier), str(carrier), "--out", str(out), "--rate", "2"]) == 0
    moved, direct = (
        open_motion(out, [mesh], "toy.glb"),
        open_asset_motion(tmp_path / "bend.gltf", [mesh], "toy.rna", rate=2.0),
    )
    assert moved.frames == 3
    for frame in range(3):
        np.testing.assert_array_equal(moved.positions(frame)[0], direct.positions(frame)[0])
