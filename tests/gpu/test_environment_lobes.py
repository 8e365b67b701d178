"""Lobes for whole environments in WGSL, against numpy and onnxruntime."""

import numpy as np
import onnxruntime as ort
import pytest

from rna_gpu import Device
from rna_gpu.decoder_packing import pack_decoder
from rna_gpu.part_buffers import part_uniform, upload_planes, upload_weights, weights_file
from rna_gpu.records.part import ROW
from rna_gpu.shaders import compose
from rna_sdk.package import Package, decoder_to_bytes, float_planes, query_width
from rna_sdk.package.decoder.decoder_form import ENVIRONMENT
from tests.conftest import REPOSITORY
from tests.package.builders import random_decoder
from tests.reference.queries import fiber_queries_reference, queries_reference

ASSETS = {
    "surface": REPOSITORY / "examples" / "quickstart" / "toy.rna",
    "fiber": REPOSITORY / "examples" / "fibers" / "curly_ball.rna",
}
COUNT, LOBES = 300, 6

KERNEL = """
@group(1) @binding(0) var<storage, read> rows: array<RnaRow>;
@group(1) @binding(1) var<storage, read> columns: array<vec4f>;
@group(1) @binding(2) var<storage, read_write> results: array<vec4f>; // amplitude, kappa; axis

@compute @workgroup_size(64)
fn find_lobes(@builtin(global_invocation_id) id: vec3<u32>) {
    let row = id.x;
    if row >= arrayLength(&rows) {
        return;
    }
    let at = rows[row];
    let axis = bitcast<vec3f>(at.axis);
    let wo = bitcast<vec3f>(at.wo);
    let m = bitcast<vec3f>(at.wi);
    var visibility: array<vec4f, 4>;
    for (var k = 0u; k < 4u; k++) {
        visibility[k] = columns[4u * row + k];
    }
    let x = bitcast<vec3f>(at.position);
    let place = rna_run_lobes(x, axis, bitcast<f32>(at.h), wo, m, visibility);
    for (var j = 0u; j < RNA_LOBES; j++) {
        let lobe = rna_lobe(place, j, axis, wo, m, bitcast<f32>(at.blue));
        results[2u * (RNA_LOBES * row + j)] = vec4f(lobe.amplitude, lobe.kappa);
        results[2u * (RNA_LOBES * row + j) + 1u] = vec4f(lobe.axis, 0.0);
    }
}
"""


def random_rows(bounds: np.ndarray) -> dict[str, np.ndarray]:
    """Positions, axes and directions to the viewer; mirror visibility and harmonics."""
    rng = np.random.default_rng(0)
    axis, wo = rng.normal(size=(2, COUNT, 3))
    rows = {
        "position": rng.uniform(*bounds, (COUNT, 3)),
        "axis": axis / np.linalg.norm(axis, axis=1, keepdims=True),
        "wo": wo / np.linalg.norm(wo, axis=1, keepdims=True),
        "h": rng.uniform(-1, 1, COUNT),
        "free": rng.uniform(0, 1, COUNT),
        "visibility": rng.uniform(-1, 1, (COUNT, 16)),
    }
    return {name: values.astype(np.float32) for name, values in rows.items()}


def mirror(kind: str, axis: np.ndarray, wo: np.ndarray) -> np.ndarray:
    along = 2 * np.sum(axis * wo, axis=1, keepdims=True) * axis
    return along - wo if kind == "surface" else wo - along


