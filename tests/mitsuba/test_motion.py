"""Assets in motion in Mitsuba: rest points as those of the SDK, pictures as those of rna-run."""

from pathlib import Path

import numpy as np
import pytest

from rna_sdk.errors import MotionError
from rna_sdk.motion import write_motion
from rna_sdk.runtime import load
from tests.conftest import REPOSITORY
from tests.mitsuba.test_images import assert_both_alike

TOY = REPOSITORY / "examples" / "quickstart" / "toy.rna"
BALL = REPOSITORY / "examples" / "fibers" / "curly_ball.rna"


def bent(positions: np.ndarray, angle: float = 0.8) -> np.ndarray:
    """Turned about z, the more the higher, and stretched."""
    turn = angle * positions[:, 1:2].astype(float)
    x, y, z = positions.T.astype(float)
    c, s = np.cos(turn[:, 0]), np.sin(turn[:, 0])
    return np.stack([c * x - s * y, s * x + c * y, 1.1 * z], axis=1).astype(np.float32)


def write_bend(path: Path, package: Path) -> Path:
    part = load(package)
    geometry = part.curves if part.kind == "fiber" else part.mesh
    rest = geometry.points if part.kind == "fiber" else geometry.positions
    write_motion(path, [geometry], [[rest], [bent(rest)]], count=2, rate=24)
    return path


@pytest.mark.parametrize("package", [TOY, BALL], ids=["surface", "fiber"])
def test_rest_points_are_those_of_the_sdk(package, tmp_path):
    import mitsuba as mi

    from rna_mitsuba.shape import load_package
    from rna_mitsuba.tracing import Hits

    motion = write_bend(tmp_path / "bend.rnam", package)
    scene = load_package(str(package), None, (str(motion), 1.0)).scene
    part, rng, count = load(package), np.random.default_rng(5), 200
    is_fiber = part.kind == "fiber"
    shape = part.deformed(bent(part.curves.points if is_fiber else part.mesh.positions))
    total = len(shape.curves.segments()) if is_fiber else len(shape.mesh.triangles)
    number = rng.integers(total, size=count).astype(np.int32)
    u, v = rng.uniform(0, 0.5, (2, count)).astype(np.float32)
    d = rng.normal(size=(3, count)).astype(np.float32)
    d /= np.linalg.norm(d, axis=0)
    at = mi.UInt32(number.view(np.uint32)), mi.Float(u), mi.Float(v)
    hits = Hits(mi.Float(np.ones(count)), mi.UInt32(np.zeros(count, np.uint32)), *at)
    geometry, way, active = scene.geometries[0], mi.Vector3f(d), mi.Bool(np.ones(count, bool))
    origin = mi.Point3f(0)
    if is_fiber:  # the hit is where the ray ends
        first = shape.curves.segments()[number]
        a, b = shape.curves.points[first], shape.curves.points[first + 1]
        c = a + u[:, None] * (b - a)
        n = np.cross(b - a, d.T)
        n /= np.linalg.norm(n, axis=1, keepdims=True)
        origin, way = mi.Point3f((c + n).T - d), mi.Vector3f(d)
    points = geometry.points(*at, origin, way, active)
    expected = shape.rest_points(number, u, np.float32(points.n).T if is_fiber else v)
    arguments = scene.query(0, hits, points, points.query(way) | {"wi": -way}, active)
    np.testing.assert_allclose(np.array(arguments["position"]).T, expected.positions, atol=2e-5)
    np.testing.assert_allclose(np.array(arguments["axis"]).T, expected.axes, atol=2e-4)
    wo = expected.to_rest(np.ascontiguousarray(d.T))
    np.testing.assert_allclose(np.array(arguments["wo"]).T, wo, atol=1e-3)
    np.testing.assert_allclose(np.array(arguments["wi"]).T, -wo, atol=1e-3)


def test_both_show_the_same_bent_asset(tmp_path):
    import rna_mitsuba
    from tests.mitsuba.scene_pairs import Pair, sun

    motion = write_bend(tmp_path / "bend.rnam", TOY)
    light = (-0.6, 0.5, 0.7), (2.5, 2.4, 2.2)
    ours = {"path": str(TOY), "motion": {"path": str(motion), "start": 1}}
    pair = Pair(
        {
            "assets": [ours],
            "lights": [{"type": "directional", "direction": light[0], "irradiance": light[1]}],
        },
        {"toy": rna_mitsuba.asset(TOY, motion=motion, frame=1), "sun": sun(*light)},
        {"position": (1.5, 0.95, 1.2), "look_at": (0.45, 0.25, -0.05), "vertical_fov_deg": 30},
        2,
    )
    assert_both_alike(pair, 16, tmp_path)


def test_a_frame_that_is_not_there_is_told(tmp_path):
    import mitsuba as mi

    import rna_mitsuba

    motion = write_bend(tmp_path / "bend.rnam", TOY)
    with pytest.raises((MotionError, RuntimeError), match="has frames 0 to 1, and no frame 5"):
        mi.load_dict(rna_mitsuba.asset(TOY, motion=motion, frame=5))
