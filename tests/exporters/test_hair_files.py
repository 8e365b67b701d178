"""Groom files: written strands are read back, faults are named."""

import struct

import numpy as np
import pytest

from rna_export.blender.rna_hair import Strands, read_hair, read_tfx, write_hair
from rna_export.capture.blender_axes import from_blender


def strands() -> Strands:
    rng = np.random.default_rng(3)
    points = rng.normal(size=(9, 3)).astype(np.float32)
    radii = rng.uniform(0.01, 0.02, 9).astype(np.float32)
    return Strands(points, radii, np.array([0, 2, 6, 9]))


def hair_bytes(
    magic: bytes = b"HAIR",
    strand_count: int = 2,
    points: int = 5,
    bits: int = 7,
    default: tuple[int, float] = (0, 0.5),
    segments: tuple[int, ...] = (1, 2),
    thickness: float = 0.1,
) -> bytes:
    """A file of two strands, 2 and 3 points; arrays as `bits` says."""
    counts = magic, strand_count, points, bits, *default
    header = struct.pack("<4sIIIIf", *counts).ljust(128, b"\0")
    xyz = np.arange(3 * points, dtype="<f4")
    arrays = (
        np.array(segments, "<u2"),
        xyz,
        np.full(points, thickness, "<f4"),
        np.zeros(points, "<f4"),
        np.zeros(3 * points, "<f4"),
    )
    return header + b"".join(a.tobytes() for bit, a in enumerate(arrays) if bits >> bit & 1)


def tfx_bytes(
    version: float = 3.0, count: int = 2, points: int = 3, positions: np.ndarray | None = None
) -> bytes:
    if positions is None:
        positions = np.arange(18, dtype=np.float32)
    header = struct.pack("<fII", version, count, points).ljust(296, b"\0")
    return header + positions.astype("<f4").tobytes()


def tfx_4_bytes(offset: int = 160) -> bytes:
    """The strands of `tfx_bytes`, each point with an inverse mass behind it."""
    points = np.column_stack([np.arange(18, dtype="<f4").reshape(6, 3), np.full(6, np.nan, "<f4")])
    header = struct.pack("<fIII", 4.0, 2, 3, offset).ljust(160, b"\0")
    return header + points.astype("<f4").tobytes()


def test_hair_round_trip(tmp_path):
    written = strands()
    write_hair(tmp_path / "a.hair", written)
    read = read_hair(tmp_path / "a.hair")
    assert np.array_equal(read.points, written.points)
    assert np.array_equal(read.radii, written.radii)
    assert np.array_equal(read.offsets, written.offsets)


def test_hair_is_z_up_and_thickness_a_diameter(tmp_path):
    path = tmp_path / "a.hair"
    path.write_bytes(hair_bytes())
    read = read_hair(path)
    assert np.array_equal(read.points, from_blender(np.arange(15, dtype=np.float32).reshape(5, 3)))
    assert np.allclose(read.radii, 0.05)
    assert read.offsets.tolist() == [0, 2, 5]


def test_hair_without_arrays_has_the_defaults(tmp_path):
    path = tmp_path / "a.hair"
    path.write_bytes(hair_bytes(points=6, bits=2, default=(2, 0.5)))
    read = read_hair(path)
    assert read.offsets.tolist() == [0, 3, 6]
    assert np.allclose(read.radii, 0.25)