def by_numpy(kind: str, values: np.ndarray, rows: dict[str, np.ndarray]) -> tuple[np.ndarray, ...]:
    """Amplitudes and axes (n, L, 3) of a decoder's results (n, 9 L)."""
    visible, shadowed, axis = np.moveaxis(values.reshape(COUNT, LOBES, 3, 3), 2, 0)
    free = rows["free"][:, None, None]
    wide = 2 * rows["axis"] if kind == "surface" else -2 * rows["wo"]
    sharp = 10 * mirror(kind, rows["axis"], rows["wo"])
    base = np.repeat(np.stack([wide, sharp], axis=1), LOBES // 2, axis=1)
    return free * visible + (1 - free) * shadowed, axis - 8 + base


@pytest.mark.parametrize("with_visibility", [True, False], ids=["told", "untold"])
@pytest.mark.parametrize("kind", list(ASSETS))
def test_lobes(kind, with_visibility, device):
    package = Package.open(ASSETS[kind])
    tier, part = package.manifest.tiers[0], package.manifest.tiers[0].parts[0]
    bounds, planes = package.manifest.parts[0].bounds, package.planes(tier.name)
    rows, more = random_rows(bounds.corners()), 16 if with_visibility else 0
    columns = query_width(part.inputs, part.channels) + more
    decoder = random_decoder(columns, 40, 2, outputs=9 * LOBES, output="environment")
    m = mirror(kind, rows["axis"], rows["wo"])

    arguments = float_planes(planes), bounds.corners(), part.inputs, rows["position"], rows["axis"]
    if kind == "surface":
        queries = queries_reference(*arguments, rows["wo"], m, of_lobes=True)
    else:
        queries = fiber_queries_reference(*arguments, rows["h"], rows["wo"], m)
    session = ort.InferenceSession(decoder_to_bytes(decoder), providers=["CPUExecutionProvider"])
    whole = np.hstack([queries, rows["visibility"][:, :more]])
    amplitudes, axes = by_numpy(kind, session.run(None, {"queries": whole})[0], rows)

    packed = pack_decoder(decoder, part.inputs, part.channels, "lobes", more)
    constants = {"RNA_GROUPS": packed.groups, "RNA_LOBES": LOBES}
    constants |= {"RNA_IS_FIBER": int(kind == "fiber"), "RNA_VISIBILITY_GROUPS": more // 4}
    parts = weights_file(packed), kind, "environment_lobes.wgsl", "row_records.wgsl"
    pipeline = device.pipeline(compose(constants, *parts) + KERNEL, "find_lobes")
    uniform = part_uniform(packed, part, bounds, planes, ENVIRONMENT)
    results = device.buffer(32 * LOBES * COUNT, "STORAGE", what="results")
    groups = (
        [
            device.upload(uniform, "UNIFORM", what="record"),
            upload_weights(device, packed, "lobes"),
            *upload_planes(device, planes, "lobes"),
        ],
        [
            device.upload(_gpu_rows(rows, m), "STORAGE", what="rows"),
            device.upload(rows["visibility"], "STORAGE", what="columns"),
            results,
        ],
    )
    _dispatch(device, pipeline, groups)
    actual = device.read(results, 32 * LOBES * COUNT).view(np.float32).reshape(COUNT, LOBES, 2, 4)
    size = np.sqrt(np.mean(amplitudes**2))
    assert np.abs(actual[:, :, 0, :3] - amplitudes).max() <= 1e-3 * size
    assert np.abs(actual[:, :, 1, :3] - axes).max() <= 1e-3 * np.sqrt(np.mean(axes**2))
    kappa = np.linalg.norm(axes, axis=2)
    assert actual[:, :, 0, 3] == pytest.approx(kappa, rel=1e-3, abs=1e-2)


def _gpu_rows(rows: dict[str, np.ndarray], m: np.ndarray) -> np.ndarray:
    packed = np.zeros(COUNT, ROW.dtype)
    for name, values in {**rows, "wi": m, "blue": rows["free"]}.items():
        if name in packed.dtype.names:
            packed[name] = np.ascontiguousarray(values, np.float32).view(np.uint32)
    return packed


def _dispatch(device: Device, pipeline: object, groups: tuple[list, ...]) -> None:
    with device.working():
        encoder = device.wgpu.create_command_encoder()
        step = encoder.begin_compute_pass()
        step.set_pipeline(pipeline)
        for k, buffers in enumerate(groups):
            entries = [{"binding": i, "resource": {"buffer": b}} for i, b in enumerate(buffers)]
            layout = pipeline.get_bind_group_layout(k)
            step.set_bind_group(k, device.wgpu.create_bind_group(layout=layout, entries=entries))
        device.groups(COUNT).dispatch(step)
        step.end()
        device.wgpu.queue.submit([encoder.finish()])
