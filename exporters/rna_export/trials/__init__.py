"""Trials: named models that are trained, exported and measured alike, to be compared."""
