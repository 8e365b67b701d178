"""Animated glTF: closed forms of nodes, interpolation, morph targets and skins."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rna_render.motion.asset_motion import open_asset_motion
from rna_render.motion.gltf_motion import GltfMotion
from rna_sdk.errors import MotionError
from tests.motion.gltf_files import GltfFile, bending_arm, moving_node, quaternion
from tests.render.test_hostile_files import mebibytes
from tests.runtime.test_deformation import grid
from tests.time_limit import time_limit

MESH = grid(5)


def test_a_node_in_motion(tmp_path):
    turn = [quaternion((0, 1, 0), angle) for angle in (0, 90)]
    tracks = [("rotation", [0, 1], turn), ("translation", [0, 2], [[0, 0, 0], [2, 0, 0]])]
    motion = GltfMotion(moving_node(tmp_path / "a.gltf", MESH, tracks), rate=10)
    assert motion.frames == 21
    for frame in (0, 5, 10, 20):
        angle = np.radians(9.0 * min(frame, 10))
        c, s = np.cos(angle), np.sin(angle)
        expected = MESH.positions @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T
        expected[:, 0] += frame / 10
        np.testing.assert_allclose(motion.positions(frame), expected, atol=1e-6)


@pytest.mark.parametrize(
    ("kind", "at"), [("LINEAR", 0.25), ("STEP", 0.0), ("CUBICSPLINE", 0.15625)]
)
def test_kinds_of_interpolation_of_a_motion(tmp_path, kind, at):
    """A quarter of the way from 0 to 1; of the spline with flat ends 3 t^2 - 2 t^3."""
    keys = np.zeros((2, 3))
    keys[1, 0] = 1
    values = keys if kind != "CUBICSPLINE" else np.stack([0 * keys, keys, 0 * keys], axis=1)
    track = ("translation", [0, 2], values.reshape(-1, 3))
    motion = GltfMotion(moving_node(tmp_path / "a.gltf", MESH, [track], kind), rate=2)
    actual = motion.positions(1)[:, 0] - MESH.positions[:, 0]
    np.testing.assert_allclose(actual, at, atol=1e-6)


def test_morph_targets_in_motion(tmp_path):
    file, up = GltfFile(), np.tile(np.float32([0, 1, 0]), (len(MESH.positions), 1))
    mesh = file.mesh(MESH)
    mesh["primitives"][0]["targets"] = [{"POSITION": file.add(up)}, {"POSITION": file.add(-2 * up)}]
    node = {"mesh": 0, "scale": [2, 2, 2]}
    file.data |= {"meshes": [mesh], "nodes": [node], "scenes": [{"nodes": [0]}]}
    file.animate([(0, "weights", [0, 1], [0, 0, 1, 0.25])])
    motion = GltfMotion(file.write(tmp_path / "a.gltf"), rate=1)
    shift = motion.positions(1) - motion.positions(0)
    np.testing.assert_allclose(shift, np.float32([0, 2 * (1 - 0.5), 0]) + 0 * shift, atol=1e-6)


def test_a_skin_in_motion(tmp_path):
    """The far end turns about the middle; the near one stays; the mesh's node does not count."""
    motion = GltfMotion(bending_arm(tmp_path / "a.gltf", MESH, 90), rate=1)
    np.testing.assert_allclose(motion.positions(0), MESH.positions, atol=1e-6)
    moved, p = motion.positions(1), MESH.positions
    middle = p.mean(axis=0)
    middle[0] = (p[:, 0].min() + p[:, 0].max()) / 2
    far, near = p[:, 0] == p[:, 0].max(), p[:, 0] == p[:, 0].min()
    np.testing.assert_allclose(moved[near], p[near], atol=1e-6)
    turned = middle + (p[far] - middle) @ np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]).T
    np.testing.assert_allclose(moved[far], turned, atol=1e-6)


