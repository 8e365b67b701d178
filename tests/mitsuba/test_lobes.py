"""Directions for rays that leave assets: the plugin's mixtures are those of rna-run."""

from __future__ import annotations

from rna_render.world.bodies import FIBER_LOBES, SURFACE_LOBES


def test_lobes_are_those_of_the_renderer() -> None:
    from rna_mitsuba import lobes

    surface = SURFACE_LOBES.uniform, SURFACE_LOBES.cosine, SURFACE_LOBES.mirror
    assert (lobes.UNIFORM, lobes.COSINE, lobes.MIRROR) == surface
    assert lobes.MIRROR_KAPPAS == SURFACE_LOBES.mirror_kappas
    assert lobes.MIRROR_PARTS == SURFACE_LOBES.mirror_parts
    fiber = FIBER_LOBES.uniform, FIBER_LOBES.cone, FIBER_LOBES.forward
    assert (lobes.FIBER_UNIFORM, lobes.CONE, lobes.FORWARD) == fiber
    widths = FIBER_LOBES.cone_scale, FIBER_LOBES.forward_kappa
    assert (lobes.CONE_SCALE, lobes.FORWARD_KAPPA) == widths