def test_hair_may_have_transparency_and_colour(tmp_path):
    path = tmp_path / "a.hair"
    path.write_bytes(hair_bytes(bits=31))
    assert np.allclose(read_hair(path).radii, 0.05)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"HAIR", r"size: found 4 bytes, expected a header of 128"),
        (hair_bytes(magic=b"BEAR"), r"byte 0: found b'BEAR'"),
        (hair_bytes(bits=39), r"bit array: found 39"),
        (hair_bytes(bits=5), r"expected a file with points"),
        (hair_bytes(strand_count=0), r"strand count: found 0"),
        (hair_bytes()[:-1], r"size: found 211 bytes, expected 212"),
        (hair_bytes(strand_count=2**32 - 1), r"size: found 212 bytes, expected"),
        (hair_bytes(segments=(1, 3)), r"segments: found 6 points, expected 5"),
        (hair_bytes(strand_count=5, segments=(0,) * 5), r"segments: found strands of 0 only"),
        (hair_bytes(bits=2, default=(3, 0.5)), r"default segments: found 3"),
        (hair_bytes(thickness=-1.0), r"thickness: found a negative"),
        (hair_bytes(thickness=float("nan")), r"thickness: found a negative or not finite"),
    ],
)
def test_bad_hair(data, message, tmp_path):
    path = tmp_path / "bad.hair"
    path.write_bytes(data)
    with pytest.raises(ValueError, match=rf"^bad\.hair: .*{message}"):
        read_hair(path)


def test_tfx_is_left_handed_and_takes_its_radius_from_the_caller(tmp_path):
    path = tmp_path / "a.tfx"
    path.write_bytes(tfx_bytes())
    read = read_tfx(path, 0.25)
    expected = np.arange(18, dtype=np.float32).reshape(6, 3) * [1, 1, -1]
    assert np.array_equal(read.points, expected)
    assert read.offsets.tolist() == [0, 3, 6]
    assert np.all(read.radii == np.float32(0.25))


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", r"size: found 0 bytes"),
        (tfx_bytes(version=5.0), r"version: found 5, expected 3 or 4"),
        (tfx_4_bytes(offset=12), r"offset of positions: found 12, expected 160 and more"),
        (tfx_4_bytes()[:-4], r"size: found 252 bytes, expected 256"),
        (tfx_bytes(count=0), r"strand count: found 0"),
        (tfx_bytes(points=1), r"points a strand: found 1"),
        (tfx_bytes()[:-4], r"size: found 364 bytes, expected 368"),
        (tfx_bytes(count=2**32 - 1, points=2**32 - 1), r"size: found 368 bytes, expected"),
        (tfx_bytes(positions=np.full(18, np.inf)), r"positions: found point 0 not finite"),
    ],
)
def test_bad_tfx(data, message, tmp_path):
    path = tmp_path / "bad.tfx"
    path.write_bytes(data)
    with pytest.raises(ValueError, match=rf"^bad\.tfx: .*{message}"):
        read_tfx(path, 1.0)


@pytest.mark.parametrize(
    "broken",
    [
        lambda s: Strands(s.points[:-1], s.radii, s.offsets),
        lambda s: Strands(s.points, s.radii, s.offsets[:-1]),
        lambda s: Strands(s.points, s.radii, np.array([0, 1, 9])),
    ],
)
def test_strands_that_do_not_fit_are_refused(broken):
    with pytest.raises(ValueError, match="strands: found"):
        broken(strands())


@pytest.mark.data
def test_a_real_groom(data_folder):
    read = read_tfx(data_folder / "hair" / "tressfx_ponytail" / "tail.tfx", 0.03)
    assert len(read) == 474 and np.all(read.counts == 16)
    root, tip = read.points[read.offsets[:-1]], read.points[read.offsets[1:] - 1]
    assert np.mean(tip[:, 1]) < np.mean(root[:, 1]) - 40.0  # it hangs down
    assert np.all(root[:, 2] < 0.0)  # at the back of a head that looks along +z


def test_hair_of_one_point_is_left_out_with_a_warning(tmp_path):
    path = tmp_path / "a.hair"
    path.write_bytes(hair_bytes(strand_count=3, points=6, segments=(1, 0, 2)))
    with pytest.warns(UserWarning, match=r"^a\.hair: 1 of 3 strands have one point"):
        actual = read_hair(path)
    assert actual.offsets.tolist() == [0, 2, 5]
    assert np.allclose(actual.points[2:], from_blender(np.arange(9, 18.0).reshape(3, 3)))
