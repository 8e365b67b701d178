"""Outcomes of a pre-flight: errors by material, highlights, outlines, the worst place."""
