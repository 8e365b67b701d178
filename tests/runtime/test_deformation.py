"""Rest points of deformed shapes: rigid motion, bending, stretching, triangles without area."""

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Curves, Mesh
from rna_sdk.runtime import Transform, load
from rna_sdk.runtime.deformation import DeformedCurves, DeformedMesh, RestCurves, RestMesh
from tests.render.strands import curls, straight
from tests.runtime.points import unit_vectors


def rotation(seed: int) -> np.ndarray:
    matrix, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return matrix * np.sign(np.linalg.det(matrix))


def placed(seed: int) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation(seed), (0.3, -0.2, 0.5)
    return matrix


def grid(side: int = 12) -> Mesh:
    """A wavy sheet over [0, 1]^2, smooth normals."""
    t = np.linspace(0, 1, side)
    x, z = (a.reshape(-1) for a in np.meshgrid(t, t, indexing="ij"))
    positions = np.stack([x, 0.1 * np.sin(5 * x) * np.cos(4 * z), z], axis=1)
    slope = np.stack(
        [
            -0.5 * np.cos(5 * x) * np.cos(4 * z),
            np.ones_like(x),
            0.4 * np.sin(5 * x) * np.sin(4 * z),
        ],
        1,
    )
    normals = slope / np.linalg.norm(slope, axis=1, keepdims=True)
    i, j = (a.reshape(-1) for a in np.meshgrid(*[np.arange(side - 1)] * 2, indexing="ij"))
    a = i * side + j
    quads = np.stack([a, a + 1, a + side + 1, a, a + side + 1, a + side], axis=1)
    return Mesh(*np.float32([positions, normals]), None, np.uint32(quads.reshape(-1, 3)))


