"""Environments for lobes: what is far brighter than its surroundings, and the rest, prefiltered."""
