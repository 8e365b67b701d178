"""Pictures do not change with the size of a scene, its place, or what lies far away."""

from pathlib import Path

import numpy as np
import pytest

from rna_render import load_world, make_integrator, render
from rna_render.scene.core_yaml import dump_yaml
from rna_render.scene.scene_file import read_scene
from rna_trace.embree import TriangleScene
from rna_trace.embree.instances import Instance, InstanceScene
from rna_trace.hit_points import Frames, Lines, hit_points, stepped
from tests.conftest import REPOSITORY
from tests.render.far_scenes import GREY, VARIANTS, assert_same_picture, scene
from tests.runtime.points import unit_vectors


def picture(folder: Path, **arguments: object) -> dict[str, np.ndarray]:
    file = scene(folder, **arguments)
    return render(file.scene, make_integrator(file.resolved, load_world(file))).channels()


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    return picture(tmp_path_factory.mktemp("near"))


@pytest.mark.parametrize("name", VARIANTS)
def test_a_picture_is_the_same_at_any_scale(name, expected, tmp_path):
    """A ray of light started 0.66 m off the ground where a hill was 10 km away."""
    assert_same_picture(picture(tmp_path, **VARIANTS[name]), expected)


@pytest.mark.parametrize("far", [1e3, 1e4, 1e5])
def test_an_assets_picture_is_the_same_with_a_black_hill(far, tmp_path):
    """What changes with a grey one, .15 as high as it is far, is its own light."""
    hill = tmp_path / "hill.obj"
    corners = [(-far, 0, -far), (far, 0, -far), (far, 0.15 * far, -far), (-far, 0.15 * far, -far)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners]
    hill.write_text("\n".join([*lines, "f 1 2 3", "f 1 3 4", ""]))
    black = {"path": "hill.obj", "material": {"type": "diffuse", "color": [0.0, 0.0, 0.0]}}
    pictures = []
    for objects in ([], [black]):
        (tmp_path / "scene.yaml").write_text(dump_yaml(TOY | {"objects": objects}))
        file = read_scene(tmp_path / "scene.yaml")
        world = load_world(file)
        pictures.append(render(file.scene, make_integrator(file.resolved, world)).channels())
    assert_same_picture(pictures[1], pictures[0])


TOY = {
    "assets": [{"path": str(REPOSITORY / "examples" / "quickstart" / "toy.rna")}],
    "ground": {"height": 0, "material": GREY},
    "camera": {"position": [1.6, 0.9, 0.9], "look_at": [0, 0.1, 0], "vertical_fov_deg": 30},
    "lights": [{"type": "directional", "direction": [1, 2, 0.5], "irradiance": 3}],
    "resolution": [96, 64],
    "samples": 1,
}


def test_a_tilted_floor_of_40_km_keeps_its_shadows(tmp_path):
    """It is exact to its float32 coordinates alone: the steps of rays are some 10 mm."""
    small = picture(tmp_path, floor=4e3, tilt=10.0)
    assert_same_picture(picture(tmp_path, floor=4e4, tilt=10.0), small)


def test_positions_are_those_of_the_scene_file(tmp_path):
    image = picture(tmp_path, at=(1e5, 0.0, 1e5))
    ground = np.abs(image["normal.Y"]) > 0.9
    assert ground.sum() > 100
    for axis, middle in (("X", 1e5), ("Y", 0.0), ("Z", 1e5)):
        assert (np.abs(image[f"position.{axis}"][ground] - middle) < 60.0).all()


def random_triangle(rng: np.random.Generator, kind: str) -> np.ndarray:
    """(3, 3) float32, from a millimetre to 10,000 km wide."""
    size = 10.0 ** rng.uniform(-3, 7)
    corners = size * rng.normal(size=(3, 3))
    if kind == "level":
        corners[:, 1] = rng.normal()
    elif kind == "sliver":
        corners[2] = corners[0] + 0.4 * (corners[1] - corners[0])
        corners[2] += size * 10.0 ** rng.uniform(-4, 0) * rng.normal(size=3)
    return corners.astype(np.float32)


def random_frame(rng: np.random.Generator) -> np.ndarray:
    """(4, 4) of a turn or none, any scale and a place."""
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    matrix = np.eye(4)
    matrix[:3, :3] = turn * np.sign(np.linalg.det(turn)) if rng.random() < 0.6 else np.eye(3)
    matrix[:3, :3] *= 10.0 ** rng.uniform(-3, 3)
    matrix[:3, 3] = 10.0 ** rng.uniform(-2, 5) * rng.normal(size=3)
    return matrix


@pytest.mark.parametrize("kind", ["any", "level", "sliver"])
def test_no_ray_meets_the_triangle_that_it_leaves(kind):
    rng, met = np.random.default_rng(5), 0
    for _ in range(150):
        corners, matrix = random_triangle(rng, kind), random_frame(rng)
        target = matrix[:3, :3] @ (rng.dirichlet([1, 1, 1]) @ corners) + matrix[:3, 3]
        towards = unit_vectors(rng, 1)[0].astype(np.float64)
        matrix[:3, 3] -= target - 10.0 ** rng.uniform(-2, 3) * towards  # the camera is at 0
        body = TriangleScene([(corners, np.uint32([[0, 1, 2]]))])
        world = InstanceScene([Instance(body, matrix)])
        rays = np.tile(towards.astype(np.float32), (64, 1))
        rays += 0.01 * unit_vectors(rng, 64)
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
        hits = world.intersect(np.zeros_like(rays), rays)
        row = np.flatnonzero(hits.instance == 0)
        scale = np.cbrt(np.linalg.det(matrix[:3, :3]))
        rotation = matrix[:3, :3] / scale
        frames = Frames(rotation[None], np.array([scale]), matrix[None, :3, 3].copy())
        lines = Lines(np.zeros_like(rays[row]), rays[row], np.zeros(len(row), np.int32), frames)
        found = hit_points(
            corners, np.uint32([[0, 1, 2]]), hits.primitive[row], hits.u[row], hits.v[row], lines
        )
        normals = (hits.ng[row] @ rotation.T).astype(np.float32)
        wi = unit_vectors(rng, len(row))
        grazing = np.sum(wi * normals, axis=1, keepdims=True) * normals
        wi[::2] -= 0.999 * grazing[::2]
        origins = stepped(found.x_world, normals, found.step, wi)
        met += len(row)
        assert not world.occluded(origins, wi).any()
    assert met > 3000


@pytest.mark.parametrize(("size", "height", "most"), [(4e4, -1.0, 2e-6), (1.0, 0.0, 1e-12)])
def test_the_step_off_a_level_floor_follows_its_height_alone(size, height, most):
    """At height 0 there is one still: a ray that starts in the plane meets it."""
    corners = size * np.float32([[-1, 0, -1], [1, 0, -1], [0, 0, 2]]) + np.float32([0, height, 0])
    frames = Frames(np.eye(3)[None].copy(), np.ones(1), np.zeros((1, 3)))
    down = np.float32([[0, -1, 0]])
    lines = Lines(-down, down, np.zeros(1, np.int32), frames)
    at = np.zeros(1, np.float32)
    found = hit_points(corners, np.uint32([[0, 1, 2]]), np.zeros(1, np.int32), at, at, lines)
    np.testing.assert_allclose(found.x_world, [[0, height, 0]], atol=1e-9 * size)
    assert 0 < found.step[0] < most