def hits(count: int, primitives: int, seed: int = 0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    u, v = rng.uniform(0, 1, (2, count))
    inside = u + v > 1
    u[inside], v[inside] = 1 - u[inside], 1 - v[inside]
    return rng.integers(0, primitives, count).astype(np.int32), np.float32(u), np.float32(v)


def at(values: np.ndarray, triangles: np.ndarray, place: tuple) -> np.ndarray:
    triangle, u, v = place
    a, b, c = np.moveaxis(values[triangles[triangle]].astype(float), 1, 0)
    return (1 - u - v)[:, None] * a + u[:, None] * b + v[:, None] * c


def unit(v: np.ndarray) -> np.ndarray:
    return v / np.linalg.norm(v, axis=1, keepdims=True)


def posed(mesh: Mesh, positions: np.ndarray) -> DeformedMesh:
    return RestMesh(mesh).deformed(np.float32(positions))


@pytest.mark.parametrize("seed", range(4))
def test_rigid_motion_of_a_mesh_is_its_transform(seed):
    mesh, transform = grid(), Transform(placed(seed))
    shape = posed(mesh, transform.to_world_points(mesh.positions))
    expected = transform.to_world_normals(mesh.normals)
    np.testing.assert_allclose(shape.mesh.normals, expected, atol=2e-6)
    place = hits(500, len(mesh.triangles))
    rest = shape.rest_points(*place)
    np.testing.assert_allclose(rest.positions, at(mesh.positions, mesh.triangles, place), atol=1e-7)
    n = unit(at(mesh.normals, mesh.triangles, place))
    np.testing.assert_allclose(rest.axes, n, atol=1e-6)
    wi = unit_vectors(np.random.default_rng(seed), 500)
    np.testing.assert_allclose(rest.to_rest(wi), transform.to_object_directions(wi), atol=1e-5)
    np.testing.assert_allclose(rest.to_deformed(rest.to_rest(wi)), wi, atol=1e-6)


def test_rigid_motion_by_half_a_turn(asset_path):
    """The decoder of a whole asset gives what it gives at rest; the tetrahedron has hard edges."""
    asset = load(asset_path())
    matrix = np.diag([-1.0, 1.0, -1.0, 1.0])
    transform = Transform(matrix)
    place = hits(200, 4)
    shape = asset.deformed(transform.to_world_points(asset.mesh.positions))
    rest = shape.rest_points(*place)
    wo, wi = (unit_vectors(np.random.default_rng(k), 200) for k in (1, 2))
    actual = asset.evaluate(rest.positions, rest.axes, rest.to_rest(wo), rest.to_rest(wi))
    x, n = (at(a, asset.mesh.triangles, place) for a in (asset.mesh.positions, asset.mesh.normals))
    turned = transform.to_object_directions(wo), transform.to_object_directions(wi)
    expected = asset.evaluate(np.float32(x), np.float32(n), *turned)
    np.testing.assert_allclose(actual, expected, rtol=1e-3, atol=1e-5)


@pytest.mark.parametrize(
    "curves", [curls(40), curls(1), straight(((0, 0, 0), (0.1, 0.4, 0), (0.5, 0.6, 0.3)))]
)
@pytest.mark.parametrize("seed", range(3))
def test_rigid_motion_of_strands_is_their_transform(curves, seed):
    """Twist included, which the tangents alone do not tell."""
    transform = Transform(placed(seed))
    shape = RestCurves(curves).deformed(transform.to_world_points(curves.points))
    segments = curves.segments()
    segment = np.random.default_rng(0).integers(0, len(segments), 300).astype(np.int32)
    u = np.random.default_rng(1).uniform(0, 1, 300).astype(np.float32)
    first = segments[segment]
    t = unit((curves.points[first + 1] - curves.points[first]).astype(float))
    n = np.float32(unit(np.cross(t, unit_vectors(np.random.default_rng(2), 300))))
    rest = shape.rest_points(segment, u, transform.to_world_normals(n))
    wi = unit_vectors(np.random.default_rng(seed), 300)
    np.testing.assert_allclose(rest.to_rest(wi), transform.to_object_directions(wi), atol=2e-4)
    np.testing.assert_allclose(rest.axes, t, atol=1e-6)
    radius = (1 - u) * curves.radii[first] + u * curves.radii[first + 1]
    centre = (1 - u)[:, None] * curves.points[first] + u[:, None] * curves.points[first + 1]
    np.testing.assert_allclose(rest.positions, centre + radius[:, None] * n, atol=2e-5)


def test_motion_of_one_straight_strand_turns_by_the_smallest_angle():
    curves = straight(((0, 0, 0), (0, 1, 0), (0, 2, 0)))
    shape = RestCurves(curves).deformed(np.float32([[0, 0, 0], [1, 0, 0], [2, 0, 0]]))
    rest = shape.rest_points(np.int32([0, 1]), np.zeros(2, np.float32), np.float32([[0, 0, 1]] * 2))
    actual = rest.to_rest(np.float32([[1, 0, 0], [0, 0, 1]]))
    np.testing.assert_allclose(actual, [[0, 1, 0], [0, 0, 1]], atol=1e-5)


def test_motion_of_strands_on_skin_that_turns_about_them():
    """Straight hair on a disc that spins: only the neighbours tell the twist."""
    rng = np.random.default_rng(0)
    roots = np.column_stack([rng.uniform(-1, 1, 200), np.zeros(200), rng.uniform(-1, 1, 200)])
    points = np.stack([roots + np.array([0, h, 0]) for h in (0, 0.5, 1)], axis=1)
    offsets = np.arange(0, 601, 3).astype(np.uint32)
    curves = Curves(np.float32(points.reshape(-1, 3)), np.full(600, 0.01, np.float32), offsets)
    quarter = np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]], float)
    shape = RestCurves(curves).deformed(np.float32(curves.points @ quarter.T))
    count = len(curves.segments())
    n = np.tile(np.float32([1, 0, 0]), (count, 1))
    rest = shape.rest_points(np.arange(count), np.zeros(count, np.float32), n)
    np.testing.assert_allclose(
        rest.to_rest(n), np.tile(quarter.T @ [1, 0, 0], (count, 1)), atol=1e-4
    )


