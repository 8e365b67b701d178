"""Paths of light: camera, sampling, integrator, and bands of pixels."""
