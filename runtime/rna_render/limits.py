"""Limits of a scene's numbers, for the scene file, the command line and other files alike."""

MAX_PIXELS_A_SIDE = 32768
MAX_SAMPLES = 1 << 20
MAX_DEPTH = 1024
MAX_SEED = (1 << 32) - 1
MAX_FRAMES = 100_000

# Of places, lengths and light: light and places are carried in float32, which holds their squares.
MAX_NUMBER = 1e18
MIN_LENGTH = 1e-18