def test_motion_along_a_bent_strand_carries_the_twist():
    """A strand bent about z to a half circle: each segment turns about z alone."""
    height = np.linspace(0, 1, 21)
    rest_points = np.column_stack([0 * height, height, 0 * height])
    angle = np.pi * height
    bent = np.column_stack([-(1 - np.cos(angle)), np.sin(angle), 0 * angle]) / np.pi
    curves = Curves(*np.float32([rest_points]), np.full(21, 0.01, np.float32), np.uint32([0, 21]))
    shape = RestCurves(curves).deformed(np.float32(bent))
    z = np.tile(np.float32([0, 0, 1]), (20, 1))
    rest = shape.rest_points(np.arange(20), np.zeros(20, np.float32), z)
    np.testing.assert_allclose(rest.to_rest(z), z, atol=1e-4)
    tangents = np.float32(unit(np.diff(bent, axis=0)))
    np.testing.assert_allclose(rest.to_rest(tangents), np.tile([0, 1, 0], (20, 1)), atol=1e-4)


def test_motion_that_bends_a_sheet_turns_normals_with_it():
    """A flat sheet rolled into a cylinder; deformed normals, and directions, follow it."""
    flat = grid(40)
    sheet = Mesh(
        np.float32(flat.positions * (1, 0, 1)),
        np.tile(np.float32([0, 1, 0]), (1600, 1)),
        None,
        flat.triangles,
    )
    angle = sheet.positions[:, 0].astype(float)
    rolled = np.column_stack([np.sin(angle), np.cos(angle), sheet.positions[:, 2]])
    shape = posed(sheet, rolled)
    outward = rolled * (1, 1, 0)
    inner = (sheet.positions[:, 0] > 0.05) & (sheet.positions[:, 0] < 0.95)
    np.testing.assert_allclose(shape.mesh.normals[inner], outward[inner], atol=1e-3)
    place = hits(400, len(sheet.triangles))
    rest = shape.rest_points(*place)
    n = np.float32(unit(at(shape.mesh.normals, sheet.triangles, place)))
    np.testing.assert_allclose(rest.to_rest(n), np.tile([0, 1, 0], (400, 1)), atol=1e-6)
    along = np.tile(np.float32([0, 0, 1]), (400, 1))  # the cylinder's axis stays
    np.testing.assert_allclose(rest.to_rest(along), along, atol=2e-3)


@pytest.mark.parametrize(("x", "z"), [(2.0, 1.0), (0.5, 0.5), (1.0, 3.0)])
def test_motion_that_stretches_along_axes_turns_nothing(x, z):
    """A flat sheet: the stretch is symmetric, so its polar rotation is the identity."""
    flat = grid()
    up = np.tile(np.float32([0, 1, 0]), (len(flat.positions), 1))
    sheet = Mesh(np.float32(flat.positions * (1, 0, 1)), up, None, flat.triangles)
    shape = posed(sheet, sheet.positions * (x, 1, z))
    rest = shape.rest_points(*hits(300, len(sheet.triangles)))
    wi = unit_vectors(np.random.default_rng(0), 300)
    np.testing.assert_allclose(rest.to_rest(wi), wi, atol=1e-5)


def test_motion_that_shears_turns_by_the_polar_rotation():
    flat = grid()
    up = np.tile(np.float32([0, 1, 0]), (len(flat.positions), 1))
    sheet = Mesh(np.float32(flat.positions * (1, 0, 1)), up, None, flat.triangles)
    shear = np.array([[1, 0, 0.8], [0, 1, 0], [0, 0, 1]])
    shape = posed(sheet, sheet.positions @ shear.T)
    rest = shape.rest_points(*hits(300, len(sheet.triangles)))
    left, _, right = np.linalg.svd(shear)
    wi = unit_vectors(np.random.default_rng(0), 300)
    np.testing.assert_allclose(rest.to_rest(wi), wi @ (left @ right), atol=1e-5)


