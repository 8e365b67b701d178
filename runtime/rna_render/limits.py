"""Limits of a scene's whole numbers, for the scene file and the command line alike."""

MAX_PIXELS_A_SIDE = 32768
MAX_SAMPLES = 1 << 20
MAX_DEPTH = 1024
MAX_SEED = (1 << 32) - 1
MAX_FRAMES = 100_000
