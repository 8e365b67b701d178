"""Light that assets send out: seen, thrown on other things, never on themselves."""

import numpy as np
import pytest

from rna_render.lights import AssetEmission, AssetLight
from rna_render.world.placements import emission_of
from rna_trace.embree import TriangleScene
from rna_trace.embree.tracing import closest_hits, rays_of
from tests.render.assets import FiberProbe, LambertAsset, merged, sphere, square
from tests.render.chi_squared import assert_directions_follow
from tests.render.glowing import Composite, GlowingStrands, GlowingSurface, Record
from tests.render.lights import at, independent_samples
from tests.render.stage import SKY, rgb
from tests.render.strands import straight
from tests.render.studio import assert_is, at_point, flat, made_of, seen, shoot
from tests.render.test_transport_assets import upside_down
from tests.render.test_transport_interreflection import inside
from tests.render.test_transport_lights import parallel_rectangle

GLOW = np.array([1.0, 2.0, 3.0])
WHITE = (1.0, 1.0, 1.0)
BLACK = (0.0, 0.0, 0.0)
WAYS = ["both", "lights", "rays"]


def plate(**changes) -> GlowingSurface:
    return GlowingSurface(square(1.0), albedo=BLACK, glow=tuple(GLOW), **changes)


def test_emission_is_seen_and_scaled_by_the_instance():
    camera = at_point((0, 0, 0))
    actual = seen(shoot([(plate(), {"scale": 0.5})], camera=camera, samples=1))
    np.testing.assert_allclose(actual.mean, GLOW, rtol=1e-6)
    channels = shoot([(plate(), {})], camera=camera, samples=1)
    assert (channels["A"] == 1).all() and (channels["assetId"] == 1).all()


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("h", [0.5, 1.0])
def test_a_glowing_plate_lights_the_ground_as_the_analytic_rectangle(h, way):
    floor = made_of(square(50.0))
    objects = [(floor, {}), (plate(one_sided=True), upside_down(h))]
    samples = 64 if way == "rays" else 16
    settings = {"camera": at_point((0, 0, 0), (0.3, 0.2, 2.0)), "max_depth": 1}
    actual = seen(shoot(objects, (), way, samples=samples, **settings))
    assert_is(actual, GLOW * parallel_rectangle(1, 1, h), relative=0.01)


@pytest.mark.parametrize("way", WAYS)
def test_a_glowing_instance_lights_others_of_its_kind_but_not_itself(way):
    """A roof over a floor, glowing: as one asset it adds nothing, as two it lights the floor."""
    roof = inside(square(1.0, height=1.0))
    both = merged(square(0.002), roof)
    together = GlowingSurface(both, WHITE, WHITE, glow=tuple(GLOW), one_sided=True)
    camera = {"camera": at_point((0, 0, 0), (0.3, 0.2, 2.0)), "max_depth": 4}
    camera["samples"] = 64 if way == "rays" else 24
    alone = seen(shoot([(together, {})], (), way, **camera))
    np.testing.assert_allclose(alone.mean, GLOW, rtol=1e-6)
    floor = LambertAsset(square(0.002), albedo=WHITE)
    lit = seen(shoot([(floor, {}), (plate(one_sided=True), upside_down(1.0))], (), way, **camera))
    assert_is(lit, GLOW * parallel_rectangle(1, 1, 1.0), relative=0.01)
    pair = [(plate(), {"scale": 0.002}), (plate(), upside_down(1.0))]
    black = seen(shoot(pair, (), way, **camera))
    np.testing.assert_allclose(black.mean, GLOW, rtol=1e-6)  # its albedo is 0: only its own glow


@pytest.mark.parametrize("way", WAYS)
def test_a_glowing_furnace(way):
    """A white ball in a black shell that glows with 1 vanishes; one that glows itself adds that."""
    shell = GlowingSurface(inside(flat(sphere(2, radius=3.0))), albedo=BLACK, one_sided=True)
    body = flat(sphere(2, radius=0.5))
    ball = LambertAsset(body, albedo=WHITE)
    asset = GlowingSurface(body, albedo=WHITE, glow=tuple(GLOW))
    settings = {"camera": at_point((0, 0.45, 0), (0.3, 0.8, 1.8)), "samples": 48, "max_depth": 2}
    for scene_object, extra in ((ball, 0), (asset, GLOW)):
        actual = seen(shoot([(scene_object, {}), (shell, {})], (), way, **settings))
        assert_is(actual, 1 + extra, relative=0.01)


