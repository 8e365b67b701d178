"""What Cycles answers is the transport of the contract, and our normals and visibility fit it."""

import numpy as np
import pytest

from rna_export.capture.capture_settings import LEAST_ROUGHNESS
from tests.exporters.cycles import trace, unit

pytestmark = pytest.mark.blender
ALBEDO = np.array([0.9, 0.5, 0.1])
LIGHTS = [unit(0, 1, 0), unit(0.6, 0.7, -0.2), unit(-0.5, 0.4, 0.8)]

PLANE = "add(*square(1), diffuse((0.9, 0.5, 0.1)))"
FACETED_BALL = "add(*BALL, diffuse((0.9, 0.5, 0.1)))"
SMOOTH_BALL = "add(*BALL, diffuse((0.9, 0.5, 0.1)), smooth=True)"
STRETCHED = """
add(*BALL, diffuse((0.9, 0.5, 0.1)), smooth=True,
    matrix=Matrix.Rotation(0.8, 4, "X") @ Matrix.Diagonal((1, 2, 0.6, 1)))
"""
MIRRORED = SMOOTH_BALL.replace("smooth", "matrix=Matrix.Diagonal((-1, 1, 1.5, 1)), smooth")
# A black square over the plane: it casts a shadow and reflects nothing into it.
CASTER = PLANE + "\nadd(*square(0.4, x=0.2, y=0.3, z=0.3), diffuse((0, 0, 0)))"


@pytest.mark.parametrize(
    "scene",
    [PLANE, FACETED_BALL, SMOOTH_BALL, STRETCHED, MIRRORED],
    ids=["plane", "faceted", "smooth", "stretched", "mirrored"],
)
def test_a_diffuse_convex_body_answers_albedo_over_pi_times_the_cosine(open_worker, scene):
    worker = open_worker(scene)
    for wi in LIGHTS:
        traced = trace(worker, wi, 1024)
        cosine = traced.points.n @ wi
        # Towards grazing light Cycles moves the shadow's edge of smooth meshes on purpose.
        clear = traced.front & traced.visible & (cosine > 0.25)
        assert clear.sum() > 100
        expected = ALBEDO / np.pi * cosine[clear, None]
        assert np.abs(traced.radiance[clear] - expected).max() < 2e-4


def test_shadowed_points_are_black(open_worker):
    worker = open_worker(CASTER)
    for wi in LIGHTS:
        traced = trace(worker, wi)
        plane = traced.front & (traced.points.x[:, 1] < 0.1)
        shadowed = plane & ~traced.visible
        assert shadowed.sum() > 20
        assert np.median(traced.radiance[shadowed]) == 0.0
        lit = traced.radiance[:, 0] > 0.0
        agree = lit[plane] == traced.visible[plane]
        assert agree.mean() > 0.998  # the rest lies on the very edge


@pytest.mark.parametrize("scene", [SMOOTH_BALL, STRETCHED, MIRRORED])
def test_smooth_bodies_are_lit_up_to_where_cycles_lights_them(open_worker, scene):
    """Where light meets facets from behind, but the smooth surface from the front."""
    worker = open_worker(scene)
    lit, visible = [], []
    for wi in LIGHTS:
        traced = trace(worker, wi, 8192)
        behind = (traced.points.ng @ wi < 0.0) & (traced.points.n @ wi > 0.0)
        band = traced.front & behind
        lit.append(traced.radiance[band, 0] > 0.0)
        visible.append(traced.visible[band])
    assert len(np.concatenate(lit)) > 100
    assert (np.concatenate(lit) == np.concatenate(visible)).mean() > 0.99


def test_the_dark_side_of_a_closed_body_is_shadowed(open_worker):
    wi = LIGHTS[1]
    traced = trace(open_worker(FACETED_BALL), wi)
    facing = traced.points.ng @ wi
    clear = np.abs(facing) > 0.01
    assert np.array_equal(traced.visible[clear], facing[clear] > 0)
    assert not traced.radiance[facing < -0.01].any()


def test_more_paths_keep_the_mean(open_worker):
    worker = open_worker("add(*BALL, principled(Subsurface_Weight=1.0), smooth=True)")
    few, many = (trace(worker, LIGHTS[1], 1024, samples).radiance.mean() for samples in (8, 64))
    assert few == pytest.approx(many, rel=0.05)
    assert many > 0.05


METAL = """
metal = principled(Base_Color=(1.0, 1.0, 1.0, 1.0), Metallic=1.0, Roughness=%g)
add(*square(1), metal)
"""
LINKED = """
value = metal.node_tree.nodes.new("ShaderNodeValue")
value.outputs[0].default_value = 0.0
shader = metal.node_tree.nodes["Principled BSDF"]
metal.node_tree.links.new(value.outputs[0], shader.inputs["Roughness"])
"""


@pytest.mark.parametrize(
    ("scene", "roughness"),
    [(METAL % 0.1, 0.1), (METAL % 0.0, 0.035), (METAL % 0.5 + LINKED, 0.035)],
    ids=["smooth", "mirror", "mirror by a node"],
)
def test_the_highlight_of_a_metal_is_whole(open_worker, scene, roughness):
    """T = D F G / (4 n.wo) of GGX (Walter et al. 2007), hundreds at roughness 0.1.

    A mirror has none under a sun; captures give it the least roughness.
    """
    wi, alpha = LIGHTS[1], roughness**2
    traced = trace(open_worker(scene, least_roughness=LEAST_ROUGHNESS), wi, 8192)
    n, wo = traced.points.n[traced.front], -traced.rays.directions[traced.front]
    h = (wi + wo) / np.linalg.norm(wi + wo, axis=1, keepdims=True)
    ratio = np.sum(np.cross(n, h) ** 2, axis=1) + alpha**2 * np.sum(n * h, axis=1) ** 2
    expected = alpha**2 / np.pi / ratio**2 / (4.0 * np.sum(n * wo, axis=1))
    bright = expected > 20.0
    assert bright.sum() > 50 and expected.max() > 200.0
    found = traced.radiance[traced.front][bright, 0] / expected[bright]
    assert np.median(found) == pytest.approx(1.0, abs=0.02)
