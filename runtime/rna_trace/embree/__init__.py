"""Embree 4: geometry, rays and filters; `tracing` has the calls of the renderer."""

from rna_trace.embree.scenes import DiscScene, SphereScene, TriangleScene

__all__ = ["DiscScene", "SphereScene", "TriangleScene"]
