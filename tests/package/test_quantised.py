"""Quantised geometry: near the original, the same arrays from every file, opened by others."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh

from rna_sdk.package import Curves, Mesh, Package, quantise, write_package
from rna_sdk.package.geometry.curves_file import curves_from_bytes, curves_to_bytes
from rna_sdk.package.geometry.geometry_files import Geometry, geometry_from_bytes, geometry_to_bytes
from rna_sdk.package.geometry.glb_reader import mesh_from_glb
from rna_sdk.package.geometry.glb_writer import mesh_to_glb
from rna_sdk.package.geometry.quantised_curves import QuantisedCurves
from tests.package.builders import make_curves, make_manifest, make_mesh, make_tier, make_tier_data


def make_ball(subdivisions: int = 4) -> Mesh:
    ball = trimesh.creation.icosphere(subdivisions)
    normals = np.array(ball.vertices, np.float32)
    return Mesh(
        np.float32(0.37) * normals + np.float32([1.5, -0.2, 7.0]),
        normals,
        np.abs(normals[:, :2]),
        np.array(ball.faces, np.uint32),
    )


def make_tuft(strands: int = 50, points: int = 20, radius: float = 0.002) -> Curves:
    rng = np.random.default_rng(3)
    roots = rng.normal(0, 0.2, (strands, 1, 3))
    walk = np.cumsum(rng.normal(0, 0.004, (strands, points, 3)), axis=1)
    return Curves(
        np.float32(roots + walk).reshape(-1, 3),
        np.float32(np.tile(np.linspace(radius, radius / 3, points), strands)),
        np.arange(0, strands * points + 1, points, dtype=np.uint32),
    )


def arrays_of(geometry: Geometry) -> dict[str, np.ndarray]:
    return {k: v for k, v in vars(geometry).items() if isinstance(v, np.ndarray)}


def assert_same(a: Geometry, b: Geometry) -> None:
    first, second = arrays_of(a), arrays_of(b)
    assert first.keys() == second.keys()
    for name, array in first.items():
        np.testing.assert_array_equal(array, second[name], err_msg=name)
        assert array.dtype == second[name].dtype


@pytest.mark.parametrize(
    "geometry",
    [
        make_mesh(),
        make_mesh(uvs=False),
        make_ball(),
        replace(make_ball(), uvs=make_ball().uvs * 3),
        make_curves(),
        make_tuft(),
        make_tuft(radius=2e-7),
    ],
    ids=["flat", "no uvs", "ball", "uvs beyond 1", "strands", "tuft", "fine steps"],
)
def test_file_gives_back_the_very_arrays(geometry):
    kind = "surface" if isinstance(geometry, Mesh) else "fiber"
    quantised = quantise(geometry)
    data = geometry_to_bytes(quantised, kind, "/geometry")
    again = geometry_from_bytes(memoryview(data), "entry", kind)
    assert_same(quantised, again)
    assert again.quantised is not None
    assert geometry_to_bytes(again, kind, "/geometry") == data
    assert quantise(again) is again


def test_mesh_is_off_by_half_a_step():
    mesh = make_ball()
    quantised = quantise(mesh)
    low, high = mesh.box()
    step = float((high - low).max()) / 65535
    assert quantised.quantised.scale[0] == step
    assert np.abs(quantised.positions - mesh.positions).max() < 0.51 * step + 5e-7
    assert np.abs(quantised.normals - mesh.normals).max() < 3e-5
    assert np.abs(np.linalg.norm(quantised.normals.astype(np.float64), axis=1) - 1).max() < 1e-7
    assert np.abs(quantised.uvs - mesh.uvs).max() < 0.51 / 65535
    assert len(mesh_to_glb(quantised)) < 0.6 * len(mesh_to_glb(mesh))


def test_strands_are_off_by_half_a_step():
    curves = make_tuft()
    quantised = quantise(curves)
    step = quantised.quantised.scales[0]
    assert step < curves.radii.min() / 50
    # Steps add up exactly, so that the tip is as good as the root.
    assert np.abs(quantised.points - curves.points).max() < 0.51 * step + 1e-7
    assert np.abs(quantised.radii / curves.radii - 1).max() < 0.01
    assert quantised.quantised.steps.dtype == np.int16
    assert quantised.quantised.radii.dtype == np.uint8
    assert len(curves_to_bytes(quantised)) < 0.52 * len(curves_to_bytes(curves))


def test_radii_of_a_fine_tip_take_16_bits():
    curves = make_tuft()
    tapered = replace(curves, radii=np.where(curves.radii < 0.0007, 1e-5, curves.radii))
    quantised = quantise(tapered)
    assert quantised.quantised.radii.dtype == np.uint16
    assert np.abs(quantised.radii / tapered.radii - 1).max() < 0.01


def test_points_within_a_step_are_left_out():
    points = np.float32([[0, 0, 0], [1e-9, 0, 0], [1, 0, 0], [1, 1e-8, 0], [0, 1, 0]])
    short = np.float32([[0, 0, 2], [0, -1e-9, 2], [0, -2e-9, 2]])
    curves = Curves(
        np.concatenate([points, short]), np.full(8, 0.01, np.float32), np.uint32([0, 5, 8])
    )
    quantised = quantise(curves)
    assert quantised.offsets.tolist() == [0, 3, 5]
    step = quantised.quantised.scales[0]
    np.testing.assert_allclose(quantised.points[:3], points[[0, 2, 4]], atol=step)
    assert quantised.points[3:].tolist() == [[0, 0, 2], [0, -step, 2]]


def test_far_from_the_origin_no_two_points_meet():
    curves = make_tuft(radius=1e-5)
    far = quantise(replace(curves, points=curves.points + np.float32(1000)))
    assert far.quantised.scales[0] > 1e-5 / 50
    assert_same(far, curves_from_bytes(memoryview(curves_to_bytes(far)), "entry"))


def test_rule_of_the_specification():
    """Worked by hand: two strands, of three points and of two."""
    stored = QuantisedCurves(
        scales=np.float32([0.5, 0.25]),
        origins=np.float32([[1, 2, 3], [0, 0, 0]]),
        offsets=np.uint32([0, 3, 5]),
        steps=np.int16([[1, 0, 0], [1, -2, 0], [0, 0, 7]]),
        radii=np.uint8([1, 2, 3, 4, 5]),
    )
    curves = stored.restored()
    expected = [[1, 2, 3], [1.5, 2, 3], [2, 1, 3], [0, 0, 0], [0, 0, 3.5]]
    assert curves.points.tolist() == expected
    assert curves.radii.tolist() == [0.25, 0.5, 0.75, 1.0, 1.25]


def test_changed_copy_is_no_longer_quantised():
    mesh = quantise(make_ball())
    moved = replace(mesh, positions=mesh.positions + np.float32(0.1))
    assert moved.quantised is None
    again = mesh_from_glb(memoryview(mesh_to_glb(moved)), "entry")
    np.testing.assert_array_equal(again.positions, moved.positions)


def test_many_vertices_have_long_indices():
    ball = make_ball(7)
    assert len(ball.positions) > 65535
    quantised = quantise(ball)
    assert_same(quantised, mesh_from_glb(memoryview(mesh_to_glb(quantised)), "entry"))


def test_a_package_has_the_quantised_mesh(tmp_path):
    tier = make_tier()
    data = {"small": make_tier_data(tier)}
    mesh = quantise(make_mesh())
    write_package(tmp_path / "x.rna", make_manifest(tier), [mesh], data)
    with Package.open(tmp_path / "x.rna") as package:
        assert_same(package.mesh(), mesh)


def test_other_software_opens_a_quantised_mesh(tmp_path):
    mesh = quantise(make_ball())
    (tmp_path / "mesh.glb").write_bytes(mesh_to_glb(mesh))
    loaded = trimesh.load(tmp_path / "mesh.glb", process=False).to_geometry()
    np.testing.assert_array_equal(loaded.faces, mesh.triangles)
    np.testing.assert_allclose(loaded.vertices, mesh.positions, rtol=0, atol=1e-6)
