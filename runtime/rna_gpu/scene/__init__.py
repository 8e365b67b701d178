"""Scenes on the GPU: their tables, and the wavefront path tracer."""
