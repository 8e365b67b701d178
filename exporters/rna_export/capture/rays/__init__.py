"""Rays and lights of a capture, and their hits."""
