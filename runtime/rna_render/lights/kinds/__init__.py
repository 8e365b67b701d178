"""Lights, a file for each kind: its numbers, its samples, and its radiance where rays meet it."""
