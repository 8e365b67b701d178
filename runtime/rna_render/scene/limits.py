"""Limits of a scene's numbers, for the scene file, the command line and other files alike."""

from pathlib import Path

from rna_sdk.errors import SceneError

MAX_PIXELS_A_SIDE = 32768
MAX_SAMPLES = 1 << 20
MAX_DEPTH = 1024
MAX_SEED = (1 << 32) - 1
MAX_FRAMES = 100_000

# Of places, lengths and light: light and places are carried in float32, which holds their squares.
MAX_NUMBER = 1e18
MIN_LENGTH = 1e-18
# Of an object's size and scale. Embree calls a hit's barycentric coordinates 0 where the square of
# an edge over the scale is below some 1e-18, and rays miss where products of three lengths leave
# float32.
MIN_SIZE, MAX_SIZE = 1e-6, 1e6

# Of an image: 16384 x 8192. A few bytes of run-length code may stand for any number of pixels.
MAX_IMAGE_PIXELS = 1 << 27
# Of an EXR, the values of all channels of all parts: the decoder reads each of them.
MAX_IMAGE_VALUES = 1 << 29
# Radiance of more bytes than this, as float32 RGB, has to be at most so many times its file.
MAX_FREE_BYTES = 1 << 28
BYTES_A_TEXEL = 12
MAX_EXPANSION = 1024

# Of the mesh that a file becomes, with a copy for each node that shows a glTF mesh.
MAX_VERTICES = 1 << 26
MAX_TRIANGLES = 1 << 26
# Of a glTF accessor without data in the file: all zero, or sparse.
MAX_ZERO_ITEMS = 1 << 20

# Of a node of glTF, by EXT_mesh_gpu_instancing.
MAX_INSTANCES = 100_000

# Of a scene file: its parser takes some 10 us a byte.
MAX_SCENE_BYTES = 1 << 24

# Of a path in a scene file, bytes: PATH_MAX and NAME_MAX of Linux.
MAX_PATH_BYTES = 4095
MAX_NAME_BYTES = 255


def check_image_size(path: Path, width: int, height: int) -> None:
    """Raise SceneError if an image of that size is empty, too large, or too large for its file."""
    too_long = max(width, height) > MAX_PIXELS_A_SIDE or width * height > MAX_IMAGE_PIXELS
    if min(width, height) < 1 or too_long:
        raise SceneError(
            f"has {width} x {height} pixels; from 1 to {MAX_PIXELS_A_SIDE} a side, 2^27 in all",
            file=path,
        )
    size, stored = width * height * BYTES_A_TEXEL, path.stat().st_size
    if size > MAX_FREE_BYTES and size > MAX_EXPANSION * stored:
        raise SceneError(
            f"has {width} x {height} pixels in {stored} bytes; an image above {MAX_FREE_BYTES} "
            f"bytes of radiance is at most {MAX_EXPANSION} times its file",
            file=path,
        )
