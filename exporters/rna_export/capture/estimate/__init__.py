"""The predicted speedup of an asset in scenes, before its capture starts."""