@pytest.mark.parametrize("way", ["both", "rays"])
def test_glowing_strands_light_what_is_beside_them(way):
    """A strand that is as good as infinite, over the middle of the floor.

    Offsets s across it, in radii, are at angles asin(r s / height) from the vertical, and the
    cosine-weighted integral along an infinite line at such an angle is cos(angle) pi / 2.
    """
    r, height = 0.05, 1.0
    strand = GlowingStrands(straight(((-40, height, 0), (40, height, 0)), radius=r),
                            glow=tuple(GLOW))  # fmt: skip
    floor = made_of(square(3.0))
    samples = 400
    settings = {"camera": at_point((0, 0, 0), (0.3, 0.4, 2.0)), "max_depth": 1}
    actual = seen(shoot([(floor, {}), (strand, {})], (), way, samples=samples, **settings))
    s = (np.arange(2000) + 0.5) / 1000 - 1
    angle = np.arcsin(r * s / height)
    width = np.gradient(angle)
    irradiance = np.sum((1 - s**2) * np.cos(angle) * width) * np.pi / 2
    assert_is(actual, GLOW * irradiance / np.pi, relative=0.03)


def test_a_package_without_emission_is_no_light():
    assert emission_of(LambertAsset(square())) is None
    assert isinstance(emission_of(plate()), AssetEmission)


def bent(slope: float = 3.0) -> Composite:
    """Two meshes that glow more towards +x, one that does not, and strands."""
    first = GlowingSurface(square(1.0), glow=tuple(GLOW), slope=slope)
    dull = LambertAsset(square(0.3, height=5.0))
    second = GlowingSurface(square(0.5, height=-0.5), glow=tuple(GLOW), slope=slope)
    return Composite((dull, first, GlowingStrands(straight(((3, 0, 0), (3, 1, 0)))), second))


def test_samples_follow_the_density_and_rays_agree():
    matrix = np.diag([2.0, 2.0, 2.0, 1.0])
    matrix[:3, 3] = 0.3, -0.2, 0.1
    asset, x = bent(), (0.4, 2.5, 0.3)
    light = AssetLight(AssetEmission(asset), matrix, 0.5)
    drawn = independent_samples(light, x, 200_000)
    assert (drawn.pdf > 0).mean() > 0.9999

    def density(d):
        """Summed over both plates, one behind the other; no ray meets both first."""
        total = np.zeros(len(d))
        for part in (1, 3):
            total += radiance_and_pdf(light, asset, part, matrix, x, d)[1]
        return total

    assert_directions_follow(drawn.wi_world, density, (0, -1, 0), np.radians(60), 0.015)
    # More samples where it is brighter.
    y = np.float32(x) + drawn.distance[:, None] * drawn.wi_world
    assert np.mean(y[:, 0] > 0.3) > 0.55
    for part in (1, 3):
        radiance, pdf = radiance_and_pdf(light, asset, part, matrix, x, drawn.wi_world)
        same = (np.abs(distance(asset, part, matrix, x, drawn.wi_world) / drawn.distance - 1)
                < 1e-5)  # fmt: skip
        assert same.mean() > 0.1
        np.testing.assert_allclose(pdf[same], drawn.pdf[same], rtol=1e-3)
        np.testing.assert_allclose(radiance[same], drawn.radiance[same], rtol=1e-3)


def hits_of(asset, part, matrix, x, d):
    mesh = asset.parts[part].mesh
    scene = TriangleScene([(mesh.positions, mesh.triangles)])
    inverse = np.linalg.inv(matrix)
    origin = (inverse[:3, :3] @ x + inverse[:3, 3]).astype(np.float32)
    return closest_hits(scene.handle, rays_of(np.tile(origin, (len(d), 1)), d))


def distance(asset, part, matrix, x, d):
    return hits_of(asset, part, matrix, x, d).t * np.float32(matrix[0, 0])


def radiance_and_pdf(light, asset, part, matrix, x, d):
    """Radiance and density of rays from x that meet one of its meshes, 0 for others."""
    hits = hits_of(asset, part, matrix, x, d)
    hit = np.flatnonzero(hits.primitive >= 0)
    rows = hits.take(hit)
    rows.geometry[:] = part
    radiance, pdf = np.zeros((len(d), 3), np.float32), np.zeros(len(d), np.float32)
    radiance[hit], pdf[hit] = light.eval_hit(at(x, len(hit)), d[hit], rows, rows.ng)
    return radiance, pdf


