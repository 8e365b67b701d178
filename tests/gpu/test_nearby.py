"""Nearby light on the GPU: the columns of the CPU, and pictures of packages that count it."""

import numpy as np
import pytest

import rna_gpu
from rna_gpu import Device
from rna_gpu.records.scene import PATH
from rna_gpu.scene.probe import Probe
from rna_gpu.shaders import compose
from rna_render.paths.sampling import BRANCHES
from rna_render.world.bodies import make_body
from rna_sdk import runtime
from rna_sdk.errors import QueryError
from rna_trace import PartsScene, nearby_light
from rna_trace.nearby import nearby_estimate
from tests.conformance.conftest import KIT
from tests.gpu.scenes import assert_same_numbers, on_cpu, on_gpu
from tests.gpu.test_evaluate import rows

LANTERN = KIT / "packages" / "parts-lantern.rna"  # holes, coloured glass and strands
SURFACE, FIBER = (KIT / "packages" / f"{kind}-nearby.rna" for kind in ("surface", "fiber"))
LENGTHS = (0.02, 0.05, 0.2)

KERNEL = """
@compute @workgroup_size(64)
fn nearby_of(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let path = paths[k];
    let u = vec2f(path.b1, path.b2);
    start_passing(PASS_MOST);
    let root = rna_instances[0].root;
    let shares = nearby_light(root, frame.lengths, path.origin, path.direction, path.t, u);
    sums[k] = vec4f(shares, 0.0);
}
"""

# A package of two decoders, one in int8, with base colour; another of strands; a lamp near both.
GLOWING = f"""
assets:
  - path: {SURFACE}
    tier: print
    transform: {{rotation_deg: [0, 25, 0]}}
  - path: {SURFACE}
    tier: one
    transform: {{translation: [1.6, 0, -0.9], scale: -0.7}}
  - path: {FIBER}
    transform: {{translation: [-0.4, 0.6, 0.4], rotation_deg: [30, 0, 0], scale: 1.5}}
ground: {{height: -0.7}}
camera: {{position: [1.4, 1.7, 4.6], look_at: [0.4, -0.2, 0], vertical_fov_deg: 40}}
lights:
  - {{type: directional, direction: [0.5, 0.9, 0.3], irradiance: [1.5, 1.4, 1.2]}}
  - {{type: sphere, position: [0.3, 0.9, 0.8], radius: 0.2, radiance: [9, 9, 7]}}
  - {{type: environment, radiance: [0.3, 0.4, 0.6]}}
resolution: [40, 28]
samples: 2
max_depth: 2
"""


class Columns:
    """Columns of light of the lantern, on the GPU and on the CPU."""

    def __init__(self, device: Device) -> None:
        self.scene: PartsScene = make_body(runtime.load(LANTERN)).scene
        self._probe = Probe(LANTERN, device)
        made = self._probe._bindings
        source = compose({}, "render/probe", "render/nearby_light.wgsl") + KERNEL
        pipeline = device.pipeline(source, "nearby_of", [made.path, made.empty, made.scene])
        made.pipeline = lambda *_, **__: pipeline
        self._probe._frame["lengths"] = LENGTHS

    def points(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """Where random rays meet it, and random directions of light."""
        rng = np.random.default_rng(0)
        d, wi = rng.normal(size=(2, 4 * count, 3)).astype(np.float32)
        d, wi = (v / np.linalg.norm(v, axis=1, keepdims=True) for v in (d, wi))
        origin = rng.uniform(-0.4, 0.4, d.shape).astype(np.float32) - 4 * d
        t = self.scene.intersect(origin, d).t
        met = np.flatnonzero(np.isfinite(t))[:count]
        assert len(met) == count
        return (origin + t[:, None] * d)[met], wi[met]

    def on_gpu(self, x: np.ndarray, wi: np.ndarray, u: np.ndarray, far: object) -> np.ndarray:
        paths = np.zeros(len(x), PATH.dtype)
        paths["origin"], paths["direction"], paths["t"] = x, wi, far
        paths["b1"], paths["b2"] = u.T
        return self._probe._run("nearby_of", paths)


@pytest.fixture(scope="module")
def columns(device):
    return Columns(device)


def test_a_column_is_that_of_the_cpu(columns):
    """Through holes and panes, onto strands, of lights far away and inside of the lantern."""
    n = 3000
    x, wi = columns.points(n)
    u = np.random.default_rng(1).random((n, 2)).astype(np.float32)
    for far in (np.float32(1e30), np.float32(0.3)):
        actual = columns.on_gpu(x, wi, u, far)
        expected = nearby_estimate(columns.scene, LENGTHS, x, wi, u.astype(float), far)
        assert 0.1 < (expected > 0).mean() < 0.95 and actual.max() < 10.0
        same = np.isclose(actual, expected, rtol=1e-3, atol=1e-4).all(axis=1)
        assert same.mean() > 0.998


def test_columns_one_by_one_have_the_mean_of_many(columns):
    points, rays = 12, 4000
    x, wi = columns.points(points)
    expected = nearby_light(columns.scene, LENGTHS, x, wi, rays, seed=3)
    u = np.random.default_rng(2).random((points * rays, 2)).astype(np.float32)
    each = columns.on_gpu(x.repeat(rays, axis=0), wi.repeat(rays, axis=0), u, np.float32(1e30))
    mean = each.reshape(points, rays, 3).mean(axis=1)
    assert mean == pytest.approx(expected, abs=0.04)
    assert (expected.std(axis=0) > 0.05).all()


def test_the_picture_is_that_of_the_cpu(scene, device, monkeypatch):
    monkeypatch.setattr("rna_render.paths.integrator.STRAND_BRANCHES", BRANCHES)
    scene_file, world = scene(GLOWING)
    actual = on_gpu(scene_file, world, lambda: device).channels()
    assert_same_numbers(actual, on_cpu(scene_file, world).channels())


@pytest.mark.parametrize("tier", ["one", "print"])
def test_queries_have_the_means_of_the_part_without_it(tier, device):
    gpu, cpu = rna_gpu.load(SURFACE, tier, device), runtime.load(SURFACE, tier)
    assert gpu.nearby_lengths == cpu.nearby_lengths
    queries = rows(200, cpu.bounds)
    means, shares = gpu.evaluate(*queries), queries[-1]
    for found, expected in zip(means, cpu.evaluate(*queries), strict=True):
        np.testing.assert_allclose(found, expected, rtol=2e-3, atol=2e-3)
    lit = np.hstack(gpu.evaluate(*queries, nearby=shares))
    np.testing.assert_allclose(
        lit, np.hstack(cpu.evaluate(*queries, nearby=shares)), rtol=2e-3, atol=2e-3
    )
    assert np.abs(lit - np.hstack(means)).mean() > 0.05 * lit.mean()
    with pytest.raises(QueryError, match=r"nearby: expected a \(200, 3\) float32 array"):
        gpu.evaluate(*queries, nearby=shares[:3])
