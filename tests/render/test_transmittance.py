"""Rays through what lets light through: against a plain twin, and against sums by hand."""

import numpy as np
import pytest

from rna_trace.embree import TriangleScene
from rna_trace.embree.instances import Instance, InstanceScene
from rna_trace.fiber import FiberPoints
from rna_trace.parts_scene import PartsScene
from rna_trace.transmittance import Transmittance, TransmittanceTexture
from tests.render.assets import sphere, square
from tests.render.strands import curls

GREY, RED, BLUE = (0.6, 0.6, 0.6), (0.9, 0.3, 0.0), (0.2, 0.5, 1.0)


def flat_texture(colour) -> TransmittanceTexture:
    return TransmittanceTexture(
        np.rint(255 * np.float64(colour)).astype(np.uint8).reshape(1, 1, -1)
    )


PANE = flat_texture(RED)


def layer(mesh, texture) -> Transmittance:
    number = np.zeros(len(mesh.triangles), np.int32)
    uvs = np.ascontiguousarray(mesh.positions[:, [0, 2]])
    return Transmittance(mesh.triangles, uvs, mesh.normals, number, [texture])


def stack(colours) -> TriangleScene:
    """Layers at heights 0, 1, ..., the last of them opaque where it is None."""
    meshes = [square(height=float(k)) for k in range(len(colours))]
    tables = [
        None if colour is None else layer(mesh, flat_texture(colour))
        for mesh, colour in zip(meshes, colours, strict=True)
    ]
    return TriangleScene([(mesh.positions, mesh.triangles) for mesh in meshes], tables)


def upward(n):
    rng = np.random.default_rng(0)
    origins = np.zeros((n, 3), np.float32)
    origins[:, [0, 2]] = rng.uniform(-0.8, 0.8, (n, 2))
    origins[:, 1] = -1
    directions = np.tile(np.float32([0, 1, 0]), (n, 1))
    directions[:, [0, 2]] = rng.uniform(-0.01, 0.01, (n, 2))
    return origins, directions


def stepped(colour) -> np.ndarray:
    return np.rint(255 * np.float64(colour)) / 255


def twin(texels, uv, cutoff=None):
    """Bilinear, repeating, level 0, in plain numpy."""
    h, w, _ = texels.shape
    s, t = uv[:, 0] * w - 0.5, uv[:, 1] * h - 0.5
    i, j = np.floor(s).astype(int), np.floor(t).astype(int)
    a, b = (s - i)[:, None], (t - j)[:, None]
    at = texels.astype(np.float64) / 255
    value = (1 - b) * ((1 - a) * at[j % h, i % w] + a * at[j % h, (i + 1) % w])
    value += b * ((1 - a) * at[(j + 1) % h, i % w] + a * at[(j + 1) % h, (i + 1) % w])
    return value if cutoff is None else (value > cutoff).astype(float)


@pytest.mark.parametrize(("channels", "cutoff"), [(1, None), (3, None), (1, 0.4)])
def test_lookups_are_those_of_the_plain_twin(channels, cutoff):
    rng = np.random.default_rng(1)
    texels = rng.integers(0, 256, (5, 7, channels), np.uint8)
    mesh = square()
    uvs = rng.uniform(-2, 3, (len(mesh.positions), 2)).astype(np.float32)
    number = np.zeros(len(mesh.triangles), np.int32)
    number[1] = -1
    table = Transmittance(
        mesh.triangles, uvs, mesh.normals, number, [TransmittanceTexture(texels, cutoff)]
    )
    n = 2000
    triangle = rng.integers(0, 2, n).astype(np.int32)
    u = rng.uniform(0, 1, n).astype(np.float32)
    v = (rng.uniform(0, 1, n) * (1 - u)).astype(np.float32)
    corners = uvs[mesh.triangles[triangle]].astype(np.float64)
    weights = np.stack([1.0 - u.astype(np.float64) - v, u, v], axis=1)
    expected = twin(texels, np.einsum("nk,nkc->nc", weights, corners), cutoff)
    expected = np.broadcast_to(expected, (n, 3)) * (triangle == 0)[:, None]
    d = np.tile(np.float32([0, 1, 0]), (n, 1))
    actual = table.at(triangle, u, v, d, np.ones(n, bool))
    assert np.mean(np.abs(actual - expected).max(axis=1) < 1e-5) > 0.998  # cutoffs may fall over


