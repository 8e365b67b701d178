"""Blender in processes of its own: environment, protocol, workers."""
