"""Fiber packages: curves come back as they were written, and each kind keeps to its own."""

import hashlib
from dataclasses import replace

import numpy as np
import pytest
import safetensors.numpy

from rna_sdk.errors import PackageError, QueryError
from rna_sdk.package import Curves, Package, validate
from tests.package.builders import (
    make_curves,
    make_mesh,
    make_tiny_fiber_package,
)
from tests.package.corpus.curve_cases import with_header
from tests.package.corpus.registry import CURVES

NAMES = ("points", "radii", "offsets")


def test_curves_come_back_as_views(tuft):
    assert validate(tuft) == []
    package = Package.open(tuft)
    assert (package.manifest.parts[0].kind, package.manifest.parts[0].geometry) == ("fiber", CURVES)
    curves, good = package.curves(), make_curves()
    package.close()
    for name in NAMES:
        array = getattr(curves, name)
        np.testing.assert_array_equal(array, getattr(good, name))
        assert array.dtype == getattr(good, name).dtype
        assert not array.flags.writeable and not array.flags.owndata
    assert curves.points.ctypes.data % 64 == 0


def test_same_curves_same_bytes(tmp_path, fiber_entries):
    first, second = (make_tiny_fiber_package(tmp_path / name).read_bytes() for name in "ab")
    assert first == second
    digest = hashlib.sha256(fiber_entries[CURVES]).hexdigest()
    assert digest == "4b39804fdf030c6db035e1a7d5205b908896b87723518c7a1057bcca2279fbfa"


def test_other_software_opens_the_curves(fiber_entries):
    tensors = safetensors.numpy.load(fiber_entries[CURVES])
    assert set(tensors) == set(NAMES)
    for name in NAMES:
        np.testing.assert_array_equal(tensors[name], getattr(make_curves(), name))


def test_segments_start_at_all_points_but_tips():
    curves = make_curves()
    assert curves.segments().tolist() == [0, 1, 2, 4, 6, 7]
    assert curves.segments().dtype == np.uint32


def test_box_holds_every_sphere():
    points = np.float32([[0, 0, 0], [1, 2, 3]])
    curves = Curves(points, np.float32([0.5, 0.25]), np.uint32([0, 2]))
    low, high = curves.box()
    assert low.tolist() == [-0.5, -0.5, -0.5]
    assert high.tolist() == [1.25, 2.25, 3.25]


def test_each_kind_has_its_own_geometry(tiny, tuft):
    with Package.open(tuft) as fiber, Package.open(tiny) as surface:
        with pytest.raises(QueryError, match=r"a fiber part has no mesh; ask for its curves\(\)"):
            fiber.mesh()
        with pytest.raises(QueryError, match=r"a surface part has no curves; .* mesh\(\)"):
            surface.curves()
        assert isinstance(fiber.geometry(), Curves)
        np.testing.assert_array_equal(
            surface.geometry().box()[1], make_mesh().positions.max(axis=0)
        )
    with pytest.raises(QueryError, match="closed"):
        fiber.curves()


@pytest.mark.parametrize(
    ("edit", "place"),
    [
        (lambda h: h["offsets"].update(dtype="I64"), "offsets/dtype"),
        (lambda h: h["points"].update(shape=[10**30, 3]), "points/shape"),
        (lambda h: h["points"].update(data_offsets=[False, 108]), "points/data_offsets"),
        (lambda h: h["radii"].update(shape={"0": 9}), "radii/shape"),
        (lambda h: h["radii"].update(data_offsets=[108, 144.5]), "radii/data_offsets"),
        (lambda h: h["offsets"].pop("data_offsets"), "offsets/data_offsets"),
    ],
)
def test_hostile_header_is_refused_where_it_lies(edit, place, fiber_entries, tmp_path):
    path = tmp_path / "x.rna"
    path.write_bytes(with_header(fiber_entries, edit))
    (issue,) = validate(path)
    assert issue.pointer_or_offset == f"{CURVES}#/{place}"


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"points": make_curves().points.astype(np.float64)}, "GEOMETRY_ARRAY"),
        ({"radii": make_curves().radii[:, None]}, "GEOMETRY_ARRAY"),
        ({"offsets": make_curves().offsets.astype(np.int64)}, "GEOMETRY_ARRAY"),
        ({"offsets": np.zeros(0, np.uint32)}, "GEOMETRY_STRANDS"),
        ({"offsets": np.zeros(1, np.uint32)}, "GEOMETRY_STRANDS"),
        ({"offsets": np.uint32([0, 6, 4, 9])}, "GEOMETRY_STRANDS"),
        ({"points": np.zeros((9, 3), np.float32)}, "GEOMETRY_SEGMENT"),
    ],
)
def test_curves_refuse_wrong_arrays(change, code):
    with pytest.raises(PackageError, match=code):
        replace(make_curves(), **change)


def test_strands_may_share_a_point():
    """Two strands that end and start in one place are no segment."""
    points = np.float32([[0, 0, 0], [0, 1, 0], [0, 1, 0], [0, 2, 0]])
    curves = Curves(points, np.ones(4, np.float32), np.uint32([0, 2, 4]))
    assert curves.segments().tolist() == [0, 2]
