"""Rays meet on the GPU what they meet in Embree."""

from typing import Any

import numpy as np

from rna_gpu import Device
from rna_gpu.bvh import LEAF, MAX_DEPTH, build_tree
from rna_gpu.geometry import Geometry, Placed, Strands, Triangles, build_geometry
from rna_gpu.shaders import compose
from rna_sdk import runtime
from rna_sdk.package import Curves
from rna_trace.embree.instances import Instance, InstanceScene
from rna_trace.parts_scene import PartsScene
from tests.gpu.test_evaluate import BALL, TOY

TRACE = """
@group(1) @binding(0) var<storage, read> rays: array<RnaRay>;
@group(1) @binding(1) var<storage, read_write> hits: array<RnaHit>;
@compute @workgroup_size(64)
fn trace(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&rays) {
        hits[id.x] = rna_trace(rays[id.x], RNA_NOTHING, 7u, ANY == 1u);
    }
}
"""
RAY = np.dtype([("origin", "<f4", 3), ("near", "<f4"), ("direction", "<f4", 3), ("far", "<f4")])
HIT = np.dtype(
    [
        *(("t", "<f4"), ("instance", "<u4"), ("primitive", "<u4"), ("b", "<f4", 2)),
        *(("_", "<f4", 3), ("normal", "<f4", 3), ("__", "<f4")),
    ]
)


def traced(
    device: Device, geometry: Geometry, origins: np.ndarray, directions: np.ndarray, any_hit: bool
) -> np.ndarray:
    rays = np.zeros(len(origins), RAY)
    rays["origin"], rays["direction"], rays["far"] = origins, directions, 1e30
    source = compose({"ANY": int(any_hit)}, "trace") + TRACE
    pipeline = device.pipeline(source, "trace")
    hits = device.buffer(len(rays) * HIT.itemsize, "STORAGE", what="hits")

    def bind(group: int, buffers: list[Any]) -> Any:
        return device.wgpu.create_bind_group(
            layout=pipeline.get_bind_group_layout(group),
            entries=[{"binding": k, "resource": {"buffer": b}} for k, b in enumerate(buffers)],
        )

    arrays = geometry.nodes, geometry.primitives, geometry.points, geometry.instances
    scene = [device.upload(values, "STORAGE", what="geometry") for values in arrays]
    encoder = device.wgpu.create_command_encoder()
    step = encoder.begin_compute_pass()
    step.set_pipeline(pipeline)
    step.set_bind_group(0, bind(0, []))
    step.set_bind_group(1, bind(1, [device.upload(rays, "STORAGE", what="rays"), hits]))
    step.set_bind_group(2, bind(2, scene))
    device.groups(len(rays)).dispatch(step)
    step.end()
    device.wgpu.queue.submit([encoder.finish()])
    return device.read(hits, len(rays) * HIT.itemsize).view(HIT)


def test_the_tree_holds_everything_once():
    rng = np.random.default_rng(0)
    low = rng.uniform(-1, 1, (1000, 3)) ** 3
    low[:300] = 0.25  # a heap in one place
    boxes = np.stack([low, low + rng.uniform(0, 0.1, (1000, 3))], axis=1).astype(np.float32)
    nodes, order = build_tree(boxes)
    assert sorted(order) == list(range(1000))
    seen = []

    def walk(node: int, depth: int) -> None:
        assert depth <= MAX_DEPTH
        at = nodes[node]
        if at["count"]:
            held = order[at["child"] : at["child"] + at["count"]]
            assert len(held) <= LEAF
            assert (boxes[held, 0] >= at["low"]).all() and (boxes[held, 1] <= at["high"]).all()
            seen.extend(held)
            return
        for child in (node + 1, int(at["child"])):
            assert (nodes[child]["low"] >= at["low"]).all()
            walk(child, depth + 1)

    walk(0, 0)
    assert sorted(seen) == list(range(1000))


def test_hits_are_those_of_embree(device):
    toy, ball = runtime.load(TOY), runtime.load(BALL)
    assert isinstance(toy, runtime.SurfaceAsset) and isinstance(ball, runtime.FiberAsset)
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]) * 0.7
    matrices = [np.eye(4) for _ in range(3)]
    matrices[1][:3, :3], matrices[1][:3, 3] = turn, (1.5, 0.3, 0)
    matrices[2][:3, 3] = 0, 0, -2.5
    bodies = [0, 1, 0]
    mesh = toy.mesh
    shapes = [
        [Triangles(mesh.positions, mesh.normals, mesh.triangles, np.zeros(len(mesh.triangles)))],
        [Strands(ball.curves, 1)],
    ]
    placed = [Placed(body, matrix, 7) for body, matrix in zip(bodies, matrices, strict=True)]
    geometry = build_geometry(shapes, placed)
    scenes = [PartsScene([mesh]), PartsScene([ball.curves])]
    embree = InstanceScene(
        [Instance(scenes[body], matrix) for body, matrix in zip(bodies, matrices, strict=True)]
    )
    rng = np.random.default_rng(0)
    origins = rng.uniform(-3, 3, (8000, 3)).astype(np.float32)
    aims = (
        rng.uniform(-0.4, 0.4, (8000, 3))
        + np.array([m[:3, 3] for m in matrices])[rng.integers(0, 3, 8000)]
    )
    directions = aims - origins
    directions = (directions / np.linalg.norm(directions, axis=1, keepdims=True)).astype("f4")
    expected = embree.intersect(origins, directions)
    actual = traced(device, geometry, origins, directions, any_hit=False)
    hit = actual["instance"] != 0xFFFFFFFF
    assert 0.2 < hit.mean() < 0.99
    assert (hit == (expected.instance >= 0)).mean() > 0.999  # outlines
    both = hit & (expected.instance >= 0)
    same = np.abs(actual["t"] - expected.t)[both] < 1e-4
    assert same.mean() > 0.998
    instance = geometry.order[actual["instance"][both]]
    assert (instance == expected.instance[both]).mean() > 0.999
    strands = both & (expected.instance == 1)
    cosine = (actual["normal"][strands] * expected.ng[strands]).sum(axis=1)
    assert (cosine > 0.999).mean() > 0.99
    any_hit = traced(device, geometry, origins, directions, any_hit=True)
    assert np.array_equal(any_hit["instance"] != 0xFFFFFFFF, hit)


def test_hits_of_tapered_strands_are_placed_as_by_embree(device):
    """u belongs to the sphere that touches there, on cones whose radii change by half."""
    points = np.array([[0, 0, 0], [0, 0, 0.2], [0.1, 0.1, 0.3]], np.float32)
    curves = Curves(points, np.array([0.12, 0.02, 0.05], np.float32), np.array([0, 3], np.uint32))
    geometry = build_geometry([[Strands(curves, 1)]], [Placed(0, np.eye(4), 7)])
    rng = np.random.default_rng(0)
    origins = rng.normal(size=(2000, 3)).astype(np.float32)
    aims = points[rng.integers(0, 3, 2000)] + rng.uniform(-0.08, 0.08, (2000, 3))
    directions = aims - origins
    directions = (directions / np.linalg.norm(directions, axis=1, keepdims=True)).astype("f4")
    expected = PartsScene([curves]).intersect(origins, directions)
    actual = traced(device, geometry, origins, directions, any_hit=False)
    both = (actual["instance"] == 0) & (expected.geometry == 0)
    places = actual["b"][both, 0]
    assert both.mean() > 0.5 and ((places > 0.05) & (places < 0.95)).mean() > 0.2
    assert (np.abs(places - expected.u[both]) < 1e-3).mean() > 0.99
