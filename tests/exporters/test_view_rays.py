import numpy as np
import pytest

from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.capture_directions import reflect
from rna_export.capture.rays.view_rays import sample_view_rays
from tests.exporters.meshes import ring, sphere

WI = np.float32([0.36, 0.8, 0.48])


@pytest.mark.parametrize("domain", ["sphere", "hemisphere"])
@pytest.mark.parametrize("mesh", [sphere(3), ring()], ids=["ball", "ring"])
def test_every_ray_hits(mesh, domain):
    scene = AssetScene([mesh])
    rays = sample_view_rays(scene, WI, 3000, domain, np.random.default_rng(0))
    assert len(rays) == 3000
    assert (scene.part_hit(rays.origins, rays.directions) == 0).all()
    assert np.allclose(np.linalg.norm(rays.directions, axis=1), 1.0, atol=1e-5)


def test_hemisphere_looks_from_above():
    scene = AssetScene([ring()])
    rays = sample_view_rays(scene, WI, 2000, "hemisphere", np.random.default_rng(0))
    assert rays.directions[:, 1].max() <= 0.0


def test_some_rays_start_close():
    scene = AssetScene([sphere(4)])
    rays = sample_view_rays(scene, WI, 4000, "sphere", np.random.default_rng(0))
    height = np.linalg.norm(rays.origins, axis=1) - 1.0
    assert np.mean(height < 0.2) > 0.02
    assert height.min() > -1e-3  # none starts inside


def test_the_highlight_is_looked_at():
    scene = AssetScene([sphere(4)])
    rays = sample_view_rays(scene, WI, 8000, "sphere", np.random.default_rng(0))
    points = scene.shade_points(rays.origins, rays.directions)
    normals = points.on[0].points.n
    mirror = reflect(np.broadcast_to(WI, normals.shape), normals)
    near = np.sum(mirror * -rays.directions, axis=1) > 0.98
    uniform = (1.0 - 0.98) / 2.0
    assert near.mean() > 4.0 * uniform


def test_a_seed_repeats():
    scene = AssetScene([sphere(3)])
    first, again, other = (
        sample_view_rays(scene, WI, 500, "sphere", np.random.default_rng(seed))
        for seed in (1, 1, 2)
    )
    assert np.array_equal(first.origins, again.origins)
    assert not np.array_equal(first.origins, other.origins)