def test_an_interface_reflects_by_fresnel_from_both_sides():
    mesh = square()
    white = np.full((1, 1, 1), 255, np.uint8)
    exact = layer(mesh, TransmittanceTexture(white, ior=(1.5, 1 / 1.5)))
    schlick = layer(mesh, TransmittanceTexture(white, f0=0.04))
    cosine = np.array([1.0, 0.8, 0.5, 0.1])
    d = np.stack([np.sqrt(1 - cosine**2), cosine, 0 * cosine], axis=1).astype(np.float32)
    where = np.zeros(4, np.int32), np.full(4, 0.2, np.float32), np.full(4, 0.3, np.float32), 3 * d
    entering = exact.at(*where, np.ones(4, bool))[:, 0]
    leaving = exact.at(*where, np.zeros(4, bool))[:, 0]
    # Snell's and Fresnel's laws in their usual form, by angles.
    theta = np.arccos(cosine[1:])
    refracted = np.arcsin(np.sin(theta) / 1.5)
    s = np.sin(theta - refracted) / np.sin(theta + refracted)
    p = np.tan(theta - refracted) / np.tan(theta + refracted)
    np.testing.assert_allclose(entering, [0.96, *(1 - (s**2 + p**2) / 2)], atol=1e-5)
    np.testing.assert_allclose(leaving[0], 0.96, atol=1e-5)
    assert leaving[2] == 0.0  # beyond the critical angle
    expected = 0.96 * (1 - (1 - cosine) ** 5)
    np.testing.assert_allclose(schlick.at(*where, np.ones(4, bool))[:, 1], expected, atol=1e-5)


def test_shadow_rays_keep_the_product_of_all_layers():
    rays = upward(500)
    expected = stepped(GREY) * stepped(RED) * stepped(BLUE)
    scene = stack([GREY, RED, BLUE])
    assert scene.transmits
    assert scene.coloured
    np.testing.assert_allclose(scene.transmittance(*rays), np.tile(expected, (500, 1)), rtol=1e-6)
    half = scene.transmittance(*rays, 0.0, np.float32(2.5))
    np.testing.assert_allclose(half, np.tile(stepped(GREY) * stepped(RED), (500, 1)), rtol=1e-6)
    assert not stack([GREY, None, BLUE]).transmittance(*rays).any()
    assert not stack([None, None]).transmits


def test_opaque_geometry_has_no_filter():
    mesh = square()
    scene = TriangleScene([(mesh.positions, mesh.triangles)])
    placed = InstanceScene([Instance(scene, np.eye(4))])
    assert not placed.transmits
    assert placed.intersect(*upward(10)).weight is None


