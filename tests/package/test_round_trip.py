"""Packages are read as written, byte for byte the same each time, and never copied."""

import hashlib
import struct
import zipfile
from dataclasses import replace

import numpy as np
import onnxruntime
import pytest
import safetensors.numpy
import trimesh

from rna_sdk.errors import PackageError, QueryError, RnaError
from rna_sdk.package import (
    Cost,
    Mesh,
    Package,
    TierData,
    Validation,
    float_planes,
    write_package,
)
from rna_sdk.package.container.zip_container import Container, read_file
from tests.package.builders import (
    make_decoder,
    make_manifest,
    make_mesh,
    make_part_data,
    make_planes,
    make_tier,
    make_tier_data,
    make_tier_part,
    make_tiny_package,
    read_entries,
)


def test_arrays_and_manifest_come_back(tmp_path):
    validation = Validation(psnr=38.5, flip=0.02, relative_mse=0.1, images=4, definition="test")
    cost = Cost(multiply_adds=1000, ns_per_query=50.5, threads=2, machine="test")
    small = make_tier(validation=validation, cost=cost)
    large = make_tier("hq", resolution=16, plane_precision="float32", inputs=("features", "wi"))
    manifest = make_manifest(small, large, extras={"note": "grün", "list": [1, 2.5, None]})
    data = {tier.name: make_tier_data(tier) for tier in (small, large)}
    mesh = make_mesh()
    written = write_package(tmp_path / "two.rna", manifest, [mesh], data)

    with Package.open(tmp_path / "two.rna") as package:
        assert package.manifest == written
        assert package.manifest.model_copy(update={"entries": {}}) == manifest
        for name in ("positions", "normals", "uvs", "triangles"):
            np.testing.assert_array_equal(getattr(package.mesh(), name), getattr(mesh, name))
        for name, (tier_data,) in data.items():
            planes = package.planes(name)
            assert planes.dtype == tier_data.planes.dtype
            np.testing.assert_array_equal(planes, tier_data.planes)
            assert bytes(package.decoder(name)) == tier_data.decoder


def test_int8_planes_come_back(tmp_path):
    path = make_tiny_package(tmp_path / "int8.rna", make_tier(plane_precision="int8"))
    planes, written = Package.open(path).planes("small"), make_planes(precision="int8")
    assert (planes.texels.dtype, planes.scales.dtype) == (np.int8, np.float32)
    np.testing.assert_array_equal(planes.texels, written.texels)
    np.testing.assert_array_equal(planes.scales, written.scales)
    expected = written.texels[1, 2, 3, 0] * written.scales[1, 0]
    assert planes.decoded()[1, 2, 3, 0] == expected != 0


@pytest.mark.parametrize("precision", ["float32", "float16", "int8"])
def test_planes_of_any_precision_as_float32(precision):
    stored = make_planes(precision=precision)
    planes = float_planes(stored)
    assert (planes.shape, planes.dtype) == ((3, 8, 8, 4), np.float32)
    scales = stored.scales[:, None, None] if precision == "int8" else 1.0
    texels = stored.texels if precision == "int8" else stored
    np.testing.assert_array_equal(planes, np.float32(texels) * scales)


def test_mesh_without_uvs(tmp_path):
    tier = make_tier()
    mesh = make_mesh(uvs=False)
    write_package(tmp_path / "x.rna", make_manifest(), [mesh], {"small": make_tier_data(tier)})
    assert Package.open(tmp_path / "x.rna").mesh().uvs is None


def test_same_input_same_bytes(tmp_path):
    first = make_tiny_package(tmp_path / "first.rna").read_bytes()
    second = make_tiny_package(tmp_path / "second.rna").read_bytes()
    assert first == second
    assert make_tiny_package(tmp_path / "first.rna", name="other").read_bytes() != first


def test_byte_layout_is_pinned(tmp_path):
    """The container and geometry bytes are part of the format's promise: same input, same file.

    The decoder is left out, as its bytes come from the onnx package.
    """
    path = make_tiny_package(tmp_path / "x.rna")
    entries = read_entries(path)
    digest = hashlib.sha256(entries["geometry/mesh.glb"]).hexdigest()
    assert digest == "dbcaabaf90fd7475bd080cf054a67fe861919515a23140e95fe03fbc2421b814"
    assert struct.unpack_from("<IHHHHH", path.read_bytes()) == (0x04034B50, 20, 0, 0, 0, 0x21)


def test_planes_are_views_of_the_file(tiny):
    package = Package.open(tiny)
    planes = package.planes("small")
    base: object = planes
    while isinstance(base, np.ndarray):
        base = base.base
    assert isinstance(base, memoryview) and base.readonly
    assert not planes.flags.writeable and not planes.flags.owndata
    assert planes.ctypes.data % 64 == 0
    again = package.planes("small")
    assert again.ctypes.data == planes.ctypes.data
    assert not package.mesh().positions.flags.owndata


