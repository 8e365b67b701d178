"""Scenes on the GPU: tables of what they hold, and the wavefront path tracer."""