def test_clips_of_a_motion_by_name(tmp_path):
    path = bending_arm(tmp_path / "a.gltf", MESH, 90)
    document = json.loads(path.read_text())
    document["animations"].append({**document["animations"][0], "name": "Run"})
    path.write_text(json.dumps(document))
    assert GltfMotion(path, "Run").frames == 25
    with pytest.raises(MotionError, match=r"a\.gltf: has no clip 'Fly'; it has clip, Run"):
        GltfMotion(path, "Fly")


def test_the_last_key_of_a_clip_between_two_frames_is_shown(tmp_path):
    track = ("translation", [0, 0.99], [[0, 0, 0], [1, 0, 0]])
    motion = GltfMotion(moving_node(tmp_path / "a.gltf", MESH, [track]))
    assert motion.frames == 25
    moved = motion.positions(24)[:, 0] - MESH.positions[:, 0]
    np.testing.assert_allclose(moved, 1.0, atol=1e-6)
    whole = ("translation", [0, 1], [[0, 0, 0], [1, 0, 0]])
    assert GltfMotion(moving_node(tmp_path / "b.gltf", MESH, [whole])).frames == 25


def test_a_clip_moves_a_package_that_was_made_from_another_one(tmp_path):
    """The package has the shape of the walk's first key, in which the run never is."""
    turns = [quaternion((0, 1, 0), angle) for angle in (30, 60, 90)]
    walk = moving_node(tmp_path / "walk.gltf", MESH, [("rotation", [0, 1], turns[:2])])
    run = moving_node(tmp_path / "run.gltf", MESH, [("rotation", [0, 1], turns[1:])])
    shape = replace(MESH, positions=GltfMotion(walk).positions(0).astype(np.float32))
    with pytest.raises(MotionError, match="has not the rest shape of fox"):
        open_asset_motion(run, [shape], "fox", rest_frame=0)
    bound = open_asset_motion(run, [shape], "fox", rest_frame=0, made_from=walk)
    np.testing.assert_allclose(bound.positions(24)[0], GltfMotion(run).positions(24), atol=1e-5)
    other = moving_node(tmp_path / "other.gltf", grid(4), [("rotation", [0, 1], turns[1:])])
    with pytest.raises(MotionError, match="not of the same triangles"):
        open_asset_motion(other, [shape], "fox", made_from=walk)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"animations": []}, "has no animation"),
        ({"meshes": [], "nodes": [{}, {}, {}]}, "has no triangles"),
        ({"accessors": []}, "is no valid glTF file: accessors has no item 0"),
        ({"accessors": None}, "is no valid glTF file: a value has another type than it should"),
        ({"skins": [{}]}, "is no valid glTF file: 'joints' is missing"),
        ({"nodes": [{"children": [1]}, {"children": [0]}, {}]}, "is no valid glTF file"),
        ({"asset": {"version": "1.0"}}, "version 1.0, not 2"),
    ],
)
def test_files_of_no_motion_are_refused(tmp_path, change, message):
    path = bending_arm(tmp_path / "a.gltf", MESH, 90)
    path.write_text(json.dumps({**json.loads(path.read_text()), **change}))
    with pytest.raises(MotionError, match=message) as caught:
        GltfMotion(path)
    assert "\n" not in str(caught.value)
    with pytest.raises(MotionError, match="No such file"):
        GltfMotion(tmp_path / "none.glb")


Document = dict[str, Any]


def changed(path: Path, change: Callable[[Document], object]) -> Path:
    """An arm that bends, with a change to its document."""
    document = json.loads(bending_arm(path, MESH, 90).read_text())
    change(document)
    path.write_text(json.dumps(document))
    return path


def primitive(document: Document) -> Document:
    return document["meshes"][0]["primitives"][0]


def morphed(document: Document) -> Document:
    """The mesh, with a morph target."""
    position = primitive(document)["attributes"]["POSITION"]
    primitive(document)["targets"] = [{"POSITION": position}]
    return document["meshes"][0]


def zeros(document: Document, kind: str) -> int:
    """The number of a new accessor of 2^20 items that takes no bytes in the file."""
    document["accessors"].append({"componentType": 5126, "type": kind, "count": 1 << 20})
    return len(document["accessors"]) - 1