@pytest.mark.parametrize("count", [1, 40], ids=["masks", "ids"])
def test_random_hits_have_the_mean_of_alpha_compositing(count):
    """Radiance 1, 2, 3 and 4 of four layers, the last opaque, seen from below."""
    n, colours = 200_000, [GREY, RED, BLUE]
    matrix = np.eye(4)
    matrix[:3, 3] = 5, 0, 0
    scene = stack([*colours, None])
    far = [Instance(scene, np.diag([1, 1, 1, 1.0]) + _shift(100 + k)) for k in range(count - 1)]
    placed = InstanceScene([Instance(scene, matrix), *far])
    origins, directions = upward(n)
    hits = placed.intersect(origins + np.float32([5, 0, 0]), directions)
    assert (hits.instance == 0).all()
    radiance = 1 + np.rint((hits.t * directions[:, 1]) - 1)
    assert hits.weight is not None
    actual = (radiance[:, None] * hits.weight).astype(np.float64)
    transmitted, expected = np.ones(3), np.zeros(3)
    for k, colour in enumerate([*colours, (0, 0, 0)]):
        expected += transmitted * (1 - stepped(colour)) * (k + 1)
        transmitted = transmitted * stepped(colour)
    error = actual.std(axis=0) / np.sqrt(n)
    assert (np.abs(actual.mean(axis=0) - expected) < 4 * error).all()
    assert (error < 0.01).all()
    again = placed.intersect(origins + np.float32([5, 0, 0]), directions)
    np.testing.assert_array_equal(again.weight, hits.weight)
    np.testing.assert_array_equal(again.t, hits.t)
    assert not placed.transmittance(origins + np.float32([5, 0, 0]), directions).any()
    start_instance = np.zeros(n, np.int32)
    assert (placed.intersect(origins, directions, start_instance).instance == -1).all()
    assert (placed.transmittance(origins, directions, start_instance=start_instance) == 1).all()


def _shift(x) -> np.ndarray:
    result = np.zeros((4, 4))
    result[0, 3] = x
    return result


def test_passing_is_not_the_same_for_rays_side_by_side():
    """The chance is of the very ray: neighbours agree no more often than strangers do."""
    placed = InstanceScene([Instance(stack([GREY]), np.eye(4))])
    passed = placed.intersect(*upward(100_000)).instance < 0
    agree = np.mean(passed[1:] == passed[:-1])
    p = stepped(GREY)[0]
    assert abs(passed.mean() - p) < 0.006
    assert abs(agree - (p * p + (1 - p) ** 2)) < 0.006


def test_strands_are_blocked_as_without_transmittance():
    curves = curls(60)
    clear = square(size=2.0)
    opaque, scene = PartsScene([curves]), PartsScene([curves, clear], [None, layer(clear, PANE)])
    rng = np.random.default_rng(3)
    segment = rng.integers(0, len(curves.segments()), 2000).astype(np.int32)
    x = curves.points[curves.segments()[segment]]
    d = rng.normal(size=(2000, 3)).astype(np.float32)
    at = FiberPoints(x, x, x, segment)
    free, transmitted = opaque.visible(0, at, d), scene.visible(0, at, d)
    assert 0.05 < free.mean() < 0.95
    t = -x[:, 1] / d[:, 1]
    through = (t > 0) & (np.abs(x + t[:, None] * d)[:, [0, 2]] < 2.0).all(axis=1)
    expected = np.where(through[:, None], stepped(RED), 1.0) * free[:, None]
    np.testing.assert_allclose(transmitted, expected, rtol=1e-6)
    assert 0.2 < through.mean() < 0.8


def test_rays_without_a_direction_meet_nothing():
    scene = stack([GREY])
    origins = np.float32([[0, -1, 0], [0, np.nan, 0]])
    assert (scene.transmittance(origins, np.zeros((2, 3), np.float32)) == 1).all()
    placed = InstanceScene([Instance(stack([RED]), np.eye(4))])
    hits = placed.intersect(origins, np.zeros((2, 3), np.float32))
    assert hits.instance.tolist() == [-1, -1]
    assert (hits.weight == 1).all()


def test_the_tables_live_as_long_as_the_scene():
    mesh = sphere(1)
    number = np.zeros(len(mesh.triangles), np.int32)

    def made() -> TriangleScene:
        uvs = np.zeros((len(mesh.positions), 2), np.float32)
        table = Transmittance(mesh.triangles, uvs, mesh.normals, number, [flat_texture(GREY)])
        return TriangleScene([(mesh.positions, mesh.triangles)], [table])

    scene = made()
    np.full(10**6, 255, np.uint8)  # memory that was let go would be written over
    before = scene.transmittance(np.float32([[0.1, -3, 0.2]]), np.float32([[0, 1, 0]]))
    np.testing.assert_allclose(before, stepped(GREY)[None] ** 2, rtol=1e-6)
