"""Motion files: a written motion comes back, mapped; wrong ones are refused in one line."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rna_sdk.errors import MotionError
from rna_sdk.motion import motion_file, open_motion, write_motion
from tests.package.builders import make_curves, make_mesh

MESH, CURVES = make_mesh(), make_curves()
PARTS = [MESH, CURVES]


def frame(k: int) -> list[np.ndarray]:
    shift = np.float32([0, 0.1 * k, 0])
    return [MESH.positions + shift, CURVES.points - shift]


def written(path: Path, count: int = 4) -> Path:
    write_motion(path, PARTS, map(frame, range(count)), count=count, rate=25.0)
    return path


def test_frames_of_a_motion_come_back(tmp_path):
    motion = open_motion(written(tmp_path / "a.rnam"), PARTS)
    assert (motion.frames, motion.rate) == (4, 25.0)
    for k in (3, 0, 2):
        for actual, expected in zip(motion.positions(k), frame(k), strict=True):
            np.testing.assert_array_equal(actual, expected)
    half = motion.positions(1.5)[0]
    np.testing.assert_allclose(half, MESH.positions + np.float32([0, 0.15, 0]), atol=1e-6)


def test_a_motion_that_is_written_in_place(tmp_path, monkeypatch):
    """A read motion stays; a mapped one is refused; a file of its name changes nothing."""
    path = written(tmp_path / "a.rnam")
    read = open_motion(path, PARTS)
    monkeypatch.setattr(motion_file, "_MOST_READ", 0)
    mapped = open_motion(path, PARTS)
    size = path.stat().st_size
    path.rename(tmp_path / "b.rnam")
    for content in (None, bytes(size), b""):
        if content is not None:
            path.write_bytes(content)
        for motion in (read, mapped):
            np.testing.assert_array_equal(motion.positions(3)[0], frame(3)[0])
    mapped = open_motion(tmp_path / "b.rnam", PARTS)
    for content in (bytes(size), b""):
        (tmp_path / "b.rnam").write_bytes(content)
        np.testing.assert_array_equal(read.positions(3)[0], frame(3)[0])
        with pytest.raises(MotionError, match=r"b\.rnam: was written to while it was in use"):
            mapped.positions(3)


def test_a_motion_file_is_a_safetensors_file(tmp_path):
    from safetensors.numpy import load_file

    arrays = load_file(written(tmp_path / "a.rnam"))
    assert sorted(arrays) == ["part.0", "part.1", "rate", "topology"]
    np.testing.assert_array_equal(arrays["part.1"][2], frame(2)[1])


def test_the_same_motion_has_the_same_bytes(tmp_path):
    first, second = (written(tmp_path / name).read_bytes() for name in ("a.rnam", "b.rnam"))
    assert first == second


def test_a_motion_that_fails_leaves_no_file(tmp_path):
    def frames() -> Iterator[list[np.ndarray]]:
        yield frame(0)
        yield [MESH.positions * np.float32(np.nan), CURVES.points]

    with pytest.raises(MotionError, match=r"frame 1, part 0: vertex 0 is at \[nan"):
        write_motion(tmp_path / "a.rnam", PARTS, frames(), count=2, rate=24.0)
    with pytest.raises(MotionError, match="found 1 frames, expected 2"):
        write_motion(tmp_path / "a.rnam", PARTS, [frame(0)], count=2, rate=24.0)
    with pytest.raises(MotionError, match=r"found \(3, 3\), expected \(12, 3\)"):
        wrong = [MESH.positions[:3], CURVES.points]
        write_motion(tmp_path / "a.rnam", PARTS, [wrong], count=1, rate=24.0)
    assert list(tmp_path.iterdir()) == []


def test_a_motion_of_another_topology_is_refused(tmp_path):
    path = written(tmp_path / "a.rnam")
    turned = replace(MESH, triangles=MESH.triangles[::-1].copy())
    with pytest.raises(MotionError, match=r"a\.rnam: part 0 has other triangles than toy\.rna"):
        open_motion(path, [turned, CURVES], "toy.rna")
    longer = replace(CURVES, offsets=np.uint32([0, 4, 7, 9]))
    with pytest.raises(MotionError, match="part 1 has other strands"):
        open_motion(path, [MESH, longer])
    with pytest.raises(MotionError, match="has 2 parts, but the package has 1"):
        open_motion(path, [MESH])
    with pytest.raises(MotionError, match=r"part.0/shape: found \[4, 12, 3\], expected \[1 to"):
        open_motion(path, [CURVES, MESH])


def test_a_motion_without_the_frame_is_refused(tmp_path):
    motion = open_motion(written(tmp_path / "a.rnam"), PARTS)
    for number in (4, 3.5, -1):
        with pytest.raises(MotionError, match=f"has frames 0 to 3, and no frame {number:g}"):
            motion.positions(number)


def test_a_motion_with_nan_is_refused(tmp_path):
    path = written(tmp_path / "a.rnam")
    data = bytearray(path.read_bytes())
    data[-12:-8] = np.float32(np.nan).tobytes()
    path.write_bytes(data)
    motion = open_motion(path, PARTS)
    with pytest.raises(MotionError, match=r"frame 3, part 1: vertex 8 is at \[nan"):
        motion.positions(3)


def test_a_motion_of_another_scale_is_refused(tmp_path):
    frames = [[100 * positions for positions in frame(0)]]
    write_motion(tmp_path / "a.rnam", PARTS, frames, count=1, rate=24.0)
    with pytest.raises(MotionError, match=r"part 0 is 100 times as large .* expected metres"):
        open_motion(tmp_path / "a.rnam", PARTS)


@pytest.mark.parametrize("data", [b"", b"12", b"\x05\0\0\0\0\0\0\0{}   ", b"PK\3\4" + bytes(80)])
def test_a_motion_that_is_none_is_refused(tmp_path, data):
    path = tmp_path / "a.rnam"
    path.write_bytes(data)
    with pytest.raises(MotionError, match=r"a\.rnam: ") as caught:
        open_motion(path, PARTS)
    assert "\n" not in str(caught.value) and "lanes" not in str(caught.value)
    with pytest.raises(MotionError, match="No such file"):
        open_motion(tmp_path / "none.rnam", PARTS)
