"""Trials: named models, trained, exported and measured alike for comparison."""