def test_a_file_that_is_written_in_place_changes_nothing(tiny, tmp_path):
    path = tmp_path / "a.rna"
    path.write_bytes(tiny.read_bytes())
    planes = Package.open(path).planes("small")
    path.write_bytes(bytes(path.stat().st_size))
    np.testing.assert_array_equal(planes, make_planes())
    path.write_bytes(b"")
    np.testing.assert_array_equal(planes, make_planes())


def test_views_outlive_the_package(tiny):
    with Package.open(tiny) as package:
        planes = package.planes("small")
    np.testing.assert_array_equal(planes, make_planes())
    with pytest.raises(QueryError, match="closed"):
        package.mesh()


def test_entries_are_aligned_and_stored(tiny):
    container = Container.of(read_file(tiny), tiny)
    assert all(entry.offset % 64 == 0 for entry in container.entries.values())
    with zipfile.ZipFile(tiny) as archive:
        assert archive.testzip() is None
        infos = archive.infolist()
    assert [info.filename for info in infos] == list(container.entries)
    assert infos[0].filename == "manifest.json"
    assert {info.date_time for info in infos} == {(1980, 1, 1, 0, 0, 0)}


def test_other_software_opens_the_entries(entries, tmp_path):
    planes = safetensors.numpy.load(entries["features/small.safetensors"])["planes"]
    np.testing.assert_array_equal(planes, make_planes())
    (tmp_path / "mesh.glb").write_bytes(entries["geometry/mesh.glb"])
    scene = trimesh.load(tmp_path / "mesh.glb", process=False)
    (shape,) = scene.geometry.values()
    np.testing.assert_array_equal(shape.vertices, make_mesh().positions)
    np.testing.assert_array_equal(shape.faces, make_mesh().triangles)
    session = onnxruntime.InferenceSession(entries["decoders/small.onnx"])
    assert [value.name for value in session.get_inputs()] == ["queries"]


def test_tier_lookup_names_the_tiers(tiny):
    with pytest.raises(QueryError, match=r"no tier 'hq'; this package has: small"):
        Package.open(tiny).planes("hq")


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"planes": make_planes(resolution=4)}, "PLANES_SHAPE"),
        ({"planes": make_planes(precision="float32")}, "PLANES_DTYPE"),
        ({"planes": make_planes(precision="float64")}, "PLANES_DTYPE"),
        ({"planes": make_planes(precision="int8")}, "PLANES_TENSOR"),
        ({"decoder": make_decoder("float32", 4)}, "DECODER_PROFILE"),
    ],
)
def test_writer_refuses_what_does_not_fit(tmp_path, change, code):
    path = tmp_path / "x.rna"
    path.write_bytes(b"what was there before")
    data = replace(make_part_data(make_tier_part()), **change)
    with pytest.raises(PackageError, match=code):
        write_package(path, make_manifest(), [make_mesh()], {"small": [data]})
    assert path.read_bytes() == b"what was there before"
    assert list(tmp_path.iterdir()) == [path]


def test_writer_wants_data_for_each_tier(tmp_path):
    with pytest.raises(PackageError, match="REFERENCE_MISSING"):
        write_package(tmp_path / "x.rna", make_manifest(), [make_mesh()], {})


def test_tiers_may_share_planes(tmp_path):
    shared = {"planes": "features/shared.safetensors"}
    tiers = (make_tier("a", **shared), make_tier("b", **shared))
    decoders = [make_decoder("float32", seed=s) for s in (1, 2)]
    data = {t.name: [TierData(make_planes(), d)] for t, d in zip(tiers, decoders, strict=True)}
    write_package(tmp_path / "x.rna", make_manifest(*tiers), [make_mesh()], data)
    package = Package.open(tmp_path / "x.rna")
    assert package.planes("a").ctypes.data == package.planes("b").ctypes.data

    data["b"] = [TierData(make_planes(seed=9), decoders[1])]
    with pytest.raises(PackageError, match="ENTRY_HASH"):
        write_package(tmp_path / "x.rna", make_manifest(*tiers), [make_mesh()], data)


def test_mesh_refuses_wrong_arrays():
    good = make_mesh()
    for change in (
        {"positions": good.positions.astype(np.float64)},
        {"normals": good.normals[:5]},
        {"triangles": good.triangles.astype(np.int32)},
        {"triangles": good.triangles[:0]},
    ):
        with pytest.raises(RnaError, match="GEOMETRY_ARRAY"):
            replace(good, **change)
    assert isinstance(good, Mesh)
