"""Directions for rays that leave assets, in WGSL: they follow their densities, those of rna-run."""

import numpy as np
import pytest

from rna_gpu.records.tables import lobe_fields
from rna_gpu.scene.scene_images import Images
from rna_gpu.scene.scene_surfaces import Surfaces
from rna_gpu.shaders import compose
from rna_render.world.neural_sampling import LobeMixture
from rna_sdk.package.manifest.extensions import (
    USUAL_SAMPLING,
    FiberLobe,
    MirrorLobe,
    Mixture,
    Sampling,
)
from rna_sdk.package.packing import Unpacked
from rna_sdk.runtime import load
from tests.package.builders import make_tiny_package
from tests.render.chi_squared import assert_directions_follow
from tests.runtime.points import unit_vectors

COUNT = 1 << 16
MIXTURES = {
    "cosine": Mixture(cosine=0.9),
    "mirror": Mixture(mirror=(MirrorLobe(share=0.9, width=0.3),)),
    "narrow": Mixture(cosine=0.1, mirror=(MirrorLobe(share=0.8, width=1e-3),)),
    "forward": Mixture(forward=FiberLobe(share=0.9, width=0.3)),
    "cone": Mixture(cone=(FiberLobe(share=0.9, width=0.1),)),
    "surfaces": Mixture(
        cosine=0.3,
        mirror=tuple(MirrorLobe(share=0.2, width=width) for width in (0.2, 0.3, 0.4)),
    ),
    "fibers": USUAL_SAMPLING["fiber"],
}
KERNEL = """
const PI: f32 = 3.14159265358979;
struct Setting { lobes: array<vec4f, 2>, axis: vec4f, wo: vec4f }
@group(0) @binding(0) var<storage, read> setting: Setting;
@group(0) @binding(1) var<storage, read> rows: array<vec4f>; // u, or a direction
@group(0) @binding(2) var<storage, read_write> results: array<vec4f>; // wi, pdf

@compute @workgroup_size(64)
fn sampled(@builtin(global_invocation_id) id: vec3<u32>) {
    let lobes = Lobes(IS_FIBER == 1u, setting.lobes[0], setting.lobes[1]);
    let at = lobe_frame(setting.axis.xyz, setting.axis.xyz, setting.wo.xyz);
    var wi = rows[id.x].xyz;
    if rows[id.x].w == 0.0 {
        wi = lobe_sample(at, lobes, wi.xy);
    }
    results[id.x] = vec4f(wi, lobe_density(at, lobes, wi));
}
"""
FILES = "render/directions.wgsl", "render/ggx.wgsl", "render/lobes.wgsl"


@pytest.mark.parametrize("name", MIXTURES)
def test_directions_follow_their_density(name, device):
    mixture = MIXTURES[name]
    is_fiber = bool(mixture.cone or mixture.forward)
    pipeline = device.pipeline(compose({"IS_FIBER": int(is_fiber)}, *FILES) + KERNEL, "sampled")
    axis, wo = unit_vectors(np.random.default_rng(1), 2)
    lobes = lobe_fields(mixture)
    setting = np.float32([*lobes.values(), [*axis, 0.0], [*wo, 0.0]])

    def run(rows: np.ndarray) -> np.ndarray:
        padded = np.zeros((-(-len(rows) // 64) * 64, 4), np.float32)
        padded[: len(rows)] = rows
        results = device.buffer(padded.nbytes, "STORAGE", what="results")
        given = [device.upload(a, "STORAGE", what="rows") for a in (setting, padded)]
        entries = [
            {"binding": k, "resource": {"buffer": buffer}}
            for k, buffer in enumerate([*given, results])
        ]
        layout = pipeline.get_bind_group_layout(0)
        with device.working():
            encoder = device.wgpu.create_command_encoder()
            step = encoder.begin_compute_pass()
            step.set_pipeline(pipeline)
            step.set_bind_group(0, device.wgpu.create_bind_group(layout=layout, entries=entries))
            step.dispatch_workgroups(len(padded) // 64)
            step.end()
            device.wgpu.queue.submit([encoder.finish()])
        return device.read(results, padded.nbytes).view(np.float32).reshape(-1, 4)[: len(rows)]

    u = np.random.default_rng(2).random((COUNT, 2))
    found = run(np.float32([*u.T, np.zeros(COUNT), np.zeros(COUNT)]).T)
    placed = LobeMixture.of(mixture).everywhere
    tiled = [np.tile(vector, (COUNT, 1)) for vector in (axis, axis, wo)]
    expected = placed.pdf(*tiled, found[:, :3])
    tolerance = 2e-2 if name == "narrow" else 1e-3
    np.testing.assert_allclose(found[:, 3], expected, rtol=tolerance, atol=1e-5)
    if name != "narrow":
        assert_directions_follow(
            found[:, :3], lambda w: run(np.hstack([w, np.ones((len(w), 1))]))[:, 3]
        )


def test_triangles_have_the_lobes_of_their_mixture(tmp_path):
    package = Unpacked.read(make_tiny_package(tmp_path / "tiny.rna"))
    mixtures = MIXTURES["cosine"], MIXTURES["mirror"].model_copy(update={"first": 2})
    package.with_extension(Sampling(parts=(mixtures,)), {}).write(tmp_path / "tiny.rna")
    surfaces = Surfaces(Images())
    (triangles,) = surfaces.add(load(tmp_path / "tiny.rna"), 0, 0)
    for triangle, surface in enumerate(triangles.surface):
        for name, numbers in lobe_fields(mixtures[triangle >= 2]).items():
            assert surfaces.rows[surface][name] == pytest.approx(numbers)