def test_motion_makes_no_seam_where_vertices_are_doubled():
    """As on cuts of texture coordinates: one place, one normal, two vertices."""
    mesh = grid()
    corners = mesh.triangles.reshape(-1)
    soup = Mesh(
        mesh.positions[corners],
        mesh.normals[corners],
        None,
        np.arange(len(corners), dtype=np.uint32).reshape(-1, 3),
    )
    bent = mesh.positions + np.float32([0, 0.3, 0]) * mesh.positions[:, :1] ** 2
    whole, cut = posed(mesh, bent), posed(soup, bent[corners])
    np.testing.assert_allclose(cut.mesh.normals, whole.mesh.normals[corners], atol=1e-6)


@pytest.mark.parametrize("collapse", ["point", "line"])
def test_motion_onto_a_point_or_line_has_an_answer(collapse):
    mesh = grid(4)
    moved = mesh.positions * np.float32(0 if collapse == "point" else (1, 0, 0))
    shape = posed(mesh, moved)
    place = hits(50, len(mesh.triangles))
    rest = shape.rest_points(*place)
    wi = unit_vectors(np.random.default_rng(0), 50)
    np.testing.assert_array_equal(rest.to_rest(wi), wi)
    np.testing.assert_array_equal(shape.mesh.normals, mesh.normals)
    np.testing.assert_allclose(rest.positions, at(mesh.positions, mesh.triangles, place), atol=1e-7)


def test_motion_of_one_flat_triangle_turns_as_its_normal_does():
    mesh = grid(6)
    turned = mesh.positions @ np.float32(rotation(1)).T
    turned[mesh.triangles[7]] = turned[mesh.triangles[7, 0]]
    shape = posed(mesh, turned)
    place = np.int32([7]), np.float32([0.3]), np.float32([0.3])
    rest = shape.rest_points(*place)
    assert np.isfinite(rest.rotations).all()
    n = np.float32(unit(at(shape.mesh.normals, mesh.triangles, place)))
    np.testing.assert_allclose(rest.to_rest(n), rest.axes, atol=1e-6)


def test_motion_onto_a_point_of_strands_has_an_answer():
    curves = curls(5)
    shape = RestCurves(curves).deformed(np.zeros_like(curves.points))
    count = len(curves.segments())
    n = np.tile(np.float32([0, 1, 0]), (count, 1))
    rest = shape.rest_points(np.arange(count), np.zeros(count, np.float32), n)
    assert np.isfinite(rest.rotations).all() and np.isfinite(rest.positions).all()
    assert np.diff(shape.curves.points, axis=0).any(axis=1).all()


def test_motion_is_the_same_on_any_threads():
    from rna_sdk.machine.kernel_threads import limit_kernel_threads

    mesh, bent = grid(), grid().positions[:, [1, 2, 0]]
    results = []
    for count in (1, 2):
        limit_kernel_threads(count)
        shape = posed(mesh, bent)
        rest = shape.rest_points(*hits(999, len(mesh.triangles)))
        results.append([a.tobytes() for a in (shape.mesh.normals, rest.rotations, rest.positions)])
    assert results[0] == results[1]


@pytest.mark.parametrize(
    ("positions", "message"),
    [
        (np.zeros((3, 3), np.float32), r"positions: expected a \(144, 3\) float32 array"),
        (np.zeros((144, 3)), r"float32 array, found \(144, 3\) float64"),
        (np.full((144, 3), np.nan, np.float32), "positions: row 0 is .*, expected finite"),
    ],
)
def test_wrong_positions_of_a_motion(positions, message):
    with pytest.raises(QueryError, match=message):
        RestMesh(grid()).deformed(positions)


def test_wrong_hits_of_a_motion():
    shape, one = posed(grid(), grid().positions), np.zeros(1, np.float32)
    with pytest.raises(QueryError, match="triangle: a number is outside"):
        shape.rest_points(np.int32([242]), one, one)
    with pytest.raises(QueryError, match="v: expected"):
        shape.rest_points(np.int32([0]), one, np.zeros(2, np.float32))
    curved: DeformedCurves = RestCurves(curls(1)).deformed(curls(1).points)
    with pytest.raises(QueryError, match="segment: a number is outside"):
        curved.rest_points(np.int32([-1]), one, np.zeros((1, 3), np.float32))