def test_strands_alone_are_no_light_to_sample():
    strand = GlowingStrands(straight(((0, 0, 0), (0, 1, 0))))
    light = AssetLight(AssetEmission(strand), np.eye(4))
    drawn = independent_samples(light, (1, 0, 0), 64)
    assert light.power(1.0) == 0 and not drawn.pdf.any() and not drawn.radiance.any()


def test_what_lets_light_through_sends_out_less():
    """A half transparent glowing plate: 0.4 of its own light and 0.6 of the sky behind it."""
    texels = np.full((1, 1, 1), 153, np.uint8)
    thin = GlowingSurface(
        square(1.0), albedo=BLACK, glow=tuple(GLOW), transmittance_records=(Record(0, 2, texels),)
    )
    camera = at_point((0, 0, 0))
    actual = seen(shoot([(thin, {})], [SKY], camera=camera, samples=512))
    assert_is(actual, 0.4 * GLOW + 0.6, relative=0.02)
    floor = made_of(square(50.0))
    settings = {"camera": at_point((0, 0, 0), (0.3, 0.2, 2.0)), "max_depth": 1}
    for way in WAYS:
        samples = 192 if way == "rays" else 48
        objects = [(floor, {}), (thin, upside_down(1.0))]
        lit = seen(shoot(objects, (), way, samples=samples, **settings))
        assert_is(lit, 0.4 * GLOW * parallel_rectangle(1, 1, 1.0), relative=0.02)


def test_parts_are_each_evaluated_with_their_own():
    """A red plate, a glowing blue one and a strand, side by side, one asset."""
    red = LambertAsset(square(0.4), albedo=(1, 0, 0))
    blue_mesh = square(0.4)
    blue_mesh = type(blue_mesh)(blue_mesh.positions + np.float32([1, 0, 0]), blue_mesh.normals,
                                None, blue_mesh.triangles)  # fmt: skip
    blue = GlowingSurface(blue_mesh, albedo=(0, 0, 1), glow=(0, 1, 0))
    hair = FiberProbe(straight(((-1, 0, -0.4), (-1, 0, 0.4))))
    sun = {"type": "directional", "direction": (0, 1, 0), "irradiance": (np.pi,) * 3}
    asset = Composite((red, hair, blue))
    objects = [(asset, {}), (asset, {"translation": (0, 0, 2)})]
    # 0.0054, 0.0112 and 0.0005 is what the plates light it by, measured with 1024 samples.
    strand = (np.pi + 0.0054, np.pi / 2 + 0.0112, 0.2505)
    for z in (0, 2):
        for x, expected in ((0, (1, 0, 0)), (1, (0, 1, 1)), (-1, strand)):
            camera = at_point((x, 0.1 * (x < 0), z), (x, 3.0, z + 1e-3))
            actual = seen(shoot(objects, [sun], camera=camera, samples=16))
            assert (np.abs(actual.mean - expected) < 4.0 * actual.error + 5e-4).all()


def test_brightness_of_what_it_lights_does_not_depend_on_the_way():
    """A glowing ball in several parts among other assets under a dim sky, whole images."""
    ball = GlowingSurface(sphere(3, radius=0.5), albedo=(0.5,) * 3, glow=(4, 3, 2), slope=2.0)
    twigs = GlowingStrands(straight(((0, 0, 0), (1, 1, 0)), radius=0.05), glow=(2, 2, 5))
    lamp = Composite((ball, twigs))
    objects = [
        (made_of(square(4.0)), {"translation": (0, -0.6, 0)}),
        (lamp, {}),
        (LambertAsset(sphere(3, radius=0.4), albedo=(0.7, 0.7, 0.7)), {"translation": (1.2, 0, 0)}),
    ]
    sky = SKY | {"radiance": (0.05,) * 3}
    camera = {"position": (0.5, 1.2, 4.0), "look_at": (0.4, 0, 0), "vertical_fov_deg": 40}
    means = {}
    for way in ("both", "rays"):
        channels = shoot(objects, [sky], way, camera=camera, samples=192, max_depth=4)
        means[way] = rgb(channels).reshape(-1, 3).mean(axis=0)
    np.testing.assert_allclose(means["both"], means["rays"], rtol=0.01)