def many_nodes(d: Document) -> None:
    primitive(d)["attributes"] = {"POSITION": zeros(d, "VEC3")}
    d["nodes"] = [{"mesh": 0}] * 65
    d["scenes"], d["skins"] = [{"nodes": list(range(65))}], []


def many_targets(d: Document) -> None:
    primitive(d)["attributes"] = {"POSITION": (number := zeros(d, "VEC3"))}
    primitive(d)["targets"] = [{"POSITION": number}] * 64


def many_skins(d: Document) -> None:
    d["skins"] += [{"joints": [1], "inverseBindMatrices": zeros(d, "MAT4")}] * 17


def many_tracks(d: Document) -> None:
    d["animations"][0]["samplers"] = [{"input": (number := zeros(d, "SCALAR")), "output": number}]
    d["animations"][0]["channels"] = [{"sampler": 0, "target": {"node": 0, "path": "weights"}}] * 65


@pytest.mark.parametrize("change", [many_nodes, many_targets, many_skins, many_tracks])
def test_motions_are_limited_before_they_take_memory(tmp_path, change):
    path = changed(tmp_path / "a.gltf", change)
    with mebibytes(20), pytest.raises(MotionError, match=r"a\.gltf: is no valid glTF.*; at most"):
        GltfMotion(path)


def test_a_long_chain_of_joints(tmp_path):
    def chain(d: Document) -> None:
        first, count = len(d["nodes"]), 30_000
        d["nodes"] += [{"children": [first + k + 1]} for k in range(count - 1)] + [{}]
        d["skins"].append({"joints": list(range(first + count - 1, first - 1, -1))})

    path = changed(tmp_path / "a.gltf", chain)
    with time_limit(20):
        np.testing.assert_allclose(GltfMotion(path).positions(0), MESH.positions, atol=1e-6)


@pytest.mark.parametrize(
    "change",
    [
        lambda d: d["nodes"][2].update(translation=[1, 2]),
        lambda d: d["nodes"][1].update(rotation=[0, 0, 0, 0]),
        lambda d: d["nodes"][0].update(skin=1),
        lambda d: d["skins"][0]["joints"].pop(),
        lambda d: d["skins"][0].update(joints=[1, 9]),
        lambda d: morphed(d).update(weights=[]),
        lambda d: morphed(d).update(weights=[float("nan")]),
        lambda d: primitive(d)["attributes"].update(JOINTS_0=primitive(d)["indices"]),
        lambda d: primitive(d)["attributes"].update(POSITION=primitive(d)["indices"]),
        lambda d: primitive(d).update(indices=primitive(d)["attributes"]["POSITION"]),
        lambda d: d["accessors"][primitive(d)["indices"]].update(count=-3),
        lambda d: d["nodes"][1].update(scale=[1e19, 1e19, 1e19]),
        lambda d: d["accessors"][0].update(count=d["buffers"][0]),
    ],
)
def test_a_motion_that_cannot_be_posed(tmp_path, change):
    path = changed(tmp_path / "a.gltf", change)
    with pytest.raises(MotionError, match=r"a\.gltf: is no valid glTF file: \w") as caught:
        GltfMotion(path).positions(1)
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 1000
    assert "Error" not in str(caught.value)  # no name of Python's


def test_data_that_lost_its_scheme_is_not_repeated(tmp_path):
    path = bending_arm(tmp_path / "a.gltf", MESH, 90)
    document = json.loads(path.read_text())
    document["buffers"][0]["uri"] = document["buffers"][0]["uri"].replace("data:", "dataA")
    path.write_text(json.dumps(document))
    with pytest.raises(MotionError, match=r"a uri of \d+ characters, which begins with 'dataA"):
        GltfMotion(path)


def test_times_before_the_start_are_refused(tmp_path):
    track = ("translation", [-5, -1], np.zeros((2, 3)))
    with pytest.raises(MotionError, match="do not ascend from 0"):
        GltfMotion(moving_node(tmp_path / "a.gltf", MESH, [track]))
