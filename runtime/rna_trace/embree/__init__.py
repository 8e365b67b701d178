"""Embree 4: geometry, rays and filters; `tracing` has what the rest of the renderer calls."""

from rna_trace.embree.scenes import DiscScene, SphereScene, TriangleScene

__all__ = ["DiscScene", "SphereScene", "TriangleScene"]
